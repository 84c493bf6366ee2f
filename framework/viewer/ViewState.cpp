#include "viewer/ViewState.h"

#include <cmath>

#include <nlohmann/json.hpp>

#include "base/Error.h"

namespace radlab {

namespace {

using Json = nlohmann::json;

constexpr std::array<ToneCurve, 3> allCurves{ToneCurve::clamp, ToneCurve::reinhard, ToneCurve::filmic};
constexpr std::array<FormFactorMethod, 3> allMethods{FormFactorMethod::analytic, FormFactorMethod::hemicube,
                                                     FormFactorMethod::automatic};

Json jsonOf(const glm::vec3& v) { return {v.x, v.y, v.z}; }

glm::vec3 vectorIn(const Json& json, const char* name) {
    const auto v = json.at(name).get<std::array<float, 3>>();
    for (const float x : v)
        if (!std::isfinite(x)) throw Error(std::string(name) + ": expected finite numbers");
    return {v[0], v[1], v[2]};
}

float positive(const Json& json, const char* name) {
    const float value = json.at(name).get<float>();
    if (!(value > 0.0f) || !std::isfinite(value)) throw Error(std::string(name) + ": expected a number above 0");
    return value;
}

template <class Values>
typename Values::value_type named(const Values& values, const Json& json, const char* name) {
    const auto text = json.at(name).get<std::string>();
    for (const auto value : values)
        if (text == nameOf(value)) return value;
    throw Error(std::string(name) + ": unknown value '" + text + "'");
}

OrbitCamera cameraIn(const Json& json) {
    OrbitCamera camera;
    camera.position = vectorIn(json, "position");
    camera.direction = vectorIn(json, "direction");
    camera.up = vectorIn(json, "up");
    camera.pole = vectorIn(json, "pole");
    camera.distance = positive(json, "distance");
    camera.fieldOfView = positive(json, "field_of_view");
    const bool upright = std::abs(glm::dot(camera.direction, camera.up)) < 1e-3f;
    for (const glm::vec3& unit : {camera.direction, camera.up, camera.pole})
        if (!upright || std::abs(glm::length(unit) - 1.0f) > 1e-3f)
            throw Error("camera: expected unit vectors, direction and up at right angles");
    return camera;
}

ViewState read(const Json& json) {
    ViewState state;
    state.patchSize = positive(json, "patch_size");
    state.lightSize = positive(json, "light_size");
    state.hemicubeSize = json.at("hemicube_size").get<int>();
    if (state.hemicubeSize < 2 || state.hemicubeSize > 4096 || state.hemicubeSize % 2 != 0)
        throw Error("hemicube_size: expected an even number of 2 to 4096");
    state.method = named(allMethods, json, "method");
    state.mode = named(allModes, json, "mode");
    state.meshLines = json.at("mesh_lines").get<bool>();
    state.autoExposure = json.at("auto_exposure").get<bool>();
    state.exposure = positive(json, "exposure");
    state.curve = named(allCurves, json, "tone_curve");
    state.shotsPerFrame = std::max(0, json.at("shots_per_frame").get<int>());
    state.panel = json.at("panel").get<bool>();
    state.camera = cameraIn(json.at("camera"));
    return state;
}

}  // namespace

const char* nameOf(Mode mode) {
    static constexpr const char* names[] = {"wireframe", "flat", "smooth", "unshot power", "patch IDs", "form factors"};
    return names[static_cast<std::size_t>(mode)];
}

const char* nameOf(ToneCurve curve) {
    static constexpr const char* names[] = {"clamp", "Reinhard", "filmic"};
    return names[static_cast<std::size_t>(curve)];
}

const char* nameOf(FormFactorMethod method) {
    static constexpr const char* names[] = {"analytic", "hemicube", "auto"};
    return names[static_cast<std::size_t>(method)];
}

std::string toJson(const ViewState& state) {
    const OrbitCamera& camera = state.camera;
    const Json json = {{"patch_size", state.patchSize},
                       {"light_size", state.lightSize},
                       {"hemicube_size", state.hemicubeSize},
                       {"method", nameOf(state.method)},
                       {"mode", nameOf(state.mode)},
                       {"mesh_lines", state.meshLines},
                       {"auto_exposure", state.autoExposure},
                       {"exposure", state.exposure},
                       {"tone_curve", nameOf(state.curve)},
                       {"shots_per_frame", state.shotsPerFrame},
                       {"panel", state.panel},
                       {"camera",
                        {{"position", jsonOf(camera.position)},
                         {"direction", jsonOf(camera.direction)},
                         {"up", jsonOf(camera.up)},
                         {"pole", jsonOf(camera.pole)},
                         {"distance", camera.distance},
                         {"field_of_view", camera.fieldOfView}}}};
    return json.dump(1);
}

ViewState viewStateFrom(const std::string& json) {
    try {
        return read(Json::parse(json));
    } catch (const Json::exception& error) {
        throw Error(error.what());
    }
}

}  // namespace radlab

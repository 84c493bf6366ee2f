#include "viewer/SceneDrawing.h"

#include <algorithm>
#include <cmath>

#include "display/FalseColor.h"
#include "display/ToneMap.h"
#include "gl/Context.h"
#include "gl/Framebuffer.h"
#include "gl/IdPass.h"
#include "gl/SavedState.h"

namespace radlab {

namespace {

const glm::vec3 pickedColor(0.25f, 0.95f, 0.85f);
constexpr double unshotDecades = 4.0;

View viewOf(const Simulation& simulation, const ViewState& state, const Place& place) {
    View view;
    view.camera = state.camera.camera();
    view.width = place.width;
    view.height = place.height;
    view.samples = 1;
    view.background = toneMapped(simulation.scene().background, exposureOf(state), state.curve);
    return view;
}

void begin(const View& view, const Place& place) {
    setIdPassState();
    glViewport(place.x, place.y, place.width, place.height);
    glScissor(place.x, place.y, place.width, place.height);
    glEnable(GL_SCISSOR_TEST);
    glClearColor(view.background.r, view.background.g, view.background.b, 1.0f);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    setCamera(view);
    glShadeModel(GL_SMOOTH);
    glEnable(GL_CULL_FACE);
    glCullFace(GL_BACK);
}

double unshotPower(const MyPolygon& patch) {
    return static_cast<double>(length(patch.unshot_rad)) * static_cast<double>(patch.area);
}

std::vector<glm::vec3> colorsOf(const std::function<glm::vec3(const MyPolygon&)>& color) {
    std::vector<glm::vec3> colors;
    colors.reserve(polygons.size());
    for (const MyPolygon* patch : polygons) colors.push_back(color(*patch));
    return colors;
}

std::vector<glm::vec3> unshotColors() {
    double largest = 0.0;
    for (const MyPolygon* patch : polygons) largest = std::max(largest, unshotPower(*patch));
    return colorsOf([&](const MyPolygon& patch) { return unshotColor(unshotPower(patch), largest); });
}

std::vector<glm::vec3> formFactorColors(const Picked& picked) {
    if (picked.view) {
        std::vector<glm::vec3> colors;
        for (const float formFactor : picked.view->formFactors) colors.push_back(formFactorColor(formFactor));
        return colors;
    }
    return colorsOf([](const MyPolygon& patch) { return formFactorColor(patch.formF); });
}

std::vector<glm::vec3> unlitColors() {
    return colorsOf([](const MyPolygon& patch) { return toneMapped(unlitColor(patch), 1.0f); });
}

void smoothLines(float width) {
    glEnable(GL_LINE_SMOOTH);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glLineWidth(width);
    glDepthMask(GL_FALSE);
}

}  // namespace

glm::vec3 unshotColor(double power, double largest) {
    if (!(power > 0.0) || !(largest > 0.0)) return heatColor(0.0f);
    return heatColor(static_cast<float>(1.0 + std::log10(power / largest) / unshotDecades));
}

float exposureOf(const ViewState& state) {
    if (!state.autoExposure || polygons.empty()) return state.exposure;
    Image colors(static_cast<int>(polygons.size()), 1);
    for (std::size_t i = 0; i < polygons.size(); ++i) colors.data()[i] = polygons[i]->color;
    const float chosen = autoExposure(colors);
    return std::isfinite(chosen) && chosen > 0.0f ? chosen : 1.0f;
}

void SceneDrawing::rebuild() {
    arrays.emplace();
    forgetIds();
}

void SceneDrawing::colorByRadiance(const Simulation& simulation, const ViewState& state) {
    if (!simulation.hasColors()) return arrays->setColors(unlitColors());
    const float exposure = exposureOf(state);
    const auto mapped = [&](const glm::vec3& radiance) { return toneMapped(radiance, exposure, state.curve); };
    if (state.mode == Mode::flat)
        return arrays->setColors(colorsOf([&](const MyPolygon& patch) { return mapped(patch.color); }));
    std::vector<glm::vec3> ofVertices;
    ofVertices.reserve(vertices.size());
    for (const MyVertex* vertex : vertices) ofVertices.push_back(mapped(vertex->color));
    arrays->setColors(ofVertices, colorsOf([&](const MyPolygon& patch) {
                          glm::vec3 mean(0.0f);
                          for (int k = 0; k < patch.vertices; ++k)
                              mean += vertices[static_cast<std::size_t>(patch.vertex[k])]->color;
                          return mapped(mean / static_cast<float>(patch.vertices));
                      }));
}

void SceneDrawing::color(const Simulation& simulation, const ViewState& state, const Picked& picked) {
    switch (state.mode) {
        case Mode::wireframe: return arrays->setColors(unlitColors());
        case Mode::flat:
        case Mode::smooth: return colorByRadiance(simulation, state);
        case Mode::unshot: return arrays->setColors(unshotColors());
        case Mode::formFactors: return arrays->setColors(formFactorColors(picked));
        case Mode::ids: return;
    }
}

void SceneDrawing::showIds(const View& view, const Place& place, const std::function<void()>& drawIds) {
    const Camera& c = view.camera;
    const std::vector<float> key = {c.position.x,       c.position.y, c.position.z, c.direction.x, c.direction.y,
                                    c.direction.z,      c.up.x,       c.up.y,       c.up.z,        float(place.width),
                                    float(place.height)};
    if (key != idKey) {
        std::vector<glm::vec3> colors;
        for (std::size_t id = 0; id <= polygons.size(); ++id) colors.push_back(idColor(id));
        const std::vector<std::uint32_t> ids = readIds(view, drawIds);
        idPixels.clear();
        for (const std::uint32_t id : ids) {
            const glm::vec3 color = 255.0f * (id < colors.size() ? colors[id] : glm::vec3(1.0f, 0.0f, 1.0f));
            for (int k = 0; k < 3; ++k) idPixels.push_back(static_cast<std::uint8_t>(std::lround(color[k])));
            idPixels.push_back(255);
        }
        idKey = key;
    }
    for (const GLenum matrix : {GL_PROJECTION, GL_MODELVIEW}) {
        glMatrixMode(matrix);
        glLoadIdentity();
    }
    glDisable(GL_DEPTH_TEST);
    glRasterPos2f(-1.0f, -1.0f);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
    glDrawPixels(place.width, place.height, GL_RGBA, GL_UNSIGNED_BYTE, idPixels.data());
    glEnable(GL_DEPTH_TEST);
    setCamera(view);
}

void SceneDrawing::showPatches(const ViewState& state, const Picked& picked) {
    const bool lines = state.meshLines || state.mode == Mode::wireframe;
    if (state.mode != Mode::ids) {
        if (lines) glEnable(GL_POLYGON_OFFSET_FILL);
        glPolygonOffset(1.0f, 2.0f);
        arrays->draw();
    }
    glDisable(GL_CULL_FACE);
    if (lines) {
        smoothLines(1.0f);
        glColor4f(0.02f, 0.03f, 0.05f, state.mode == Mode::wireframe ? 0.9f : 0.45f);
        arrays->drawOutlines();
    }
    if (!picked.patch || *picked.patch >= arrays->patchCount()) return;
    glDisable(GL_DEPTH_TEST);
    smoothLines(2.5f);
    glColor4f(pickedColor.r, pickedColor.g, pickedColor.b, 1.0f);
    arrays->drawOutline(*picked.patch);
}

void SceneDrawing::draw(const Simulation& simulation, const ViewState& state, const Picked& picked, const Place& place,
                        const std::function<void()>& drawIds) {
    RADLAB_CHECK(arrays.has_value());
    const SavedState saved;
    const View view = viewOf(simulation, state, place);
    color(simulation, state, picked);
    begin(view, place);
    if (state.mode == Mode::ids) showIds(view, place, drawIds);
    showPatches(state, picked);
    while (glGetError() != GL_NO_ERROR) ++errors;  // the saved state would hide them
}

std::optional<std::size_t> SceneDrawing::pick(const Simulation& simulation, const ViewState& state, const Place& place,
                                              int x, int y) {
    if (x < 0 || y < 0 || x >= place.width || y >= place.height) return std::nullopt;
    const Place whole{0, 0, place.width, place.height};
    const std::vector<std::uint32_t> ids = readIds(viewOf(simulation, state, whole), [&] {
        glScissor(x, y, 1, 1);
        glEnable(GL_SCISSOR_TEST);
        glEnable(GL_CULL_FACE);
        glCullFace(GL_BACK);
        arrays->setIdColors();
        arrays->draw();
    });
    const std::uint32_t id = ids[static_cast<std::size_t>(y * place.width + x)];
    if (id == 0) return std::nullopt;
    return id - 1;
}

Image readPlace(const Place& place) {
    std::vector<std::uint8_t> bytes(std::size_t{3} * static_cast<std::size_t>(place.width * place.height));
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(place.x, place.y, place.width, place.height, GL_RGB, GL_UNSIGNED_BYTE, bytes.data());
    Image image(place.width, place.height);
    for (int y = 0; y < place.height; ++y)
        for (int x = 0; x < place.width; ++x) {
            const std::uint8_t* pixel = &bytes[std::size_t{3} * static_cast<std::size_t>(y * place.width + x)];
            image.at(x, place.height - 1 - y) = glm::vec3(pixel[0], pixel[1], pixel[2]) / 255.0f;
        }
    return image;
}

Image drawnPicture(SceneDrawing& drawing, const Simulation& simulation, const ViewState& state, const Picked& picked,
                   int width, int height, const std::function<void()>& drawIds) {
    const SavedState saved;
    const Framebuffer framebuffer(width, height, Framebuffer::Color::bytes);
    framebuffer.bind();
    const Place place{0, 0, width, height};
    drawing.draw(simulation, state, picked, place, drawIds);
    framebuffer.bind();
    return readPlace(place);
}

}  // namespace radlab

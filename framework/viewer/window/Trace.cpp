#include "viewer/window/Trace.h"

#include <cmath>

#include <nlohmann/json.hpp>

#include "base/WholeFile.h"

namespace radlab {

namespace {

constexpr double leastSeconds = 0.03;

nlohmann::json jsonOf(const ImVec4& r) { return {r.x, r.y, r.z, r.w}; }

nlohmann::json traced(Ui& ui, const ImVec4& picture, int glErrors, bool settled) {
    Viewer& viewer = ui.viewer;
    const ImGuiIO& io = ImGui::GetIO();
    nlohmann::json json = {{"mode", nameOf(viewer.state().mode)},
                           {"shots", viewer.simulation().progress().shots},
                           {"unshot_share", viewer.simulation().progress().unshotShare},
                           {"patches", viewer.simulation().mesh().patches.size()},
                           {"method", nameOf(viewer.simulation().method())},
                           {"playing", viewer.isPlaying()},
                           {"building", viewer.isBuilding()},
                           {"can_run", viewer.canRun()},
                           {"reloads", viewer.reloads()},
                           {"scene", viewer.sceneFile().string()},
                           {"help", viewer.helpShown()},
                           {"gl_errors", glErrors},
                           {"settled", settled},
                           {"mouse", {io.MousePos.x, io.MousePos.y}},
                           {"mouse_down", io.MouseDown[0] || io.MouseDown[1] || io.MouseDown[2]},
                           {"picture", jsonOf(picture)},
                           {"picked", nullptr},
                           {"sum", nullptr},
                           {"banners", nlohmann::json::array()},
                           {"buttons", nlohmann::json::object()},
                           {"state", nlohmann::json::parse(toJson(viewer.state()))}};
    if (viewer.picked().patch) json["picked"] = *viewer.picked().patch;
    if (viewer.picked().view) json["sum"] = viewer.picked().view->sum;
    for (const Banner& banner : viewer.banners())
        json["banners"].push_back({{"title", banner.title}, {"text", banner.text}});
    for (const auto& [name, place] : ui.rectangles) json["buttons"][name] = jsonOf(place);
    return json;
}

}  // namespace

void Trace::write(Ui& ui, const ImVec4& picture, int glErrors, bool settled) {
    if (target.empty() || (!first && ui.viewer.isPlaying() && sinceWrite.seconds() < leastSeconds)) return;
    nlohmann::json json = traced(ui, picture, glErrors, settled);
    const std::string text = json.dump();
    if (text == before) return;
    before = text;
    first = false;
    sinceWrite.restart();
    json["fps"] = std::round(ui.framesPerSecond);
    writeFile(target, json.dump(1));
}

}  // namespace radlab

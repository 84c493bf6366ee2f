// Holds a screenshot of the viewer against the picture that its trace tells of, drawn here without a display.

#include <iostream>

#include <nlohmann/json.hpp>

#include "apps/CommandLine.h"
#include "base/ImageFile.h"
#include "base/WholeFile.h"
#include "gl/Context.h"
#include "scene/X3dReader.h"
#include "viewer/SceneDrawing.h"

namespace {

radlab::Image pictureOf(const nlohmann::json& trace, int width, int height) {
    const radlab::ViewState state = radlab::viewStateFrom(trace.at("state").dump());
    radlab::RunningNow running;
    radlab::Simulation simulation(radlab::readX3d(trace.at("scene").get<std::string>()), running);
    simulation.setFunctions(radlab::linkedFunctions());
    simulation.cut(state);
    if (const int shots = trace.at("shots").get<int>(); shots > 0) simulation.shoot(shots, 1e9);
    radlab::Picked picked;
    if (!trace.at("picked").is_null()) {
        picked.patch = trace.at("picked").get<std::size_t>();
        picked.view = simulation.lookFrom(*picked.patch);
    }
    radlab::SceneDrawing drawing;
    drawing.rebuild();
    return radlab::drawnPicture(drawing, simulation, state, picked, width, height,
                                radlab::linkedFunctions().renderPatchIDs);
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app("Draws the picture that a viewer's trace tells of and holds a screenshot against it.");
    std::string trace, screenshot, out;
    double most = 0.01;
    app.add_option("TRACE", trace, "What the viewer wrote for --trace")->required();
    app.add_option("SCREENSHOT", screenshot, "The picture to hold against it")->required();
    app.add_option("--out", out, "Write the picture that was expected to this file");
    app.add_option("--most", most, "Largest root mean square difference that is right")->capture_default_str();
    return radlab::runCommandLine(app, argc, argv, [&] {
        const auto context = radlab::GlContext::offscreen();
        const radlab::Image shown = radlab::readImage(screenshot);
        const radlab::Image expected =
            pictureOf(nlohmann::json::parse(radlab::readFile(trace)), shown.width(), shown.height());
        if (!out.empty()) radlab::writeImage(out, expected);
        const double difference = radlab::rmsDifference(shown, expected);
        double brightest = 0.0;
        for (const glm::vec3& pixel : expected.data()) brightest = std::max(brightest, double(pixel.g));
        std::cout << "rms difference " << difference << ", brightest " << brightest << '\n';
        return difference <= most && brightest > 0.1 ? 0 : 1;
    });
}

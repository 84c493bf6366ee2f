// Which effects a scene calls for, why, and what they are expected to cost.

#include <cstdio>
#include <iostream>

#include <nlohmann/json.hpp>

#include "apps/CommandLine.h"
#include "apps/FormFactorRun.h"
#include "base/Interrupts.h"
#include "base/Memory.h"
#include "base/ProgressBar.h"
#include "engine/Cost.h"

namespace {

using namespace radlab;
using namespace radlab::engine;

struct Flags {
    SceneFlags scene;
    FormFactorFlags formFactors;
    bool json = false;
};

std::string secondsText(double seconds) {
    char text[32];
    std::snprintf(text, sizeof text, seconds < 0.01 ? "%.1g s" : seconds < 100.0 ? "%.2g s" : "%.0f s", seconds);
    return text;
}

std::string stateOf(const Decision& decision) {
    return std::string(decision.on ? "on" : "off") + (decision.forced ? ", forced" : "");
}

void printTable(const SceneInput& input, const Work& work) {
    std::cout << input.summary << '\n';
    for (const Effect effect : allEffects) {
        const Decision& decision = input.effects[effect];
        char start[100];
        std::snprintf(start, sizeof start, "%-13s %-12s %s %-9s ", nameOf(effect), stateOf(decision).c_str(),
                      decision.on ? "costs" : "saves", secondsText(costOf(effect, work, input.effects)).c_str());
        std::cout << start << decision.reason << '\n';
    }
    const Cost cost = expectedCost(work, input.effects);
    std::cout << "expected: form factors " << secondsText(cost.formFactors)
              << (cost.specular > 0.0 ? ", light over specular faces " + secondsText(cost.specular) : "")
              << ", radiosities " << secondsText(cost.radiosities) << ", picture " << secondsText(cost.picture) << "; "
              << bytesText(cost.bytes) << '\n';
}

nlohmann::ordered_json jsonOf(Effect effect, const Effects& effects, const Work& work) {
    const Decision& decision = effects[effect];
    return {{"name", nameOf(effect)},    {"on", decision.on},
            {"needed", decision.needed}, {"forced", decision.forced},
            {"reason", decision.reason}, {decision.on ? "seconds" : "secondsSaved", costOf(effect, work, effects)}};
}

void printJson(const SceneInput& input, const Work& work) {
    const Cost cost = expectedCost(work, input.effects);
    const Channels channels = input.effects.channels();
    nlohmann::ordered_json solved = nlohmann::json::array(), effects = nlohmann::json::array();
    for (int c = 0; c < 3; ++c)
        if (channels.solved(c)) solved.push_back(nameOfChannel(c));
    for (const Effect effect : allEffects) effects.push_back(jsonOf(effect, input.effects, work));
    const nlohmann::ordered_json plan = {{"schema", "radlab/plan/1"},
                                         {"file", input.scene.file},
                                         {"faces", input.scene.faces.size()},
                                         {"patches", work.patches},
                                         {"channels", solved},
                                         {"specularOntoDiffuse", input.effects.specularOntoDiffuse},
                                         {"effects", effects},
                                         {"cost",
                                          {{"formFactorSeconds", cost.formFactors},
                                           {"specularSeconds", cost.specular},
                                           {"radiositySeconds", cost.radiosities},
                                           {"pictureSeconds", cost.picture},
                                           {"pixels", work.pixels},
                                           {"bytes", cost.bytes}}}};
    std::cout << plan.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) << '\n';
}

int plan(const Flags& flags) {
    const Interrupts interrupts;
    const FormFactorOptions options = optionsOf(flags.formFactors);
    const SceneInput input = readSceneInput(flags.scene);
    const Work work = shownAs("counting work", [&] { return workOf(input.scene, input.geometry, options); });
    if (flags.json)
        printJson(input, work);
    else
        printTable(input, work);
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app("Says which effects a scene calls for, why, and what they are expected to cost.");
    Flags flags;
    addSceneFlags(app, flags.scene);
    addFormFactorFlags(app, flags.formFactors);
    app.add_flag("--json", flags.json, "The plan as JSON, for programs");
    app.footer("Example: ./radlab plan resources/scenes/cornell_2.x3d --force occlusion=off");
    return radlab::runCommandLine(app, argc, argv, [&] { return plan(flags); });
}

// What it saves to simulate only the effects that a scene calls for, scene by scene.

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <iostream>

#include "apps/CommandLine.h"
#include "apps/EffectRun.h"
#include "base/ProgressBar.h"

namespace {

using namespace radlab;

struct Flags {
    std::vector<std::string> scenes;
    double patches = 1000.0;
    int repeat = 3;
};

// The run whose time is the middle one.
double medianSeconds(const std::string& scene, const Flags& flags, const std::vector<std::string>& force) {
    std::vector<double> seconds;
    for (int i = 0; i < flags.repeat; ++i) seconds.push_back(EffectRun(scene, flags.patches, force).seconds);
    std::sort(seconds.begin(), seconds.end());
    return seconds[seconds.size() / 2];
}

std::vector<std::string> unneededOf(const std::string& scene, const Flags& flags) {
    std::vector<std::string> unneeded;
    const EffectRun run(scene, flags.patches, {});
    for (const Effect effect : allEffects)
        if (!run.input.effects[effect].needed) unneeded.push_back(nameOf(effect));
    return unneeded;
}

void printRow(const std::string& scene, const std::string& forced, double planned, double seconds) {
    char text[200];
    std::snprintf(text, sizeof text, "| %-14s | %-48s | %8.3f | %7.3f | %5.2f |",
                  std::filesystem::path(scene).stem().c_str(), forced.c_str(), planned, seconds, seconds / planned);
    std::cout << text << std::endl;
}

void measure(const std::string& scene, const Flags& flags) {
    const std::vector<std::string> unneeded = unneededOf(scene, flags);
    const double planned = medianSeconds(scene, flags, {});
    std::vector<std::string> all;
    std::string names;
    for (const std::string& effect : unneeded) {
        printRow(scene, effect, planned, medianSeconds(scene, flags, {effect + "=on"}));
        all.push_back(effect + "=on");
        names += (names.empty() ? "" : ", ") + effect;
    }
    if (all.empty()) printRow(scene, "all effects are needed", planned, planned);
    if (all.size() > 1) printRow(scene, names, planned, medianSeconds(scene, flags, all));
}

int run(Flags flags) {
    if (flags.scenes.empty()) flags.scenes = projectScenes();
    std::cout
        << "| scene          | forced on, though not needed                     | as it is | forced, s | times |\n"
           "| -------------- | ------------------------------------------------ | -------- | ------- | ----- |\n";
    ProgressBar bar("effects", static_cast<double>(flags.scenes.size()), "scenes");
    for (std::size_t i = 0; i < flags.scenes.size(); ++i) {
        bar.show(static_cast<double>(i));
        measure(flags.scenes[i], flags);
    }
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app("Times every scene as planned, and with effects forced on that it does not call for.");
    Flags flags;
    app.add_option("SCENE", flags.scenes, "X3D files; else all scenes of the project");
    app.add_option("--patches", flags.patches, "About how many patches")
        ->capture_default_str()
        ->check(CLI::Range(10, 20000));
    app.add_option("--repeat", flags.repeat, "Runs of each, of which the middle one counts")
        ->capture_default_str()
        ->check(CLI::Range(1, 99));
    return radlab::runCommandLine(app, argc, argv, [&] { return run(flags); });
}

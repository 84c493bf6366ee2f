// What accuracy costs in time: every method over its settings, measured against references.

#include <iostream>
#include <memory>
#include <set>

#include "apps/CommandLine.h"
#include "base/Error.h"
#include "base/Interrupts.h"
#include "base/ProgressBar.h"
#include "base/Stopwatch.h"
#include "base/Warning.h"
#include "base/WholeFile.h"
#include "gl/Context.h"
#include "study/StudyPage.h"

namespace {

using namespace radlab;
using namespace radlab::study;

struct Flags {
    std::vector<std::string> scenes;
    std::string out = "out/study";
    bool quick = false, fresh = false;
    std::size_t patches = 0, repeats = 0;
    double limit = 0.0;
};

std::vector<std::string> usualScenes() {
    std::vector<std::string> files;
    for (const char* name : {"cornell_1", "cornell_2", "l_room", "grey_room"})
        files.push_back(RADLAB_SOURCE_DIR "/resources/scenes/" + std::string(name) + ".x3d");
    return files;
}

StudyPlan planOf(const Flags& flags) {
    StudyPlan plan = flags.patches > 0 ? smallPlan(flags.patches) : flags.quick ? quickPlan() : fullPlan();
    if (flags.repeats > 0) plan.repeats = flags.repeats;
    if (flags.limit > 0.0) plan.limit = flags.limit;
    return plan;
}

std::vector<StudiedScene> readScenes(const std::vector<std::string>& files) {
    std::vector<StudiedScene> scenes;
    std::set<std::string> names;
    for (const std::string& file : files) {
        scenes.push_back({readStudyScene(file), {}});
        if (!names.insert(scenes.back().scene.name).second)
            throw Error({file}, "found two scenes named '" + scenes.back().scene.name + "', expected different names");
    }
    return scenes;
}

std::unique_ptr<GlContext> openGlIfAny() {
    try {
        return GlContext::offscreen();
    } catch (const Error& none) {
        warn(std::string("the course's hemicube is left out: ") + none.what());
        return nullptr;
    }
}

void tell(const StudiedScene& studied) {
    const SceneReport& report = studied.report;
    std::cout << studied.scene.name << ": " << report.measured << " settings measured, " << report.kept
              << " kept as they were, " << report.notes.size() << " left out\n";
    for (const std::string& note : report.notes) std::cout << "  " << note << '\n';
    std::cout << std::flush;
}

// Studies one scene after the other until Ctrl-C; those that were not begun are dropped.
void studyAll(std::vector<StudiedScene>& scenes, const StudyPlan& plan, bool openGl,
              const std::filesystem::path& folder, StudyResults& results) {
    std::size_t begun = 0;
    for (StudiedScene& studied : scenes) {
        if (Interrupts::caught()) break;
        studied.report = studyScene(studied.scene, plan, openGl, folder, results);
        tell(studied);
        if (studied.report.measured + studied.report.kept > 0) ++begun;
    }
    scenes.erase(scenes.begin() + static_cast<std::ptrdiff_t>(begun), scenes.end());
}

int makeStudy(const Flags& flags) {
    const Interrupts interrupts;
    const Stopwatch watch;
    const StudyPlan plan = planOf(flags);
    std::vector<StudiedScene> scenes = readScenes(flags.scenes.empty() ? usualScenes() : flags.scenes);
    const std::filesystem::path folder = flags.out;
    StudyResults results(folder / "results.csv", flags.fresh);
    makeFolder(folder);
    const auto context = openGlIfAny();
    studyAll(scenes, plan, context != nullptr, folder, results);
    if (scenes.empty()) Interrupts::check();
    Interrupts::answer();
    const std::filesystem::path page = writeStudy(folder, plan, scenes, results);
    const bool stopped = Interrupts::caught();
    std::cout << (stopped ? "stopped by Ctrl-C after " : "done in ") << durationText(watch.seconds()) << ": open "
              << page.string() << (stopped ? "; the same command goes on" : "") << '\n';
    return stopped ? 130 : 0;
}

void describe(CLI::App& app, Flags& flags) {
    app.add_option("SCENE", flags.scenes, "X3D files; else four of the project's scenes");
    app.add_flag("--quick", flags.quick, "Few settings, small meshes, each measured once: under a minute");
    app.add_option("--out", flags.out, "Folder to write to, made where it does not exist")->capture_default_str();
    app.add_option("--repeat", flags.repeats, "How often each setting is measured, the median kept; else 3, --quick: 1")
        ->check(CLI::Range(1, 1000));
    app.add_option("--limit", flags.limit,
                   "Seconds: settings expected to take longer are left out; else 20, --quick: 1.5")
        ->check(CLI::PositiveNumber);
    app.add_flag("--fresh", flags.fresh, "Measure everything anew, and drop what is there of older results");
    app.add_option("--patches", flags.patches, "One mesh of about so many patches")
        ->check(CLI::Range(10, 100000))
        ->group("");  // for tests
    app.footer(
        "Example: ./radlab study --quick\n         ./radlab study resources/scenes/cornell_2.x3d --repeat 5\n"
        "What has been measured is kept: the same command goes on where it was stopped.");
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app("Shows what accuracy costs in time: all methods over their settings, against references.");
    Flags flags;
    describe(app, flags);
    return radlab::runCommandLine(app, argc, argv, [&] { return makeStudy(flags); });
}

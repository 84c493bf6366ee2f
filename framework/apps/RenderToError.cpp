#include "apps/RenderToError.h"

#include "base/ProgressBar.h"
#include "base/Warning.h"
#include "engine/SolveToError.h"

namespace radlab {

using namespace engine;

namespace {

// 0.0123 as "1.23 %".
std::string percent(double share) {
    char text[32];
    std::snprintf(text, sizeof text, "%.3g %%", 100.0 * share);
    return text;
}

std::string describe(const AccurateSolution& solution, double asked, bool meshChosen) {
    char seconds[32];
    std::snprintf(seconds, sizeof seconds, "%.3g s", solution.seconds);
    return std::string(solution.stopped ? "stopped by Ctrl-C: this is the last try that was finished\n" : "") +
           "chosen: " + engine::describe(solution.way) + "; " + std::to_string(solution.geometry.patches.size()) +
           " patches\nestimated error: " + percent(solution.error) + ", asked for: " + percent(asked) + " (patches " +
           percent(solution.meshError) + (meshChosen ? "" : ", not counted as their size was given") + ", solution " +
           percent(solution.solverError) + ", times a margin); " + seconds;
}

}  // namespace

RenderSolution solveToError(SceneInput& input, double error, double patchSize) {
    ErrorGoal goal;
    goal.error = error;
    goal.patchSize = patchSize;
    ProgressBar bar("solving", mostTries, "tries");
    goal.progress = [&](double tries, const std::string& what) { bar.show(tries, what); };
    AccurateSolution solution = engine::solveToError(input.scene, input.effects, goal);
    if (!solution.reached && !solution.stopped)
        warn(input.scene.file + ": an error of " + percent(error) + " was asked for, and " + percent(solution.error) +
             " was reached: expected a larger --error, or smaller patches by --patch-size");
    RenderSolution made{
        solution.surfaces, solution.radiosity, {}, Point(0.0), {}, describe(solution, error, patchSize == 0.0)};
    input.mesh = std::move(solution.mesh);
    input.geometry = std::move(solution.geometry);
    return made;
}

}  // namespace radlab

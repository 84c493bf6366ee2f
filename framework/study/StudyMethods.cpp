#include "study/StudyMethods.h"

#include <cmath>
#include <cstdio>

#include "base/Error.h"
#include "base/Interrupts.h"
#include "engine/FormFactorRows.h"
#include "engine/FormFactors.h"
#include "engine/HierarchicalRadiosity.h"
#include "engine/PathTracer.h"
#include "engine/Shooting.h"
#include "solver/FormFactors.h"
#include "study/Wording.h"

namespace radlab::study {

using namespace engine;

namespace {

constexpr double allButUnshot = 1e-4;  // of the engine's shooting, where it is to go to the end
constexpr double courseUnshot = 1e-3;  // of the course's loop
constexpr int mostShotsOfAPatch = 40;  // 6 or so are usual
constexpr int courseSize = 128;        // of the hemicube where shots are what varies

std::size_t countOf(double level) { return static_cast<std::size_t>(level); }

// Sets the option that a level turns.
using Turn = std::function<void(FormFactorOptions& options, double level)>;

void turnNothing(FormFactorOptions&, double) {}
void turnRays(FormFactorOptions& options, double level) { options.rays = countOf(level); }
void turnSize(FormFactorOptions& options, double level) { options.hemicubeSize = static_cast<int>(level); }

std::function<Outcome(StudyMesh&, double)> byFormFactors(Method method, const Turn& turn) {
    return [=](StudyMesh& mesh, double level) {
        FormFactorOptions options;
        options.method = method;
        options.occlusion = mesh.occlusion;
        turn(options, level);
        FormFactorMatrix matrix = formFactors(mesh.geometry, options);
        if (!isReciprocal(method)) makeReciprocal(matrix);
        return Outcome{solveRadiosity(matrix, mesh.surfaces)};
    };
}

Outcome byLinks(StudyMesh& mesh, double level) {
    HierarchicalOptions options;
    options.threshold = 1.0 / level;
    options.occlusion = mesh.occlusion;
    return {solveHierarchical(mesh.geometry, mesh.surfaces, options)};
}

std::function<Outcome(StudyMesh&, double)> byShots(bool ambient) {
    return [=](StudyMesh& mesh, double level) {
        FormFactorOptions factors;
        factors.occlusion = mesh.occlusion;
        const FormFactorRows rows(mesh.geometry, factors);
        ShootingOptions options;
        options.unshot = level == everything ? allButUnshot : 0.0;
        if (level != everything) options.mostShots = countOf(level);
        ShootingReport report;
        Outcome outcome;
        outcome.radiosity = shootRadiosity(
            areasOf(mesh.geometry), mesh.surfaces, [&](std::size_t i, double* row) { rows.row(i, row); }, options,
            &report);
        outcome.shots = report.shots;
        if (ambient) addAmbient(outcome.radiosity, mesh.surfaces, report.ambient);
        return outcome;
    };
}

std::function<Outcome(StudyMesh&, double)> byPaths(bool constantPatches) {
    return [=](StudyMesh& mesh, double level) {
        PathRadiosityOptions options;
        options.samples = countOf(level);
        options.constantPatches = constantPatches;
        return Outcome{pathTraceRadiosity(mesh.traced(), options).radiosity};
    };
}

Outcome byCourse(StudyMesh& mesh, FormFactorMethod method, int hemicubeSize, const Limits& limits) {
    Progressive solver(mesh.mesh, formFactorsBy(method, hemicubeSize));
    Outcome outcome;
    outcome.shots = static_cast<std::size_t>(
        solver.run(limits, [](const radlab::Progress&) { return !Interrupts::caught(); }).shots);
    for (const MyPolygon& patch : mesh.mesh.patches) outcome.radiosity.emplace_back(patch.rad);
    return outcome;
}

// Until little is unshot. Rows that add up to more than 1 may make light without end.
Outcome byCourse(StudyMesh& mesh, FormFactorMethod method, int hemicubeSize) {
    Limits limits;
    limits.unshotShare = courseUnshot;
    limits.shots = mostShotsOfAPatch * static_cast<int>(mesh.mesh.patches.size());
    Outcome outcome = byCourse(mesh, method, hemicubeSize, limits);
    if (outcome.shots == static_cast<std::size_t>(limits.shots))
        throw Error("after " + std::to_string(limits.shots) + " shots there is still light to shoot");
    return outcome;
}

Outcome byCourseFormula(StudyMesh& mesh, double) { return byCourse(mesh, FormFactorMethod::analytic, 0); }

Outcome byCourseHemicube(StudyMesh& mesh, double level) {
    return byCourse(mesh, FormFactorMethod::hemicube, static_cast<int>(level));
}

Outcome byCourseShots(StudyMesh& mesh, double level) {
    return byCourse(mesh, FormFactorMethod::hemicube, courseSize,
                    {.shots = static_cast<int>(level), .unshotShare = 0.0});
}

std::vector<double> powers(double from, double to, double factor) {
    std::vector<double> levels;
    for (double level = from; level < to * 1.001; level *= factor) levels.push_back(level);
    return levels;
}

std::vector<double> shotLevels(double most) {
    std::vector<double> levels = powers(8, most, 4);
    levels.push_back(everything);
    return levels;
}

}  // namespace

std::vector<StudyMethod> studyMethods(bool occlusion) {
    const std::vector<double> one = {1};
    std::vector<StudyMethod> methods = {
        {"point", "", one, one, 1, {1, 2}, byFormFactors(Method::point, turnNothing)},
        {"polygon", "", one, one, 1, {1, 2}, byFormFactors(Method::polygon, turnNothing)},
        {"exact", "", one, one, 1, {1, 2}, byFormFactors(Method::exact, turnNothing)},
        {"visibility", "rays", powers(16, 1024, 2), {16, 64}, 64, {1, 2}, byFormFactors(Method::visibility, turnRays)},
        {"hemisphere",
         "rays",
         powers(16, 65536, 4),
         {64, 1024},
         4096,
         {1, 1.2},
         byFormFactors(Method::hemisphere, turnRays)},
        {"hemicube",
         "size",
         powers(16, 2048, 2),
         {32, 128},
         256,
         {0.5, 1.5},
         byFormFactors(Method::hemicube, turnSize)},
        {"hierarchical", "threshold", powers(1e1, 1e6, 10), {1e2, 1e4}, 1e5, {0.5, 1.1}, byLinks},
        {"shooting", "shots", shotLevels(2048), {8, 128, everything}, everything, {1, 2.5}, byShots(false)},
        {"shooting + ambient", "shots", shotLevels(2048), {8, 128}, 0, {1, 2.5}, byShots(true)},
        {"paths", "paths", powers(32, 4096, 2), {32, 256}, 256, {1, 1.1}, byPaths(true), byPaths(false)},
        {"course formula", "", one, one, 1, {1, 2}, byCourseFormula},
        {"course hemicube", "size", powers(16, 512, 2), {16, 64}, 128, {0.5, 2}, byCourseHemicube, {}, true},
        {"course by shots", "shots", powers(8, 2048, 4), {8, 128}, 0, {1, 1}, byCourseShots, {}, true},
    };
    const std::string leftOut = occlusion ? "exact" : "visibility";
    std::erase_if(methods, [&](const StudyMethod& method) { return method.name == leftOut; });
    return methods;
}

std::string settingName(const StudyMethod& method, double level) {
    if (method.unit.empty()) return "";
    if (level == everything) return "all " + method.unit;
    if (method.unit == "threshold") {
        char text[32];
        std::snprintf(text, sizeof text, "threshold 1e-%.0f", std::log10(level));
        return text;
    }
    return method.unit == "size" ? "size " + countText(level) : countText(level) + " " + method.unit;
}

}  // namespace radlab::study

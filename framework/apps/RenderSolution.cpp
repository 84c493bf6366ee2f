#include "apps/RenderSolution.h"

#include "apps/FormFactorRun.h"
#include "apps/SpecularPart.h"
#include "base/ProgressBar.h"
#include "base/Stopwatch.h"
#include "engine/PathTracer.h"

namespace radlab {

using namespace engine;

namespace {

// No form factor is needed where no light is reflected.
RenderSolution withoutReflection(const SceneInput& input) {
    RenderSolution solution;
    solution.surfaces = surfacesOf(*input.mesh, input.scatterings);
    solution.radiosity = solution.surfaces.emission;
    solution.summary = "radiosities: those emitted, as no light is reflected; no form factors, 0 of 3 channels solved";
    return solution;
}

}  // namespace

std::string stopText(bool stopped, double residual) {
    if (!stopped) return "";
    char text[120];
    std::snprintf(text, sizeof text, "\nstopped by Ctrl-C: of the light reflected once, a share of %.2g is not settled",
                  residual);
    return text;
}

RenderSolution solveByFormFactors(const SceneInput& input, const FormFactorOptions& options) {
    const Decision& indirect = input.effects[Effect::indirect];
    if (!indirect.on && !indirect.needed) return withoutReflection(input);
    FormFactorReport factors;
    FormFactorMatrix matrix = runFormFactors(input, options, factors);
    if (!isReciprocal(factors.method)) shownAs("making reciprocal", [&] { makeReciprocal(matrix); });
    const SpecularPart specular(input);
    const Stopwatch watch;
    RenderSolution solution;
    solution.surfaces = surfacesOf(*input.mesh, input.scatterings);
    Transport transport = transportOf(matrix);
    if (specular.transport) transport.further = specular.transport->further();
    SolverOptions solving;
    solving.channels = input.effects.channels();
    solving.indirect = input.effects.has(Effect::indirect);
    SolverReport solver;
    solution.radiosity =
        shownAs("radiosities", [&] { return solveRadiosity(transport, solution.surfaces, solving, &solver); });
    char text[400];
    std::snprintf(
        text, sizeof text,
        "form factors: %s, %zu rays, %.3g s%s\nradiosities: %d of 3 channels solved, %zu iterations, %.3g s%s",
        nameOf(factors.method).c_str(), factors.rays, factors.seconds, specular.summary.c_str(), solver.channels,
        solver.iterations, watch.seconds(), stopText(solver.stopped, solver.residual).c_str());
    solution.counts = {factors.rays, specular.transport ? specular.transport->rays() : 0, solver.iterations,
                       solver.channels};
    solution.summary = text;
    return solution;
}

std::string fewerText(std::size_t taken, std::size_t asked) {
    return taken < asked ? "\nstopped by Ctrl-C: " + std::to_string(asked) + " paths were asked for" : "";
}

RenderSolution solveByPaths(const SceneInput& input, std::size_t samples) {
    const Stopwatch watch;
    PathRadiosityOptions options;
    options.samples = samples;
    ProgressBar bar("path tracing", static_cast<double>(input.geometry.patches.size() * pathsOf(samples)), "paths");
    options.progress = [&](std::size_t paths) { bar.show(static_cast<double>(paths)); };
    const PathRadiosity found = pathTraceRadiosity(TracedScene(input.geometry, input.scatterings), options);
    char text[200];
    std::snprintf(text, sizeof text, "radiosities: path tracing, %zu paths a patch, %zu rays, %.3g s%s", found.samples,
                  found.rays, watch.seconds(), fewerText(found.samples, pathsOf(samples)).c_str());
    return {surfacesOf(*input.mesh, input.scatterings), found.radiosity, found.standardError, Point(0.0), {}, text};
}

}  // namespace radlab

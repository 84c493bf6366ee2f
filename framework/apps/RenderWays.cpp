#include "apps/RenderWays.h"

#include <CLI/CLI.hpp>

#include "apps/FormFactorRun.h"
#include "apps/SpecularPart.h"
#include "base/ProgressBar.h"
#include "engine/FormFactorRows.h"
#include "engine/HierarchicalRadiosity.h"
#include "engine/Scattering.h"
#include "engine/Shooting.h"

namespace radlab {

using namespace engine;

RenderSolution solveByLinks(const SceneInput& input, double threshold) {
    HierarchicalOptions options;
    options.threshold = threshold;
    options.occlusion = input.effects.has(Effect::occlusion);
    HierarchicalReport report;
    options.channels = input.effects.channels();
    options.indirect = input.effects.has(Effect::indirect);
    ProgressBar bar("links", 1.0);
    options.progress = [&](std::size_t links) { bar.show(0.0, std::to_string(links) + " links"); };
    const SpecularPart specular(input);
    options.further = specular.further();
    RenderSolution made;
    made.surfaces = surfacesOf(*input.mesh, input.scatterings);
    made.radiosity = solveHierarchical(input.geometry, made.surfaces, options, &report);
    char text[200];
    std::snprintf(text, sizeof text, "radiosities: %zu links in %zu rounds, %zu rays, %d of 3 channels solved, %.3g s",
                  report.links, report.rounds, report.rays, report.channels, report.seconds);
    made.summary = text + specular.summary + stopText(report.stopped, report.residual);
    if (report.stopped) made.summary += ", and links were not refined to the end";
    return made;
}

void addShootingFlags(CLI::App& app, ShootingFlags& flags) {
    app.add_option(
           "--unshot", flags.unshot,
           "Shoot from the brightest patches in turn, storing no form factors, until this share of the light is "
           "unshot; the picture shows it as ambient light")
        ->check(CLI::Range(1e-9, 1.0));
    app.add_option("--shots", flags.shots, "The same, until so many shots")
        ->check(CLI::Range(std::size_t{1}, std::size_t{1} << 32));
}

RenderSolution solveByShooting(const SceneInput& input, FormFactorOptions factors, const ShootingFlags& flags) {
    factors.occlusion = input.effects.has(Effect::occlusion);
    const FormFactorRows rows(input.geometry, factors);
    warnOfLimits(input, rows.method());
    const SpecularPart specular(input);
    ShootingOptions options;
    if (specular.transport) options.further = [&](std::size_t i) { return specular.transport->row(i); };
    options.indirect = input.effects.has(Effect::indirect);
    if (flags.unshot > 0.0) options.unshot = flags.unshot;
    if (flags.shots > 0) options.mostShots = flags.shots;
    ProgressBar bar("shooting", 1.0);
    options.progress = [&](std::size_t shots, double unshot) {
        // Light falls about evenly in the logarithm.
        bar.show(std::log(std::max(unshot, options.unshot)) / std::log(options.unshot),
                 std::to_string(shots) + " shots");
    };
    RenderSolution made;
    made.surfaces = surfacesOf(*input.mesh, input.scatterings);
    ShootingReport report;
    made.radiosity = shootRadiosity(
        areasOf(input.geometry), made.surfaces, [&](std::size_t i, double* row) { rows.row(i, row); }, options,
        &report);
    made.ambient = report.ambient;
    char text[200];
    std::snprintf(text, sizeof text, "radiosities: %zu shots by %s, %.3g of the light unshot, %zu rays, %.3g s",
                  report.shots, nameOf(rows.method()).c_str(), report.unshot, rows.rays(), report.seconds);
    made.summary = text + specular.summary;
    return made;
}

}  // namespace radlab

#include "apps/FormFactorRun.h"

#include <CLI/CLI.hpp>

#include "base/ProgressBar.h"
#include "engine/Hemicubes.h"

namespace radlab {

void addFormFactorFlags(CLI::App& app, FormFactorFlags& flags) {
    app.add_option("--method", flags.method,
                   "Form factors by point, polygon, exact, hemicube, hemisphere, visibility or auto")
        ->capture_default_str();
    app.add_option("--rays", flags.rays, "Rays from each patch (hemisphere) or for a pair partly hidden (visibility)")
        ->check(CLI::Range(std::size_t{16}, std::size_t{1} << 32));
    app.add_option("--size", flags.size, "Pixels along the edge of a hemicube, even")
        ->capture_default_str()
        ->check(CLI::Range(engine::Hemicubes::smallestSize, engine::Hemicubes::largestSize));
}

engine::FormFactorOptions optionsOf(const FormFactorFlags& flags) {
    engine::FormFactorOptions options;
    options.method = engine::methodNamed(flags.method);
    options.rays = flags.rays;
    options.hemicubeSize = flags.size;
    return options;
}

engine::FormFactorMatrix runFormFactors(const SceneInput& input, engine::FormFactorOptions options,
                                        engine::FormFactorReport& report) {
    ProgressBar bar("form factors", static_cast<double>(input.geometry.patches.size()), "rows");
    options.occlusion = input.effects.has(Effect::occlusion);
    options.progress = [&](std::size_t rows) { bar.show(static_cast<double>(rows)); };
    return engine::formFactors(input.geometry, options, &report);
}

}  // namespace radlab

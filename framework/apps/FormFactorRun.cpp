#include "apps/FormFactorRun.h"

#include <CLI/CLI.hpp>

#include "base/Memory.h"
#include "base/ProgressBar.h"
#include "base/Warning.h"
#include "engine/Hemicubes.h"
#include "engine/WorstPair.h"

namespace radlab {

void warnOfLimits(const SceneInput& input, engine::Method method) {
    const std::string name = engine::nameOf(method);
    if (input.effects.has(Effect::occlusion) && !engine::seesOcclusion(method))
        warn(input.scene.file + ": the method " + name + " sees nothing hidden, though " +
             input.effects[Effect::occlusion].reason + ": expected hemicube, hemisphere, visibility or auto");
    const auto worst = engine::worstPair(input.geometry, method);
    if (!worst) return;
    char text[300];
    std::snprintf(text, sizeof text,
                  ": the method %s takes patches for points, and some are near: from patch %zu to patch %zu it gives "
                  "%.3g where %.3g is right; expected exact, visibility or auto there, or smaller patches",
                  name.c_str(), worst->from, worst->to, worst->found, worst->exact);
    warn(input.scene.file + text);
}

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

std::string storageOf(const SceneInput& input) {
    return "form factors: " + bytesText(engine::matrixBytes(static_cast<double>(input.geometry.patches.size()))) +
           " to store";
}

engine::FormFactorMatrix runFormFactors(const SceneInput& input, engine::FormFactorOptions options,
                                        engine::FormFactorReport& report) {
    ProgressBar bar("form factors", static_cast<double>(input.geometry.patches.size()), "rows");
    options.occlusion = input.effects.has(Effect::occlusion);
    options.progress = [&](std::size_t rows) { bar.show(static_cast<double>(rows)); };
    engine::FormFactorMatrix matrix = engine::formFactors(input.geometry, options, &report);
    warnOfLimits(input, report.method);
    return matrix;
}

}  // namespace radlab

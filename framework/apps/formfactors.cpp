// Form factors between all patches of a scene, as a table in a file.

#include <iostream>

#include <CLI/CLI.hpp>

#include "apps/SceneInput.h"
#include "base/Program.h"
#include "base/ProgressBar.h"
#include "engine/ExchangeArea.h"
#include "engine/FormFactors.h"
#include "engine/MatrixFile.h"

namespace {

using namespace radlab;
using namespace radlab::engine;

struct Flags {
    SceneFlags scene;
    std::string out, method = "auto";
    std::size_t rays = 0;
    double tolerance = 0.0;
    bool faces = false, enforce = false;
};

std::string describeRun(const FormFactorReport& report, const Effects& effects) {
    char text[100];
    std::snprintf(text, sizeof text, "method %s: %zu rays, %.3g s\n", nameOf(report.method).c_str(), report.rays,
                  report.seconds);
    return text + effects.reason;
}

int formFactorTable(const Flags& flags) {
    requireMatrixFile(flags.out);
    FormFactorOptions options;
    options.method = methodNamed(flags.method);
    options.rays = flags.rays;
    if (flags.tolerance > 0.0)
        options.tolerance = flags.tolerance;
    else if (options.method == Method::exact)
        options.tolerance = finestTolerance;
    const SceneInput input = flags.faces ? readFacesInput(flags.scene) : readSceneInput(flags.scene);
    options.occlusion = input.effects.occlusion;
    FormFactorReport report;
    ProgressBar bar("form factors", static_cast<double>(input.geometry.patches.size()), "rows");
    options.progress = [&](std::size_t rows) { bar.show(static_cast<double>(rows)); };
    FormFactorMatrix matrix = formFactors(input.geometry, options, &report);
    std::string summary =
        input.summary + "\n" + describeRun(report, input.effects) + "\n" + describe(qualityOf(matrix));
    if (flags.enforce) {
        char text[100];
        std::snprintf(text, sizeof text, "\nboth laws enforced; rows are off by %.2g at most", enforceLaws(matrix));
        summary += text;
    }
    writeMatrix(flags.out, matrix, summary + "\nrow i, column j is F(i->j)");
    std::cout << summary << "\nwritten: " << flags.out << '\n';
    return 0;
}

void describe(CLI::App& app, Flags& flags) {
    addSceneFlags(app, flags.scene);
    app.add_option("-o,--out", flags.out, "The file to write, .csv or .npy")->required();
    app.add_option("--method", flags.method, "point, polygon, exact, hemisphere, visibility or auto")
        ->capture_default_str();
    app.add_flag("--faces", flags.faces, "Take the scene's faces as the patches, in the file's order")
        ->excludes("--patch-size");
    app.add_option("--rays", flags.rays, "Rays from each patch (hemisphere) or for a pair partly hidden (visibility)")
        ->check(CLI::Range(std::size_t{16}, std::size_t{1} << 32));
    app.add_option("--tolerance", flags.tolerance,
                   "Relative error of what is not hidden; else 1e-12 for exact, 1e-6 for visibility and auto")
        ->check(CLI::Range(finestTolerance, 0.1));
    app.add_flag("--enforce", flags.enforce, "Make both laws hold: reciprocity, and rows that add up to 1");
    app.set_version_flag("--version", "radlab " RADLAB_VERSION);
    app.footer("Example: ./radlab formfactors resources/scenes/cornell_1.x3d --method exact -o F.csv");
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app("Writes the form factors between all patches of a scene as a table.");
    Flags flags;
    describe(app, flags);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : 2;
    }
    return radlab::runProgram([&] { return formFactorTable(flags); });
}

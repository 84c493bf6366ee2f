// Form factors between all patches of a scene, as a table in a file.

#include <iostream>

#include "apps/CommandLine.h"
#include "apps/FormFactorRun.h"
#include "base/Interrupts.h"
#include "base/ProgressBar.h"
#include "engine/ExchangeArea.h"
#include "engine/MatrixFile.h"

namespace {

using namespace radlab;
using namespace radlab::engine;

struct Flags {
    SceneFlags scene;
    FormFactorFlags formFactors;
    std::string out;
    double tolerance = 0.0;
    bool faces = false, enforce = false;
};

std::string describeRun(const FormFactorReport& report, const Effects& effects) {
    char text[100];
    std::snprintf(text, sizeof text, "method %s: %zu rays, %.3g s\n", nameOf(report.method).c_str(), report.rays,
                  report.seconds);
    return text + describe(effects, Effect::occlusion);
}

int formFactorTable(const Flags& flags) {
    const Interrupts interrupts;
    requireMatrixFile(flags.out);
    FormFactorOptions options = optionsOf(flags.formFactors);
    if (flags.tolerance > 0.0)
        options.tolerance = flags.tolerance;
    else if (options.method == Method::exact)
        options.tolerance = finestTolerance;
    const SceneInput input = flags.faces ? readFacesInput(flags.scene) : readSceneInput(flags.scene);
    const bool panes = !input.geometry.through.empty();
    if (flags.enforce && panes)
        throw Error(
            "--enforce: found faces that let light through, expected none: light is counted at them and behind "
            "them, so rows do not add up to 1 (--force transparency=off takes them as opaque)");
    std::cout << storageOf(input) << std::endl;
    FormFactorReport report;
    FormFactorMatrix matrix = runFormFactors(input, options, report);
    const MatrixQuality quality = shownAs("adding up rows", [&] { return qualityOf(matrix); });
    std::string summary = input.summary + "\n" + describeRun(report, input.effects) + "\n" + describe(quality);
    if (panes) summary += "\nlight that faces let through is counted at them and behind them: rows may exceed 1";
    if (flags.enforce) {
        char text[100];
        const double off = shownAs("enforcing both laws", [&] { return enforceLaws(matrix); });
        std::snprintf(text, sizeof text, "\nboth laws enforced; rows are off by %.2g at most", off);
        summary += text;
    }
    shownAs("writing " + flags.out, [&] { writeMatrix(flags.out, matrix, summary + "\nrow i, column j is F(i->j)"); });
    std::cout << summary << "\nwritten: " << flags.out << '\n';
    return 0;
}

void describe(CLI::App& app, Flags& flags) {
    addSceneFlags(app, flags.scene);
    app.add_option("-o,--out", flags.out, "The file to write, .csv or .npy")->required();
    addFormFactorFlags(app, flags.formFactors);
    app.add_flag("--faces", flags.faces, "Take the scene's faces as the patches, in the file's order")
        ->excludes("--patch-size");
    app.add_option("--tolerance", flags.tolerance,
                   "Relative error of what is not hidden; else 1e-12 for exact, 1e-6 for visibility and auto")
        ->check(CLI::Range(finestTolerance, 0.1));
    app.add_flag("--enforce", flags.enforce, "Make both laws hold: reciprocity, and rows that add up to 1");
    app.footer("Example: ./radlab formfactors resources/scenes/cornell_1.x3d --method exact -o F.csv");
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app("Writes the form factors between all patches of a scene as a table.");
    Flags flags;
    describe(app, flags);
    return radlab::runCommandLine(app, argc, argv, [&] { return formFactorTable(flags); });
}

// Form factors between all patches of a scene, as a table in a file.

#include <cmath>
#include <iostream>

#include <CLI/CLI.hpp>

#include "base/Error.h"
#include "base/Program.h"
#include "base/ProgressBar.h"
#include "engine/FormFactors.h"
#include "engine/MatrixFile.h"
#include "scene/Effects.h"
#include "scene/ResourceFile.h"
#include "scene/X3dReader.h"

namespace {

using namespace radlab;
using namespace radlab::engine;

struct Flags {
    std::string scene, out, method = "auto";
    double patchSize = 0.0;
    std::size_t rays = 0;
    bool faces = false, enforce = false;
};

constexpr double patchesWanted = 1000.0;  // where no size is given

struct Input {
    Scene scene;
    Geometry geometry;
    std::string made;  // how the patches came about
};

double sizeFor(const Scene& scene) {
    double area = 0.0;
    for (const Polygon& face : geometryOf(scene).faces) area += face.area;
    return std::sqrt(area / patchesWanted);
}

Input read(const Flags& flags) {
    Input input;
    std::filesystem::path file = flags.scene;
    double patchSize = flags.patchSize, lightSize = flags.patchSize;
    if (file.extension() == ".xml") {
        const Resource settings = readResource(file);
        file = settings.sceneFile;
        if (patchSize == 0.0) {
            patchSize = static_cast<double>(settings.patchSize);
            lightSize = static_cast<double>(settings.lightSize);
        }
    }
    input.scene = readX3d(file);
    if (flags.faces) {
        input.geometry = geometryOf(input.scene);
        input.made = "its faces as the patches";
        return input;
    }
    if (patchSize == 0.0) patchSize = lightSize = sizeFor(input.scene);
    const PatchMesh mesh(input.scene.vertices, input.scene.faces, static_cast<float>(patchSize),
                         static_cast<float>(lightSize));
    input.geometry = geometryOf(input.scene, mesh);
    char text[64];
    std::snprintf(text, sizeof text, "patch size %.4g", patchSize);
    input.made = text;
    return input;
}

std::string words(const Input& input, const FormFactorReport& report) {
    char text[200];
    std::snprintf(text, sizeof text, ", %zu patches\nmethod %s: %zu rays, %.3g s", input.geometry.patches.size(),
                  nameOf(report.method).c_str(), report.rays, report.seconds);
    return input.scene.file + ": " + input.made + text;
}

int formFactorTable(const Flags& flags) {
    requireMatrixFile(flags.out);
    FormFactorOptions options;
    options.method = methodNamed(flags.method);
    options.rays = flags.rays;
    const Input input = read(flags);
    const Effects effects = findEffects(input.scene);
    options.occlusion = effects.occlusion;
    const std::size_t count = input.geometry.patches.size();
    FormFactorReport report;
    ProgressBar bar("form factors", static_cast<double>(count), "rows");
    options.progress = [&](std::size_t rows) { bar.show(static_cast<double>(rows)); };
    FormFactorMatrix matrix = formFactors(input.geometry, options, &report);
    std::string summary = words(input, report) + "\n" + effects.reason + "\n" + describe(qualityOf(matrix));
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
    app.add_option("SCENE", flags.scene, "An X3D file, or settings (Resource.xml) that name one")->required();
    app.add_option("-o,--out", flags.out, "The file to write, .csv or .npy")->required();
    app.add_option("--method", flags.method, "point, polygon, exact, hemisphere, visibility or auto")
        ->capture_default_str();
    const auto size = app.add_option("--patch-size", flags.patchSize,
                                     "Longest edge of a patch; else as the settings say, or for about 1000 patches")
                          ->check(CLI::PositiveNumber);
    app.add_flag("--faces", flags.faces, "Take the scene's faces as the patches, in the file's order")->excludes(size);
    app.add_option("--rays", flags.rays, "Rays from each patch (hemisphere) or for a pair partly hidden (visibility)")
        ->check(CLI::Range(std::size_t{16}, std::size_t{1} << 32));
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

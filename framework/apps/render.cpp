// A scene solved by the engine: its picture, and the radiosity of every patch.

#include <iostream>
#include <ostream>

#include "apps/CommandLine.h"
#include "apps/FormFactorRun.h"
#include "base/ImageFile.h"
#include "base/NumberText.h"
#include "base/Stopwatch.h"
#include "base/Warning.h"
#include "base/WholeFile.h"
#include "course/ProgRef.h"
#include "display/Draw.h"
#include "display/ToneMap.h"
#include "engine/Radiosity.h"
#include "gl/Context.h"

namespace {

using namespace radlab;
using namespace radlab::engine;

struct Flags {
    SceneFlags scene;
    FormFactorFlags formFactors;
    std::string image, table;
    std::size_t camera = 0;
    int width = 800, height = 800;
    bool flat = false;
    double exposure = 0.0;
};

struct Solution {
    Surfaces surfaces;
    std::vector<Point> radiosity;
    std::string summary;
};

Solution solve(const SceneInput& input, const FormFactorOptions& options) {
    FormFactorReport factors;
    FormFactorMatrix matrix = runFormFactors(input, options, factors);
    if (factors.method == Method::polygon || factors.method == Method::hemisphere) makeReciprocal(matrix);
    const Stopwatch watch;
    Solution solution;
    solution.surfaces = surfacesOf(*input.mesh);
    SolverOptions solving;
    solving.channels = input.effects.channels();
    SolverReport solver;
    solution.radiosity = solveRadiosity(matrix, solution.surfaces, solving, &solver);
    char text[300];
    std::snprintf(text, sizeof text,
                  "form factors: %s, %zu rays, %.3g s\nradiosities: %d of 3 channels solved, %zu iterations, %.3g s",
                  nameOf(factors.method).c_str(), factors.rays, factors.seconds, solver.channels, solver.iterations,
                  watch.seconds());
    solution.summary = text;
    return solution;
}

void appendNumbers(std::string& line, const Point& values) {
    for (int c = 0; c < 3; ++c) appendNumber(line += ',', values[c], 9);
}

void writeTable(const std::string& file, const SceneInput& input, const Solution& solution) {
    writeFile(file, [&](std::ostream& out) {
        out << "# " << input.summary << "\nid,face,x,y,z,nx,ny,nz,area,rho_r,rho_g,rho_b,E_r,E_g,E_b,B_r,B_g,B_b\n";
        for (std::size_t i = 0; i < solution.radiosity.size(); ++i) {
            const Polygon& patch = input.geometry.patches[i];
            std::string line = std::to_string(i) + "," + std::to_string(input.geometry.faceOf[i]);
            appendNumbers(line, patch.center);
            appendNumbers(line, patch.normal);
            appendNumber(line += ',', patch.area, 9);
            appendNumbers(line, solution.surfaces.reflectance[i]);
            appendNumbers(line, solution.surfaces.emission[i]);
            appendNumbers(line, solution.radiosity[i]);
            out << line << '\n';
        }
    });
}

void drawImage(const Flags& flags, SceneInput& input, const Solution& solution) {
    View view;
    view.width = flags.width;
    view.height = flags.height;
    view.background = input.scene.background;
    if (flags.camera < input.scene.cameras.size()) view.camera = input.scene.cameras[flags.camera];
    const auto context = GlContext::offscreen();
    input.mesh->publish();
    for (std::size_t i = 0; i < solution.radiosity.size(); ++i)
        input.mesh->patches[i].rad = Vec3f(solution.radiosity[i]);
    colorReconstruction();
    const Image radiance = drawRadiance(view, flags.flat ? Shading::flat : Shading::smooth);
    if (std::filesystem::path(flags.image).extension() == ".hdr") return writeImage(flags.image, radiance);
    const float exposure = flags.exposure > 0.0 ? static_cast<float>(flags.exposure) : autoExposure(radiance);
    writeImage(flags.image, toneMap(radiance, exposure));
}

int render(const Flags& flags) {
    const FormFactorOptions options = optionsOf(flags.formFactors);
    if (!flags.image.empty()) requireImageFile(flags.image);
    if (flags.image.empty() && flags.table.empty())
        throw Error("nothing to write: expected -o image.png (or .hdr), --csv patches.csv, or both");
    SceneInput input = readSceneInput(flags.scene);
    if (flags.camera > 0 && flags.camera >= input.scene.cameras.size())
        throw Error(input.scene.file + ": found " + std::to_string(input.scene.cameras.size()) +
                    " viewpoints, and --camera " + std::to_string(flags.camera) + " (the first is 0)");
    std::cout << input.summary << '\n' << describe(input.effects, Effect::occlusion) << std::endl;
    if (std::none_of(input.mesh->patches.begin(), input.mesh->patches.end(),
                     [](const MyPolygon& patch) { return patch.emissive != Vec3f(0.0f); }))
        warn(input.scene.file + ": nothing emits light, so every radiosity is 0");
    const Solution solution = solve(input, options);
    std::cout << solution.summary << '\n';
    if (!flags.table.empty()) writeTable(flags.table, input, solution);
    if (!flags.image.empty()) drawImage(flags, input, solution);
    for (const std::string& file : {flags.image, flags.table})
        if (!file.empty()) std::cout << "written: " << file << '\n';
    return 0;
}

void describe(CLI::App& app, Flags& flags) {
    addSceneFlags(app, flags.scene);
    app.add_option("-o,--out", flags.image, "The picture: .png, or .hdr with linear radiance");
    app.add_option("--csv", flags.table,
                   "A table of the patches: centre, normal, area, reflectance, emission, radiosity");
    addFormFactorFlags(app, flags.formFactors);
    app.add_option("--width", flags.width, "Pixels")->capture_default_str()->check(CLI::Range(1, 8192));
    app.add_option("--height", flags.height, "Pixels")->capture_default_str()->check(CLI::Range(1, 8192));
    app.add_option("--camera", flags.camera, "Which of the scene's viewpoints, the first is 0")->capture_default_str();
    app.add_option("--exposure", flags.exposure, "Display value per radiance, of a PNG; else chosen by the picture")
        ->check(CLI::PositiveNumber);
    app.add_flag("--flat", flags.flat, "One colour a patch, not smooth from vertex to vertex");
    app.footer("Example: ./radlab render resources/scenes/cornell_2.x3d -o box.png --csv box.csv");
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app("Solves a scene's light and draws it.");
    Flags flags;
    describe(app, flags);
    return radlab::runCommandLine(app, argc, argv, [&] { return render(flags); });
}

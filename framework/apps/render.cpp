// A scene solved by the engine: its picture, and the radiosity of every patch.

#include <algorithm>
#include <filesystem>
#include <iostream>

#include "apps/CommandLine.h"
#include "apps/FormFactorRun.h"
#include "apps/RenderMesh.h"
#include "apps/RenderTable.h"
#include "apps/RenderToError.h"
#include "apps/RenderWays.h"
#include "base/ImageFile.h"
#include "base/Interrupts.h"
#include "base/Warning.h"
#include "export/MeshFile.h"

namespace {

using namespace radlab;

struct Flags {
    SceneFlags scene;
    FormFactorFlags formFactors;
    PictureFlags picture;
    std::string table;
    std::size_t samples = 0;
    ShootingFlags shooting;
    double threshold = 1e-4, error = 0.0;

    bool byPaths() const { return formFactors.method == "path"; }
    bool byLinks() const { return formFactors.method == "links"; }
    bool wantsMesh() const { return std::any_of(picture.files.begin(), picture.files.end(), isMeshFile); }
    bool wantsPicture() const { return !std::all_of(picture.files.begin(), picture.files.end(), isMeshFile); }
};

constexpr std::size_t usualSamples = 64;

void requireFile(const std::string& file) {
    if (!isMeshFile(file) && !isImageFile(file))
        throw Error({file}, "unknown kind of file: found the ending '" +
                                std::filesystem::path(file).extension().string() +
                                "', expected .png or .hdr for a picture, .glb, .gltf or .ply for a mesh");
}

// What is wrong with the flags, before any work.
void check(const Flags& flags) {
    if (!flags.byPaths() && !flags.byLinks()) optionsOf(flags.formFactors);
    if (flags.shooting.given() && (flags.byPaths() || flags.byLinks() || flags.error > 0.0))
        throw Error("--unshot, --shots: found --error or a method without form factors, expected neither with them");
    if (flags.error > 0.0 && flags.formFactors.method != "auto")
        throw Error("--error: found --method " + flags.formFactors.method +
                    ", expected none with it, as the way is chosen by the error");
    if (flags.samples > 0 && !flags.byPaths())
        throw Error("--samples: found method '" + flags.formFactors.method + "', expected --method path with it");
    for (const std::string& file : flags.picture.files) requireFile(file);
    if (flags.picture.files.empty() && flags.table.empty())
        throw Error("nothing to write: expected -o image.png (or .hdr, .glb, .gltf, .ply), --csv patches.csv, or both");
}

RenderSolution solve(const Flags& flags, SceneInput& input) {
    if (flags.error > 0.0) return solveToError(input, flags.error, flags.scene.patchSize);
    if (flags.byLinks()) return solveByLinks(input, flags.threshold);
    if (flags.shooting.given()) return solveByShooting(input, optionsOf(flags.formFactors), flags.shooting);
    std::cout << storageOf(input) << std::endl;
    return solveByFormFactors(input, optionsOf(flags.formFactors));
}

// Writes what was asked for, file by file, and says so.
class Writer {
public:
    Writer(const Flags& asked, const SceneInput& solved) : flags(asked), input(solved) {}

    void table(const RenderSolution& solution) {
        if (flags.table.empty()) return;
        writeTable(flags.table, input, solution);
        tell(flags.table);
    }

    void meshes(const RenderSolution& solution, const Image& radiance) {
        for (const std::string& file : flags.picture.files) {
            if (!isMeshFile(file)) continue;
            writeSolution(file, flags.picture, input, solution, exposureOf(flags.picture, radiance));
            tell(file);
        }
    }

    void pictures(const Image& radiance) {
        for (const std::string& file : flags.picture.files) {
            if (isMeshFile(file)) continue;
            writePicture(file, flags.picture, radiance);
            tell(file);
        }
    }

    bool hasWritten() const { return any; }

private:
    void tell(const std::string& file) {
        std::cout << "written: " << file << std::endl;
        any = true;
    }

    const Flags& flags;
    const SceneInput& input;
    bool any = false;
};

// What is solved, to the end or not, is now drawn and written.
void tellSolution(const RenderSolution& solution) {
    Interrupts::answer();
    std::cout << solution.summary << std::endl;
}

Image drawn(const RenderPicture& picture) {
    std::cout << picture.summary << std::endl;
    return picture.radiance;
}

// No picture of which meshes were to get their exposure, if they are given one.
Image drawnForMeshes(const Flags& flags, const SceneInput& input, const RenderSolution& solution) {
    return flags.picture.exposure > 0.0 ? Image() : drawn(drawSolution(flags.picture, input, solution));
}

void renderRadiosities(const Flags& flags, SceneInput& input, Writer& write) {
    const RenderSolution solution = solve(flags, input);
    tellSolution(solution);
    write.table(solution);
    if (flags.picture.files.empty()) return;
    const Image radiance = flags.wantsPicture() ? drawn(drawSolution(flags.picture, input, solution))
                                                : drawnForMeshes(flags, input, solution);
    Interrupts::answer();
    write.meshes(solution, radiance);
    write.pictures(radiance);
}

void renderByPaths(const Flags& flags, const SceneInput& input, Writer& write) {
    const std::size_t samples = flags.samples > 0 ? flags.samples : usualSamples;
    if (!flags.table.empty() || flags.wantsMesh()) {
        const RenderSolution solution = solveByPaths(input, samples);
        tellSolution(solution);
        write.table(solution);
        if (flags.wantsMesh()) write.meshes(solution, drawnForMeshes(flags, input, solution));
    }
    if (!flags.wantsPicture()) return;
    if (Interrupts::caught()) throw Interrupted();  // or the picture would take as long as what was stopped
    const RenderPicture picture = drawPaths(flags.picture, input, samples);
    Interrupts::answer();
    write.pictures(drawn(picture));
}

// Solves, draws and writes; Interrupted where not everything that was asked for is written.
void renderInto(Writer& write, const Flags& flags, SceneInput& input) {
    if (flags.byPaths())
        renderByPaths(flags, input, write);
    else
        renderRadiosities(flags, input, write);
}

int render(const Flags& flags) {
    const Interrupts interrupts;
    check(flags);
    SceneInput input = readSceneInput(flags.scene);
    requireCamera(flags.picture, input.scene);
    std::cout << input.summary << '\n' << describe(input.effects, Effect::occlusion) << std::endl;
    if (std::none_of(input.mesh->patches.begin(), input.mesh->patches.end(),
                     [](const MyPolygon& patch) { return patch.emissive != Vec3f(0.0f); }))
        warn(input.scene.file + ": nothing emits light, so every radiosity is 0");
    Writer write(flags, input);
    const bool whole = doneWhole([&] { renderInto(write, flags, input); });
    if (!whole && !write.hasWritten()) throw Interrupted();
    if (!Interrupts::caught()) return 0;
    std::cout << (whole ? "stopped by Ctrl-C: what is written is whole, and as far as the lines above say\n"
                        : "stopped by Ctrl-C: what is named above is written whole, and nothing else\n");
    return 130;
}

void describe(CLI::App& app, Flags& flags) {
    addSceneFlags(app, flags.scene);
    addPictureFlags(app, flags.picture);
    app.add_option("--csv", flags.table,
                   "A table of the patches: centre, normal, area, reflectance, emission, radiosity");
    addFormFactorFlags(app, flags.formFactors);
    CLI::Option* method = app.get_option("--method");
    method->description(method->get_description() +
                        "; or links between clusters of patches; or path: no form factors but random paths");
    app.add_option("--error", flags.error,
                   "The relative error of the radiosities to reach, 0.01 for 1 %: way and patches are chosen by it")
        ->check(CLI::Range(1e-4, 1.0));
    addShootingFlags(app, flags.shooting);
    app.add_option("--threshold", flags.threshold, "Of --method links: a link that carries more of the light is split")
        ->capture_default_str()
        ->check(CLI::Range(1e-12, 1.0));
    app.add_option("--samples", flags.samples,
                   "Of --method path: paths from each patch of the table and each pixel of the picture; else 64")
        ->check(CLI::Range(std::size_t{1}, std::size_t{1} << 32));
    app.footer("Example: ./radlab render resources/scenes/cornell_2.x3d -o box.png --csv box.csv");
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app("Solves a scene's light and draws it.");
    Flags flags;
    describe(app, flags);
    return radlab::runCommandLine(app, argc, argv, [&] { return render(flags); });
}

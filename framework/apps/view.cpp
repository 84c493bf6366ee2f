// The viewer: a window with a scene while it is being solved by the student's functions.

#include <filesystem>
#include <iostream>

#include "apps/CommandLine.h"
#include "base/Error.h"
#include "viewer/Supervisor.h"
#include "viewer/window/ViewerWindow.h"

namespace {

struct Flags {
    std::string scene = RADLAB_SOURCE_DIR "/resources/scenes/cornell_2.x3d";
    std::string folder = "out/view";
    std::string source, target = "exercise-library";
    bool solution = false;
    double hangSeconds = 10.0;
    radlab::WindowOptions window;
    radlab::ViewerOptions viewer;
};

radlab::LibraryRecipe recipeOf(const Flags& flags) {
    const std::filesystem::path project = RADLAB_SOURCE_DIR;
    radlab::LibraryRecipe recipe{project / "exercises/ProgRef.cpp", RADLAB_BUILD_DIR, flags.target, {}};
    if (flags.solution) {
        recipe.source = project / "solutions/ProgRef.cpp";
        recipe.target = "solution-library";
        if (!std::filesystem::exists(recipe.source))
            throw radlab::Error("--solution: this package has no solutions; leave it out to run exercises/ProgRef.cpp");
    }
    if (!flags.source.empty()) recipe.source = flags.source;
    if (!std::filesystem::exists(recipe.source)) throw radlab::Error({recipe.source.string()}, "no such file");
    recipe.library = std::filesystem::path(RADLAB_LIBRARY_DIR) / (recipe.target + RADLAB_LIBRARY_SUFFIX);
    return recipe;
}

void addFlags(CLI::App& app, Flags& flags) {
    app.add_option("SCENE", flags.scene, "An X3D file, or settings (Resource.xml) that name one");
    app.add_flag("--solution", flags.solution, "Run the reference solution in place of exercises/ProgRef.cpp");
    app.add_option("--patch-size", flags.viewer.patchSize, "Longest edge of a patch, in the scene's unit")
        ->check(CLI::PositiveNumber);
    app.add_option("--hemicube", flags.viewer.hemicubeSize, "Pixels along an edge of the hemicube, even")
        ->check(CLI::Range(2, 4096));
    app.add_option("--width", flags.window.width, "Width of the window")
        ->check(CLI::Range(320, 16384))
        ->capture_default_str();
    app.add_option("--height", flags.window.height, "Height of the window")
        ->check(CLI::Range(240, 16384))
        ->capture_default_str();
    app.add_option("--scale", flags.window.scale, "Scale of fonts and controls; else the display's")
        ->check(CLI::Range(0.5, 4.0));
    app.add_flag("--play", flags.viewer.play, "Shoot from the start");
    app.add_flag("--forget", flags.viewer.forget, "Begin with the scene's own view, not the last one");
    app.add_option("--folder", flags.folder, "Folder for screenshots and for the views that are kept")
        ->capture_default_str();
    app.add_option("--hang-seconds", flags.hangSeconds, "How long a function may run before the viewer starts again")
        ->check(CLI::Range(1.0, 3600.0))
        ->capture_default_str();
    app.add_option("--trace", flags.window.trace,
                   "Write what is shown, and where the buttons lie, as JSON to this file");
    app.add_option("--bench", flags.window.benchSeconds,
                   "Shoot for so many seconds, print frames and shots a second, and quit")
        ->check(CLI::PositiveNumber);
    app.add_option("--source", flags.source, "Another file with the six functions to watch; --target must build it");
    app.add_option("--target", flags.target, "The build's target that makes the library")->capture_default_str();
    app.footer(
        "Press ? in the window for its keys. Example: ./radlab view --solution --play resources/scenes/teapot.x3d");
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app(
        "Shows a scene while your own functions solve it, and takes them anew whenever you save the exercise.");
    Flags flags;
    addFlags(app, flags);
    return radlab::runCommandLine(app, argc, argv, [&] {
        if (!std::filesystem::exists(flags.scene)) throw radlab::Error({flags.scene}, "no such file");
        flags.viewer.scene = std::filesystem::absolute(flags.scene);
        flags.viewer.folder = flags.folder;
        flags.viewer.library = recipeOf(flags);
        return radlab::supervise(flags.hangSeconds, [&](radlab::SharedView& shared, const radlab::Restart& restart) {
            return radlab::runProgram(
                [&] { return radlab::runViewerWindow(flags.window, flags.viewer, shared, restart); });
        });
    });
}

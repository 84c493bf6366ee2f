#include "viewer/Viewer.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <limits>

#include "base/ImageFile.h"
#include "base/WholeFile.h"
#include "scene/X3dReader.h"
#include "viewer/CourseLibrary.h"

namespace radlab {

namespace {

constexpr double shotSeconds = 0.006;  // of the 33 ms of a frame; a shot that has begun is ended
constexpr float turn = 0.1f, step = 1.12f;
constexpr double patchesAtFirst = 1000.0;
constexpr double keepSeconds = 1.0, watchSeconds = 0.1;

struct Input {
    Scene scene;
    ViewState state;
};

// A scene, with the settings of its Resource.xml where it is named by one.
Input inputOf(std::filesystem::path file) {
    Input input;
    if (file.extension() == ".xml") {
        const Resource resource = readResource(file);
        input.state.patchSize = resource.patchSize;
        input.state.lightSize = resource.lightSize;
        input.state.hemicubeSize = resource.hemicubeSize;
        input.state.method = resource.method;
        file = resource.sceneFile;
    }
    input.scene = readX3d(file);
    if (!(input.state.patchSize > 0.0f))
        input.state.patchSize = input.state.lightSize = patchSizeFor(input.scene, patchesAtFirst);
    const Camera camera = input.scene.cameras.empty() ? Camera{} : input.scene.cameras.front();
    input.state.camera = orbitFrom(camera, input.scene.vertices);
    if (input.scene.cameras.empty()) {
        const Ball ball = ballRound(input.scene.vertices);
        input.state.camera.frame(ball.centre, ball.radius);
    }
    return input;
}

}  // namespace

std::filesystem::path keptFile(const std::filesystem::path& folder, const std::filesystem::path& scene) {
    std::uint64_t hash = 14695981039346656037u;  // FNV-1a, of the path, since scenes of one name lie in many folders
    for (const char c : std::filesystem::absolute(scene).lexically_normal().string())
        hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211u;
    char name[32];
    std::snprintf(name, sizeof name, "-%08x.json", static_cast<unsigned>(hash >> 32 ^ hash));
    return folder / (scene.stem().string() + name);
}

std::filesystem::path nextScreenshot(const std::filesystem::path& folder, const std::string& name) {
    for (int number = 1;; ++number) {
        char ending[32];
        std::snprintf(ending, sizeof ending, "-%03d.png", number);
        if (!std::filesystem::exists(folder / (name + ending))) return folder / (name + ending);
    }
}

Viewer::Viewer(ViewerOptions what, SharedView& place, const Restart& restarted)
    : options(std::move(what)), shared(place), build(options.library), crash(restarted.message) {
    const bool again = !restarted.message.empty();
    if (restarted.inInitialiser) build.passOver(shared.loaded);
    const ViewState before = shared.state;
    open(again && shared.scene[0] ? std::filesystem::path(shared.scene) : options.scene);
    if (again) apply(before);
    playing = options.play && !again;
}

void Viewer::open(const std::filesystem::path& scene) {
    keepView();
    Input input = inputOf(scene);
    auto next = std::make_unique<Simulation>(std::move(input.scene), shared.running);
    ViewState state = input.state;
    if (!options.forget) try {
            if (std::filesystem::exists(keptFile(options.folder, scene)))
                state = viewStateFrom(readFile(keptFile(options.folder, scene)));
        } catch (const Error& error) {
            tell("The last view was not kept", error.what());
        }
    if (scene == options.scene && options.patchSize > 0.0f) state.patchSize = state.lightSize = options.patchSize;
    if (scene == options.scene && options.hemicubeSize > 0) state.hemicubeSize = options.hemicubeSize;
    if (canRun()) next->setFunctions(functions);
    next->cut(state);
    solving = std::move(next);
    settings = state;
    file = scene;
    chosen = {};
    drawing.rebuild();
    share();
}

void Viewer::choose(const std::filesystem::path& scene) {
    try {
        open(scene);
    } catch (const Error& error) {
        tell("This scene cannot be shown", error.what());
    }
}

void Viewer::apply(const ViewState& wanted) {
    try {
        if (wanted.patchSize != settings.patchSize || wanted.lightSize != settings.lightSize) {
            solving->cut(wanted);
            drawing.rebuild();
            chosen = {};
        } else {
            solving->restart(wanted);
        }
        settings = wanted;
    } catch (const Error& error) {
        tell("Not changed", error.what());
    }
    drawing.forgetIds();
    look();
    share();
}

void Viewer::restart() {
    solving->restart(settings);
    look();
}

void Viewer::share() {
    shared.state = settings;
    std::strncpy(shared.scene, file.string().c_str(), sizeof shared.scene - 1);
}

void Viewer::keepView() {
    if (!solving) return;
    const std::string text = toJson(settings);
    if (text == kept) return;
    kept = text;
    try {
        makeFolder(options.folder);
        writeFile(keptFile(options.folder, file), text);
    } catch (const Error& error) {
        tell("The view is not kept", error.what());
    }
}

void Viewer::tell(const std::string& title, const std::string& text) {
    notice = Banner{Banner::Kind::note, title, text};
    noticeTime.restart();
}

void Viewer::load(const LibraryOutcome& made) {
    const bool changed = made.stamp != shared.loaded && shared.loaded[0];
    std::strncpy(shared.loaded, made.stamp.c_str(), sizeof shared.loaded - 1);
    try {
        const RunningMark mark(shared.running, Running::loading);
        functions = loadCourseFunctions(made.library);
        compileError.clear();
        ++loaded;
        if (changed) {
            crash.clear();
            tell("Reloaded",
                 options.library.source.filename().string() + " was rebuilt; its functions are in use now.");
        }
    } catch (const Error& error) {
        compileError = error.what();
    }
    std::error_code ignored;
    std::filesystem::remove(made.library, ignored);  // it stays loaded
}

void Viewer::takeLibrary() {
    const std::optional<LibraryOutcome> outcome = build.poll();
    if (!outcome) return;
    if (outcome->library.empty()) {
        compileError = outcome->error;
        playing = playing && functions;
        return;
    }
    load(*outcome);
    giveFunctions();
}

// After a crash, nothing of the student's runs until the user asks for it: not even colorReconstruction.
void Viewer::giveFunctions() {
    solving->setFunctions(canRun() ? functions : std::nullopt);
    drawing.forgetIds();
    restart();
}

void Viewer::resume() {
    if (crash.empty()) return;
    crash.clear();
    giveFunctions();
}

void Viewer::advance() {
    share();
    if (buildTime.seconds() > watchSeconds) {
        takeLibrary();
        buildTime.restart();
    }
    if (playing && canRun())
        shoot(settings.shotsPerFrame > 0 ? settings.shotsPerFrame : std::numeric_limits<int>::max());
    if (keepTime.seconds() > keepSeconds) {
        keepView();
        keepTime.restart();
    }
}

void Viewer::shoot(int most) {
    if (!canRun()) return;
    // A number that was asked for is made whole, however long it takes.
    const bool asked = most != std::numeric_limits<int>::max();
    solving->shoot(most, asked && settings.shotsPerFrame == 0 ? 1e9 : shotSeconds);
    if (solving->problem() || solving->finished()) playing = false;
}

void Viewer::show(Mode mode) {
    solving->forgetProblem();
    settings.mode = mode;
}

void Viewer::exposeBy(float factor) {
    settings.exposure = exposureOf(settings) * factor;
    settings.autoExposure = false;
}

void Viewer::quit() {
    keepView();
    ending = true;
}

void Viewer::perform(Command command) {
    OrbitCamera& camera = settings.camera;
    switch (command) {
        case Command::playPause:
            resume();
            playing = !playing && !solving->finished();
            return;
        case Command::oneShot:
            resume();
            playing = false;
            return shoot(1);
        case Command::reset:
            resume();
            playing = false;
            return restart();
        case Command::wireframe: return show(Mode::wireframe);
        case Command::flat: return show(Mode::flat);
        case Command::smooth: return show(Mode::smooth);
        case Command::unshot: return show(Mode::unshot);
        case Command::ids: return show(Mode::ids);
        case Command::formFactors: return show(Mode::formFactors);
        case Command::meshLines: settings.meshLines = !settings.meshLines; return;
        case Command::orbitLeft: return camera.orbit(-turn, 0.0f);
        case Command::orbitRight: return camera.orbit(turn, 0.0f);
        case Command::orbitUp: return camera.orbit(0.0f, -turn);
        case Command::orbitDown: return camera.orbit(0.0f, turn);
        case Command::zoomIn: return camera.zoom(1.0f / step);
        case Command::zoomOut: return camera.zoom(step);
        case Command::frameAll: {
            const Ball ball = ballRound(solving->scene().vertices);
            return camera.frame(ball.centre, ball.radius);
        }
        case Command::firstView: camera = inputOf(file).state.camera; return;
        case Command::brighter: return exposeBy(1.2599f);
        case Command::darker: return exposeBy(1.0f / 1.2599f);
        case Command::autoExposure: settings.autoExposure = !settings.autoExposure; return;
        case Command::unpick: return unpick();
        case Command::panel: settings.panel = !settings.panel; return;
        case Command::screenshot: pendingScreenshot = true; return;
        case Command::help: help = !help; return;
        case Command::quit: return quit();
    }
}

void Viewer::unpick() { chosen = {}; }

void Viewer::pick(const Place& place, int x, int y) {
    chosen = {drawing.pick(*solving, settings, place, x, y), {}};
    look();
}

void Viewer::look() {
    chosen.view.reset();
    if (chosen.patch && canRun()) chosen.view = solving->lookFrom(*chosen.patch);
}

void Viewer::draw(const Place& place) {
    ViewState shown = settings;
    if (shown.mode == Mode::ids && !canRun()) shown.mode = Mode::wireframe;
    const auto draw = [&] {
        drawing.draw(*solving, shown, chosen, place, [this] {
            const RunningMark mark(shared.running, Running::renderPatchIDs);
            functions->renderPatchIDs();
        });
    };
    if (!solving->attempt(draw)) {
        shown.mode = Mode::wireframe;
        draw();
    }
    lastPlace = place;
    if (!pendingScreenshot) return;
    pendingScreenshot = false;
    takeScreenshot();
}

void Viewer::takeScreenshot() {
    try {
        makeFolder(options.folder);
        const std::filesystem::path picture = nextScreenshot(options.folder, file.stem().string());
        writeImage(picture, readPlace(lastPlace));
        tell("Screenshot written", picture.string());
    } catch (const Error& error) {
        tell("No screenshot", error.what());
    }
}

std::vector<Banner> Viewer::banners() const {
    using Kind = Banner::Kind;
    std::vector<Banner> all;
    if (!crash.empty()) {
        const std::size_t end = crash.find('\n');
        all.push_back({Kind::problem, crash.substr(0, end), crash.substr(end + 1)});
    }
    if (!compileError.empty()) {
        const char* rest = functions ? "\nThe functions from before stay in use."
                                     : "\nSave the file once it is mended; it is built again.";
        all.push_back(
            {Kind::problem, options.library.source.filename().string() + " does not compile", compileError + rest});
    }
    if (const auto& problem = solving->problem()) {
        const std::size_t end = problem->text.find('\n');
        all.push_back({problem->notWritten ? Kind::stub : Kind::problem, problem->text.substr(0, end),
                       end == std::string::npos ? "" : problem->text.substr(end + 1)});
    }
    if (build.isBuilding()) all.push_back({Kind::note, "Compiling", options.library.source.filename().string()});
    if (notice && noticeTime.seconds() < noticeSeconds) all.push_back(*notice);
    return all;
}

}  // namespace radlab

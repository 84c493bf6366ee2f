#include "viewer/Viewer.h"

#include <cstring>
#include <limits>
#include <utility>

#include "base/ImageFile.h"
#include "base/WholeFile.h"
#include "viewer/CourseLibrary.h"
#include "viewer/ViewerFiles.h"

namespace radlab {

namespace {

constexpr double shotSeconds =
    0.006;  // of the 33 ms of a frame; where a shot takes longer, frames are drawn in between
constexpr float turn = 0.1f, step = 1.12f;
constexpr double keepSeconds = 1.0, watchSeconds = 0.1;

}  // namespace

Viewer::Viewer(ViewerOptions what, SharedView& place, const Restart& restarted)
    : options(std::move(what)), shared(place), build(options.library), crash(restarted.message) {
    const bool again = !restarted.message.empty();
    removeCopy();
    if (restarted.inInitialiser) build.passOver(shared.loaded);
    const ViewState before = shared.state;
    open(again && shared.scene[0] ? std::filesystem::path(shared.scene) : options.scene);
    if (again) take(before);
    playing = options.play && !again;
}

void Viewer::open(const std::filesystem::path& scene) {
    keepView();
    OpenedScene input = openedScene(scene);
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
    next->setInterlude(shotSeconds, [this] { drawMeanwhile(); });
    next->cut(state);
    solving = std::move(next);
    settings = state;
    file = scene;
    chosen = {};
    drawing.rebuild();
    share();
}

void Viewer::perform(Command command) {
    requests.push_back([this, command] { obey(command); });
}

void Viewer::pick(const Place& place, int x, int y) {
    requests.push_back([this, place, x, y] {
        chosen = {drawing.pick(*solving, settings, place, x, y), {}};
        look();
    });
}

void Viewer::choose(const std::filesystem::path& scene) {
    requests.push_back([this, scene] {
        try {
            open(scene);
        } catch (const Error& error) {
            tell("This scene cannot be shown", error.what());
        }
    });
}

void Viewer::apply(const ViewState& wanted) {
    requests.push_back([this, wanted] {
        const Stopwatch watch;
        take(wanted);
        lastApply = watch.seconds();
    });
}

void Viewer::drawMeanwhile() {
    if (frameMeanwhile && settings.mode != Mode::ids) frameMeanwhile();  // its pictures call renderPatchIDs
}

void Viewer::take(const ViewState& wanted) {
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
    std::strncpy(shared.copy, made.library.string().c_str(), sizeof shared.copy - 1);
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
    removeCopy();  // it stays loaded
}

void Viewer::removeCopy() {
    std::error_code ignored;
    if (shared.copy[0]) std::filesystem::remove(shared.copy, ignored);
    shared.copy[0] = '\0';
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
    for (const auto& request : std::exchange(requests, {})) request();
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

void Viewer::obey(Command command) {
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
        case Command::firstView: camera = openedScene(file).state.camera; return;
        case Command::brighter: return exposeBy(1.2599f);
        case Command::darker: return exposeBy(1.0f / 1.2599f);
        case Command::autoExposure: settings.autoExposure = !settings.autoExposure; return;
        case Command::unpick: chosen = {}; return;
        case Command::panel: settings.panel = !settings.panel; return;
        case Command::screenshot: pendingScreenshot = true; return;
        case Command::help: help = !help; return;
        case Command::quit: return quit();
    }
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

}  // namespace radlab

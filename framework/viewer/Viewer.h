#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/Stopwatch.h"
#include "viewer/Commands.h"
#include "viewer/LibraryBuild.h"
#include "viewer/SceneDrawing.h"
#include "viewer/Simulation.h"
#include "viewer/Supervisor.h"

namespace radlab {

/// What a viewer is started with.
struct ViewerOptions {
    std::filesystem::path scene;   ///< X3D, or settings (Resource.xml) that name one
    std::filesystem::path folder;  ///< for screenshots and kept views
    LibraryRecipe library;
    float patchSize = 0.0f;  ///< 0: as kept, as the settings say, or for about 1000 patches
    int hemicubeSize = 0;    ///< 0: as kept, or as the settings say
    bool play = false;
    bool forget = false;  ///< views that were kept are passed over
};

/// Something to tell the user over the picture.
struct Banner {
    enum class Kind { note, stub, problem } kind;
    std::string title, text;
};

/// The viewer without its window: what commands do, what the panel changes, what is drawn.
///
/// What is asked for (perform, pick, choose, apply) is done by the next advance(), in its order, and never in the middle of a shot.
///
/// @pre a GlContext is current, the same one for all calls
class Viewer {
public:
    Viewer(ViewerOptions options, SharedView& shared, const Restart& restart);

    void perform(Command command);

    /// Picks what lies at a pixel of the picture, counted from its bottom left; background lets go.
    void pick(const Place& place, int x, int y);

    /// Shows another scene, as it was looked at last; one that cannot be read is told, and the one from before stays.
    void choose(const std::filesystem::path& file);

    /// Takes settings that change the mesh or the solver, and starts anew.
    void apply(const ViewState& wanted);

    /// What draws a frame where a shot takes longer than a frame should; it must not call advance().
    void setFrameMeanwhile(std::function<void()> frame) { frameMeanwhile = std::move(frame); }

    /// What happens between two frames: what was asked for is done, a library that was built is taken, shots are made, the view is
    /// kept.
    void advance();

    /// Whether something that was asked for is still to be done.
    bool hasRequests() const { return !requests.empty(); }

    void draw(const Place& place);

    ViewState& state() { return settings; }
    Simulation& simulation() { return *solving; }
    const Picked& picked() const { return chosen; }
    const std::filesystem::path& sceneFile() const { return file; }
    bool isPlaying() const { return playing; }
    bool isBuilding() const { return build.isBuilding(); }

    /// Whether the student's functions are loaded and, after a crash, the user has asked to go on.
    bool canRun() const { return functions && crash.empty(); }
    bool helpShown() const { return help; }
    bool closing() const { return ending; }

    /// How long the last change of mesh or solver took.
    double applySeconds() const { return lastApply; }

    /// What to tell over the picture: the weightiest first.
    std::vector<Banner> banners() const;

    int reloads() const { return loaded; }
    int glErrors() const { return drawing.glErrors(); }

    static constexpr double noticeSeconds = 5.0;

private:
    void open(const std::filesystem::path& file);
    void obey(Command command);
    void take(const ViewState& wanted);
    void quit();
    void drawMeanwhile();
    void load(const LibraryOutcome& made);
    void removeCopy();
    void resume();
    void giveFunctions();
    void takeLibrary();
    void show(Mode mode);
    void shoot(int most);
    void restart();
    void look();
    void exposeBy(float factor);
    void takeScreenshot();
    void tell(const std::string& title, const std::string& text);
    void keepView();
    void share();
    ViewState stateOf(const std::filesystem::path& scene, const Scene& read);

    ViewerOptions options;
    SharedView& shared;
    LibraryBuild build;
    ViewState settings;
    std::filesystem::path file;
    std::unique_ptr<Simulation> solving;
    SceneDrawing drawing;
    Picked chosen;
    std::optional<CourseFunctions> functions;
    Place lastPlace;
    std::vector<std::function<void()>> requests;
    std::function<void()> frameMeanwhile;
    std::string crash, compileError, kept;
    std::optional<Banner> notice;
    Stopwatch noticeTime, keepTime, buildTime;
    bool playing = false, help = false, ending = false, pendingScreenshot = false;
    int loaded = 0;
    double lastApply = 0.0;  // seconds
};

}  // namespace radlab

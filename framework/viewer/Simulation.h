#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/Image.h"
#include "base/Stopwatch.h"
#include "course/PatchMesh.h"
#include "scene/Effects.h"
#include "scene/Scene.h"
#include "solver/Progressive.h"
#include "viewer/Running.h"
#include "viewer/ViewState.h"

namespace radlab {

/// What went wrong in one of the six functions, for the user.
struct Problem {
    std::string function;  ///< as ProgRef.h writes it; may be empty
    bool notWritten = false;
    std::string text;  ///< the whole of it, with what to do next
};

/// One shot, as the curves show it.
struct ShotRecord {
    double unshotShare;  ///< after it
    double seconds;      ///< that it took
};

/// What a patch sees of the others.
struct PatchView {
    std::vector<float> formFactors;  ///< to each patch
    double sum = 0.0;
    Image ids, weights;  ///< the hemicube unfolded, ready for display; empty where renderPatchIDs could not draw
};

/// A scene while it is being solved by the six functions.
///
/// What they throw is caught and kept as the problem; the scene stays as it stands.
/// @pre a GlContext is current, the same one for all calls
class Simulation {
public:
    /// @param running where the function that runs is marked; outlives this
    Simulation(Scene scene, RunningNow& running);

    const Scene& scene() const { return shown; }
    PatchMesh& mesh() { return *patches; }
    const Effects& effects() const { return found; }
    const std::optional<Problem>& problem() const { return trouble; }
    const std::vector<ShotRecord>& history() const { return records; }
    const Progress& progress() const { return now; }

    /// The index of the patch that shot last; nothing before the first shot.
    std::optional<std::size_t> lastShooter() const { return shooter; }

    /// The method in use; never automatic.
    FormFactorMethod method() const { return chosen; }

    /// Whether colorReconstruction has set the colours that the patches have.
    bool hasColors() const { return coloured; }

    /// Whether nothing is left to shoot: all is black, or a thousandth of the emitted power remains.
    bool finished() const;

    /// What is done between the faces of a hemicube where a shot takes longer than so many seconds, again and again: draw a frame, say.
    ///
    /// The patches are then as the last whole shot left them. It must change nothing here, and put all OpenGL state back.
    void setInterlude(double seconds, std::function<void()> action);

    /// Takes other functions; call restart afterwards. None where there are none.
    void setFunctions(const std::optional<CourseFunctions>& functions);

    /// Cuts the scene into patches of the state's sizes, and restarts.
    ///
    /// Errors: more patches than a picture can be drawn of; those of the Mesher. All is then as it was.
    void cut(const ViewState& state);

    /// Puts everything back to before the first shot, with the state's method and hemicube.
    void restart(const ViewState& state);

    /// Shoots until so many shots are done or the time is over, at least once, and sets the colours.
    ///
    /// @return how many shots were made; fewer where all is done or something went wrong
    int shoot(int most, double seconds);

    /// Does something that calls the six functions; what it throws becomes the problem.
    ///
    /// @return whether it threw nothing
    bool attempt(const std::function<void()>& action);
    void forgetProblem() { trouble.reset(); }

    /// The student's form factors from a patch, and the hemicube that it sees; nothing where something went wrong.
    std::optional<PatchView> lookFrom(std::size_t patch);

private:
    bool shootOnce();
    void interlude();
    void giveUp(const std::string& text);
    MyPolygon* setFormFactors();
    void setRow(std::size_t patch);

    Scene shown;
    RunningNow& running;
    std::optional<CourseFunctions> course;
    std::unique_ptr<PatchMesh> patches;
    std::unique_ptr<Hemicube> hemicube;
    std::unique_ptr<Progressive> solver;
    Effects found;
    FormFactorMethod chosen = FormFactorMethod::hemicube;
    Progress now;
    std::function<void()> meanwhile;
    double interludeAfter = 0.0, interludeSeconds = 0.0;
    Stopwatch sinceInterlude;
    std::vector<float> row;  // the form factors of the last whole shot, while another is made
    bool shooting = false;
    std::optional<Problem> trouble;
    std::vector<ShotRecord> records;
    std::optional<std::size_t> shooter;
    bool coloured = false;
};

/// The longest edge of patches of which there are about so many.
float patchSizeFor(const Scene& scene, double count);

}  // namespace radlab

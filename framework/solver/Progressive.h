#pragma once

#include <functional>

#include "course/PatchMesh.h"
#include "solver/CourseFunctions.h"

namespace radlab {

/// How far the light has been followed, after a shot. Powers are in W times the scene's unit of area over m², the
/// three channels added up.
struct Progress {
    int shots = 0;
    double seconds = 0.0;      ///< spent in the course's functions
    double unshotShare = 1.0;  ///< unshot power over emitted power
    double emitted = 0.0;
    double absorbed = 0.0;
    double escaped = 0.0;  ///< left the scene, or lost where the form factors of a shooter do not sum to 1
    double unshot = 0.0;

    /// What has become of the emitted power; equals emitted where energy is conserved.
    double total() const { return absorbed + escaped + unshot; }
};

/// When to stop shooting: whichever comes first.
struct Limits {
    int shots = 100000;
    double unshotShare = 1e-3;
};

/// Progressive refinement over the course's functions: form factors of the brightest patch, then its shot.
///
/// @source [Cohen1988]
class Progressive {
public:
    /// Sets form factors from the brightest of `polygons` and returns it: calcAnalyticalFF, or calcFF on a hemicube.
    using FormFactors = std::function<MyPolygon*()>;

    /// Publishes the mesh and starts from its emission.
    ///
    /// @param functions whose distributeEnergy and colorReconstruction are called
    /// @pre the mesh outlives this
    Progressive(PatchMesh& mesh, FormFactors formFactors, CourseFunctions functions = linkedFunctions());

    /// One shot.
    ///
    /// @return false where nothing is left to shoot
    /// Errors: NotImplemented of a stub; radiosities that are no longer finite.
    bool shoot();

    /// Shoots until a limit is reached or nothing is left, then calls colorReconstruction.
    ///
    /// @param report called after each shot; may be empty; returning false stops
    const Progress& run(const Limits& limits, const std::function<bool(const Progress&)>& report = {});

    const Progress& progress() const { return state; }

private:
    void account(const MyPolygon& shooter, const Vec3f& shot);

    PatchMesh& mesh;
    FormFactors formFactors;
    CourseFunctions course;
    Progress state;
};

}  // namespace radlab

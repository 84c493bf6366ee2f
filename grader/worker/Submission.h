#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "course/Vec3f.h"

class Hemicube;
class MirrorPass;
class PictureView;
class RandomNumbers;
class RayCaster;
struct MyPolygon;

namespace radlab {
class Image;
}

namespace radlab::grader {

/// The six functions of a submission, or an extension's, out of its shared library.
///
/// Whatever in this process calls one of the six by name, the library itself included, comes through here: so the worker can stand in for
/// maxenergy_patch and renderPatchIDs where others call them, and a mistake in one does not reach the others.
class Submission {
public:
    /// Loads the library, which runs its initialisers.
    ///
    /// Errors: what the dynamic linker says.
    explicit Submission(const std::filesystem::path& library);

    /// Whether the library has the function of that name, with the parameters that the course's header declares.
    bool has(const std::string& function) const;

    /// Calls the library's own function, whatever stands in.
    MyPolygon* maxenergyPatch() const;
    MyPolygon* calcAnalyticalFF() const;
    bool distributeEnergy(MyPolygon* shooter) const;
    void colorReconstruction() const;
    void renderPatchIDs() const;
    MyPolygon* calcFF(Hemicube* hemicube) const;
    MyPolygon* hemisphereFF(const RayCaster& scene, int rays, RandomNumbers& random) const;
    void antialias(const PictureView& view, int samples, Image& picture) const;
    void mirrorScene(const MirrorPass& pass, const Vec3f& point, const Vec3f& normal, const Vec3f& reflectance,
                     Image& picture) const;

    /// What calls of maxenergy_patch by others return while standing in, and that renderPatchIDs is ours.
    void standIn(MyPolygon* shooter);
    /// From now on the library's functions call each other.
    void standAside();

    bool isStandingIn() const { return standing; }
    MyPolygon* shooterStandIn() const { return brightest; }

    /// The one that is loaded.
    static Submission& loaded();

private:
    template <class Function>
    Function* find(const std::string& function) const;

    void* library;
    bool standing = false;
    MyPolygon* brightest = nullptr;
};

}  // namespace radlab::grader

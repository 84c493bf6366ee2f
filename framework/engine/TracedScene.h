#pragma once

#include <vector>

#include "engine/Geometry.h"
#include "engine/RayScene.h"
#include "engine/Scattering.h"
#include "engine/Triangles.h"

namespace radlab::engine {

/// A point of a patch that a ray met.
struct SurfacePoint {
    std::size_t patch = RayHit::nothing;
    Point position{0.0};
    bool front = false;  ///< met from its front

    bool exists() const { return patch != RayHit::nothing; }
};

/// Patches and what their materials do with light, for rays to meet.
class TracedScene {
public:
    /// @param scatterings of each face
    /// @pre   the geometry outlives this
    TracedScene(const Geometry& geometry, std::vector<Scattering> scatterings);

    /// What a ray meets first.
    ///
    /// @param direction of unit length
    /// @param start     the patch that the ray leaves, RayHit::nothing for none
    SurfacePoint meet(const Point& from, const Point& direction, std::size_t start, Sides sides) const;

    /// The share of light that gets from a point of one patch to a point of another.
    double transmittance(const Point& from, const Point& to, std::size_t first, std::size_t second) const;

    const std::vector<Polygon>& patches() const { return geometry.patches; }
    const std::vector<std::size_t>& faceOf() const { return geometry.faceOf; }
    const Scattering& scattering(std::size_t patch) const { return scatterings[geometry.faceOf[patch]]; }

    /// How many rays were traced so far.
    std::size_t rays() const { return rayScene.rays(); }

private:
    const Geometry& geometry;
    std::vector<Scattering> scatterings;
    RayScene rayScene;
    std::vector<double> through;  // of each patch; empty where all are opaque
};

}  // namespace radlab::engine

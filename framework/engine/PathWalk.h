#pragma once

#include "engine/Emitters.h"
#include "engine/RandomNumbers.h"
#include "engine/TracedScene.h"

namespace radlab::engine {

/// Random walks against the light: what arrives is the mean of what they bring back.
///
/// At a point a walk goes straight on, bounces diffusely or bounces about the mirror direction, by chance. Unless it
/// meets a mirror, a point of an emitter is drawn too, and what both ways may find is weighted by the balance
/// heuristic, so that no sample is ever larger than the light itself. After a few bounces it goes on with a probability
/// of what it carries.
///
/// Errors: a walk of a million bounces, as in a closed room that swallows nothing.
/// @source [Kajiya1986]; [VeachGuibas1995] balance heuristic; [ArvoKirk1990] Russian roulette
class PathWalk {
public:
    /// @param constantPatches walks go on from another point of the patch that they meet: they obey B = E + ρ·F·B
    /// @pre   the scene outlives this
    PathWalk(const TracedScene& scene, bool constantPatches);

    /// The radiance that a camera sees in a direction.
    Point radiance(const Point& eye, const Point& direction, const Point& background, RandomNumbers& random) const;

    /// The radiance that arrives at a point of a patch, in the mean that the cosine weighs: irradiance over π; two
    /// numbers from 0 to 1 choose the direction that the walk starts in.
    Point arriving(std::size_t patch, const Point& point, double u, double v, RandomNumbers& random) const;

    /// A point of a patch for two numbers from 0 to 1.
    Point pointOf(std::size_t patch, double u, double v) const { return samplers[patch].at(u, v); }

private:
    // Where a walk goes next, and the share of what it meets that counts.
    struct Step {
        Point from, direction;
        std::size_t start = RayHit::nothing;
        Point share{1.0};
        bool straight = false;  // from the camera
        double density = 0.0;   // with which the last bounce drew its direction, 0 for mirrors and the camera,
        Point bouncedAt{0.0};   // and its place
        int bounces = 0;
    };

    Point follow(Step step, const Point& background, RandomNumbers& random) const;
    bool scatter(Step& step, const SurfacePoint& met, Point& found, RandomNumbers& random) const;
    void bounceDiffusely(Step& step, const SurfacePoint& met, Point& found, RandomNumbers& random) const;
    bool bounceSpecularly(Step& step, const SurfacePoint& met, Point& found, RandomNumbers& random) const;
    void leaveDiffusely(Step& step, std::size_t patch, const Point& point, double u, double v) const;
    Point reflectedDiffusely(std::size_t patch, const Point& point, RandomNumbers& random) const;

    const TracedScene& scene;
    bool resampled;
    Emitters emitters;
    std::vector<AreaSampler> samplers;
};

}  // namespace radlab::engine

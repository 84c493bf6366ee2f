// Extension 1: form factors by rays over the hemisphere. Worth no marks; ./radlab check hemisphere judges it.
//
// Extensions.h brings all that ProgRef.h does, and RayCaster and RandomNumbers.

#include "Extensions.h"

// Find the brightest patch s, set formF of every patch to the form factor from s, and return s, as calcFF does, but by
// rays. All start at the centre of s. Draw their directions so that their density is cosθ/π, θ being the angle to the
// normal: draw a point evenly from the unit disc, and lift it straight up onto the hemisphere above; then turn the
// hemisphere so that its pole is the normal of s. Each ray then carries the same share of the power of s, so the patch
// that it meets gets 1/rays. What a ray meets first is scene.hit(origin, direction, s), which leaves out s itself, as
// the ray starts there; nullptr where it leaves the scene. Return nullptr where there are no patches.
// You may call: maxenergy_patch, scene.hit, random.next (from 0 to 1), cross, dot, normalize, std::sqrt, std::cos,
// std::sin.
MyPolygon* hemisphereFF(const RayCaster& scene, int rays, RandomNumbers& random) {
    // TODO extension 1
    (void)scene, (void)rays, (void)random;
    throw NotImplemented("hemisphereFF");
}

#pragma once

#include <cstdint>
#include <random>

#include "grader/protocol/State.h"

namespace radlab::grader {

/// Numbers drawn from a seed, the same on every machine.
class Random {
public:
    explicit Random(std::uint64_t seed) : engine(seed) {}

    /// From low up to, but not with, high.
    double between(double low, double high) {
        return low + (high - low) * static_cast<double>(engine() >> 11) * 0x1p-53;
    }
    /// Spread evenly over the orders of magnitude from low to high, both > 0.
    double magnitude(double low, double high);
    /// From 0 to count - 1.
    int index(std::size_t count) { return static_cast<int>(engine() % count); }
    Vec3f vector(double low, double high);
    /// Unit vector, all directions alike.
    Vec3f direction();

private:
    std::mt19937_64 engine;
};

/// Adds a patch with the given corners (3 or 4, planar, counter-clockwise seen from the front), its centre, normal and area
/// set; returns its index. Corners are not shared with other patches.
int addPatch(State& state, const std::vector<Vec3f>& corners);

/// A rectangle, or a right triangle, in the plane through center that is at right angles to normal; its centre of area is center.
std::vector<Vec3f> rectangle(const Vec3f& center, const Vec3f& normal, float width, float height, float turn = 0.0f);
std::vector<Vec3f> triangle(const Vec3f& center, const Vec3f& normal, float width, float height, float turn = 0.0f);

/// The six sides of the axis-parallel box from low to high, their fronts inside or outside.
std::vector<std::vector<Vec3f>> sidesOfBox(const Vec3f& low, const Vec3f& high, bool inside);

/// Sets what light does on a patch to random values: reflectance and radiosities that differ by channel, rad >= unshot_rad, a
/// form factor, and a stale colour.
void randomLight(Random& random, State& state);

/// Patches of random sizes, quads and triangles, in random places of a cube of edge 20, turned at random.
State scattered(Random& random, int count);

/// A closed box with fronts inside, of random edges from 1 to 2 and random subdivision, with `blocks` smaller boxes (fronts
/// outside) and triangles in it; the patches of a face share their corners.
State room(Random& random, float patchSize, int blocks);

/// Shuffles the order of the patches.
void shuffle(Random& random, State& state);

}  // namespace radlab::grader

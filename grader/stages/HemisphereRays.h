#pragma once

#include <functional>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "grader/stages/Remembered.h"
#include "grader/stages/Stage.h"

namespace radlab::grader {

/// Numbers from 0 to 1 that a ray is drawn from.
using Draw = glm::dvec4;

/// A direction over the z axis, of any length.
using LocalDirection = std::function<glm::dvec3(const Draw& draw)>;

/// The matrix that carries the z axis to a unit normal.
using Frame = std::function<glm::dmat3(const glm::dvec3& normal)>;

/// What becomes of a shot's rays: the share of each patch, and of all.
struct RayShares {
    std::vector<double> patches;  ///< mean weight of a ray that meets the patch, by index; mean over all rays
    double met = 0.0;             ///< share of the rays that meet anything
};

/// How a program sends the rays of hemisphereFF and counts them: the right way, or one that people take instead.
struct RayUse {
    std::string name = "cosine";  ///< unlike that of any other use that draws or weights in another way
    LocalDirection direction;     ///< by default with the density cosθ/π
    Frame frame;                  ///< by default orthonormal
    bool fromArea = false;        ///< rays start all over the patch, not at its centre
    bool leavesOutShooter = true;
    std::function<double(double cosine)> weight;                                         ///< of a ray; by default 1
    double most = 1.0;                                                                   ///< the largest weight
    std::function<double(int rays, double met)> over = [](int, double) { return 1.0; };  ///< times 1/rays
    bool addsToLast = false;                                                             ///< to what formF held before
    bool returnsShooter = true;
    double whole = 0.0;  ///< whether form factors are multiples of 1/rays: 0 all are, 1 not all, NaN either
};

/// With the density cosθ/π, by lifting the unit disc.
///
/// @source [Malley1988]
glm::dvec3 cosineDirection(const Draw& draw);

/// Three axes of length 1 at right angles, the last one the normal.
glm::dmat3 orthonormalFrame(const glm::dvec3& normal);

/// Whether every form factor is a whole number of rays over all rays, as far as sums of floats are.
bool areShares(const State& state, int rays);

/// The expected outcome of shots by rays, found without chance: by evenly spread rays instead of random ones.
class RayShooter {
public:
    /// What a use of rays leaves on average: slack says how far chance may take it from there once in 10¹², pixels are
    /// the use's `whole` and how far the sum of all form factors may be off.
    Computation shoots(const RayUse& use) const;

    /// The shares of a shot from that patch.
    ///
    /// @return right to 1e-3
    /// @cost  16,384 rays the first time
    std::shared_ptr<const RayShares> shares(const State& state, int shooter, const RayUse& use) const;

private:
    using Known = Remembered<RayShares, 4096>;  // some 20 shots, and what each mistake makes of them

    std::shared_ptr<Known> known = std::make_shared<Known>();
};

/// One ray of a use from a patch of a scene: whom it meets, and its weight.
///
/// For tests it sends random rays, too.
class RayScene {
public:
    explicit RayScene(State scene);
    ~RayScene();

    /// @return the index of the patch that is met, -1 for none
    int send(const RayUse& use, int shooter, const Draw& draw, const Draw& start, double& weight) const;

private:
    struct Parts;
    std::unique_ptr<Parts> parts;
};

}  // namespace radlab::grader

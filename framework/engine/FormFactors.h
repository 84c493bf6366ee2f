#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/FormFactorMatrix.h"
#include "engine/Geometry.h"
#include "engine/Parallel.h"

namespace radlab::engine {

/// The ways to find form factors.
enum class Method {
    point,       ///< centre to centre; wrong where patches are near, sees nothing hidden
    polygon,     ///< from the centre to the whole polygon; sees nothing hidden
    exact,       ///< polygon to polygon, to any tolerance; sees nothing hidden
    hemicube,    ///< from the centre by pixels of a hemicube; sees what is hidden
    hemisphere,  ///< rays over the hemisphere: error √(F(1-F)/rays) or less; sees what is hidden
    visibility,  ///< exact, times the share that shadow rays find visible
    automatic,   ///< exact where nothing can hide anything, else visibility
};

/// The method of that name.
///
/// Errors: no such name.
Method methodNamed(const std::string& name);
std::string nameOf(Method method);

/// Whether a method's matrix has Ai·Fij = Aj·Fji by the way it is made; others need makeReciprocal to be solved.
bool isReciprocal(Method method);

/// Whether a method takes into account what stands between patches.
bool seesOcclusion(Method method);

constexpr std::size_t hemisphereRays = 4096, pairRays = 64;  ///< where none are given

struct FormFactorOptions {
    Method method = Method::automatic;
    bool occlusion = true;  ///< whether anything may hide anything: decides what `automatic` is
    std::size_t rays =
        0;  ///< from each patch for `hemisphere`, for each pair partly hidden for `visibility`; 0: as usual
    int hemicubeSize = 256;  ///< pixels along the edge of a hemicube: even, 8 to 4096
    std::uint64_t seed = 0;  ///< of `visibility`: another one chooses other rays
    double tolerance =
        1e-6;           ///< of the relative error of what is not hidden, for `exact` and `visibility`; 1e-12 or more
    Progress progress;  ///< counts rows
};

/// The same options with the method that `automatic` stands for, and the numbers of rays that 0 stands for.
FormFactorOptions settled(FormFactorOptions options);

/// What a matrix was made with.
struct FormFactorReport {
    Method method = Method::automatic;  ///< never `automatic`
    std::size_t rays = 0;               ///< traced in all: 0 where nothing may hide anything
    double seconds = 0.0;
};

/// The form factors between all pairs of patches.
///
/// Through panes (Geometry::through) hemisphere and visibility let light pass: it is counted at the pane and, as far as
/// it gets through, behind it too, so that rows may add up to more than 1.
///
/// The same to the bit for any number of threads.
///
/// @cost point, polygon, exact, visibility: a function of pairs; hemicube, hemisphere: pictures or rays from each patch.
///       On all cores.
/// Errors: more memory than there is; a hemicube size out of its range.
FormFactorMatrix formFactors(const Geometry& geometry, const FormFactorOptions& options,
                             FormFactorReport* report = nullptr);

}  // namespace radlab::engine

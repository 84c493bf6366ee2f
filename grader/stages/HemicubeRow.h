#pragma once

#include <vector>

#include "grader/stages/IdRaster.h"

namespace radlab::grader {

/// Below this sine of the angle between them, up and direction count as parallel.
inline constexpr double parallelSine = 1e-5;

/// The five views of a Hemicube of that size at a patch, as Hemicube::renderScene sets them.
///
/// @param eye        centre of the patch, in world coordinates
/// @param up         any vector not along direction; what is up in the buffer
/// @param direction  the patch's normal, of any length above 0
/// @param size       edge of the top face in pixels, even and at least 2
/// Errors: up or direction zero, not finite or parallel.
/// @cost   linear in the number of patches, for the near plane
/// @source [CohenGreenberg1985]
std::vector<IdView> hemicubeViews(const State& state, const Vec3f& eye, const Vec3f& up, const Vec3f& direction,
                                  int size);

/// What a Hemicube of that size holds after renderScene and readIndexBuffer, found without OpenGL.
struct HemicubeBuffer {
    int size = 0;   ///< edge of the top face in pixels; the image has twice as many each way
    IdImage image;  ///< by patch index: Hemicube::getIndex less 1
};

/// Draws the patches into the five faces of a hemicube.
///
/// @param eye, up, direction, size  as for hemicubeViews, with its errors
/// @param style  how the function that draws patch IDs draws them
/// @cost  that of rasterIds with five views
/// @source [CohenGreenberg1985]
HemicubeBuffer hemicubeBuffer(const State& state, const Vec3f& eye, const Vec3f& up, const Vec3f& direction, int size,
                              const RasterStyle& style = {});

/// Form factors from one patch to all, with how far a right program's may lie from them.
struct Row {
    std::vector<double> values;  ///< F(s→j) by patch: 0 to 1
    std::vector<double> slack;   ///< the largest difference that pixels which are not sure, and sums in floats, explain
};

/// Adds up the delta form factors of the pixels that show each patch.
///
/// @param deltas      of a hemicube of the buffer's size, from deltaFormFactors()
/// @param patchCount  of the state that was drawn
/// @return for each patch its sum, and as slack the sum over the pixels that are not sure and that it may win or lose,
///         plus what adding in floats may cost
/// @cost  linear in pixels
/// @source [CohenGreenberg1985]
Row hemicubeRow(const HemicubeBuffer& buffer, const std::vector<float>& deltas, std::size_t patchCount);

}  // namespace radlab::grader

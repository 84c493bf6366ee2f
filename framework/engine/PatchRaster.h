#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/Polygon.h"

namespace radlab::engine {

/// How wide the raster's loops run; what they draw is the same to the bit.
enum class Simd { plain, avx2, avx512 };

/// The widest that this machine and this build know.
Simd widestSimd();

/// A perspective view along one axis of a frame: x and z·bottom to z of what lies before it.
struct RasterView {
    Point eye{0.0};
    Point right{1.0, 0.0, 0.0}, up{0.0, 1.0, 0.0}, forward{0.0, 0.0, 1.0};  ///< at right angles, of length 1
    double bottom = -1.0;  ///< -1 for a square view, 0 for its upper half: x/z runs from -1 to 1, y/z from here to 1
    int width = 0;         ///< pixels from left to right; as wide as high

    int height() const { return bottom < 0.0 ? width : width / 2; }
};

/// What a view shows: for each pixel the patch, and how near it is.
class PatchImage {
public:
    static constexpr std::uint32_t nothing = 0xffffffff;

    /// Eight pixels of a row.
    struct alignas(64) Group {
        static constexpr int size = 8;
        float nearness[size];
        std::uint32_t patch[size];
    };

    /// Makes room for a view, and clears it.
    void reset(int width, int height);

    int width() const { return columns; }
    int height() const { return rows; }
    const Group* row(int y) const { return groups.data() + static_cast<std::size_t>(y) * stride; }
    Group* row(int y) { return groups.data() + static_cast<std::size_t>(y) * stride; }

    /// The patch at a pixel, `nothing` where there is none; (0, 0) is at the bottom left.
    std::uint32_t patchAt(int x, int y) const { return row(y)[x / Group::size].patch[x % Group::size]; }

    /// One over its distance along the view, about: 0 where there is none.
    float nearnessAt(int x, int y) const { return row(y)[x / Group::size].nearness[x % Group::size]; }

private:
    int columns = 0, rows = 0;
    std::size_t stride = 0;  // groups in a row
    std::vector<Group> groups;
};

/// Draws patches as the nearest of them are seen from a point, in their numbers.
///
/// A pixel shows the patch that the ray through its centre meets first, from the front or from the back. Patches that
/// share an edge leave no pixel between them. Where surfaces lie within a millionth of their distance the lower number
/// is shown. What a ray meets edge-on is not seen.
///
/// Corners are projected in doubles, and each edge gives every row of pixels that it crosses the place where it does:
/// the same place for both its patches, so that one ends where the other begins.
///
/// May draw for several threads at once.
class PatchRaster {
public:
    static constexpr int lanes = 8;

    /// Eight convex pieces of patches with four corners each; unused ones have no normal, which makes them edge-on.
    struct alignas(64) Block {
        double x[4][lanes], y[4][lanes], z[4][lanes];
        double normalX[lanes], normalY[lanes], normalZ[lanes];
        std::uint32_t patch[lanes];
    };

    /// @param polygons  convex or not, with any number of corners; those without area are never seen
    explicit PatchRaster(const std::vector<Polygon>& polygons, Simd simd = widestSimd());

    /// Draws what a view shows of all patches but one.
    ///
    /// @pre  the view's frame is at right angles, its width even
    /// @cost some 0.2 µs for each patch in view, and 5 ns for eight of its pixels, with AVX2
    void draw(const RasterView& view, std::uint32_t except, PatchImage& image) const;

private:
    std::vector<std::size_t> blocksIn(const RasterView& view) const;

    struct Spheres {
        std::vector<double> x, y, z, radius;
    };

    std::vector<Block> blocks;
    Spheres spheres;    // round each block
    double unit = 0.0;  // a length of the scene
    Simd simd;
};

}  // namespace radlab::engine

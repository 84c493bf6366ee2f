#pragma once

// The loops of PatchRaster, which is compiled for several instruction sets: lane by lane, so that a compiler turns each
// into a few wide instructions. Without fused multiplications (see CMakeLists.txt), so that all give the same bits.

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "engine/PatchRaster.h"
#include "engine/RasterClip.h"

#if defined(__GNUC__) && !defined(__clang__)
#define RADLAB_INLINE inline __attribute__((always_inline))
#define RADLAB_LANEWISE _Pragma("GCC unroll 1")  // loops that are unrolled are not made wide
#else
#define RADLAB_INLINE inline
#define RADLAB_LANEWISE
#endif

namespace radlab::engine::raster {

constexpr int lanes = PatchRaster::lanes;
constexpr int group = PatchImage::Group::size;
constexpr double slack =
    1e-5;  // pixels: so far edges that should coincide may lie apart, as coordinates were floats once
constexpr float sameDepth = 1.0f + 0x1p-20f;  // what is nearer by less counts as coincident

// The corners of a block in the frame of a view.
struct Corners {
    double x[4][lanes], y[4][lanes], w[4][lanes];
};

// Edges in pixels, each by its lower end, its height and how far it runs across for each row.
struct Edges {
    double x[mostClipped][lanes], low[mostClipped][lanes], height[mostClipped][lanes], slope[mostClipped][lanes];
};

// Pieces ready to be drawn; nearness, 1/w, is linear over the pixels.
struct Pieces {
    Edges edges;
    double low[lanes], high[lanes];  // rows
    double atOrigin[lanes], alongX[lanes], alongY[lanes];
    double farthest[lanes], nearest[lanes];  // between these, at the corners
    std::int64_t drawn[lanes], clipped[lanes];
};

RADLAB_INLINE void transform(const PatchRaster::Block& block, const RasterView& view, Corners& to) {
    for (int c = 0; c < 4; ++c) RADLAB_LANEWISE
    for (int k = 0; k < lanes; ++k) {
        const double x = block.x[c][k] - view.eye.x, y = block.y[c][k] - view.eye.y, z = block.z[c][k] - view.eye.z;
        to.x[c][k] = x * view.right.x + y * view.right.y + z * view.right.z;
        to.y[c][k] = x * view.up.x + y * view.up.y + z * view.up.z;
        to.w[c][k] = x * view.forward.x + y * view.forward.y + z * view.forward.z;
    }
}

// Which pieces may show, and which reach so far out that they need to be cut first.
RADLAB_INLINE void classify(const Corners& corners, const RasterView& view, Pieces& pieces) {
    RADLAB_LANEWISE
    for (int k = 0; k < lanes; ++k) {
        double left = -INFINITY, right = -INFINITY, below = -INFINITY, above = -INFINITY, room = INFINITY,
               low = INFINITY, high = -INFINITY;
        for (int c = 0; c < 4; ++c) {
            const double x = corners.x[c][k], y = corners.y[c][k], w = corners.w[c][k];
            left = std::max(left, w + x);
            right = std::max(right, w - x);
            below = std::max(below, y - view.bottom * w);
            above = std::max(above, w - y);
            room = std::min(room, guard * w - std::max(std::abs(x), std::abs(y)));
            low = std::min(low, w);
            high = std::max(high, w);
        }
        const double most = std::min(std::min(left, right), std::min(below, above));
        pieces.drawn[k] &= (most > 0.0) & (high > 0.0);
        pieces.clipped[k] = (room < 0.0) | (low <= 0.0);
        pieces.farthest[k] = 1.0 / high;
        pieces.nearest[k] = 1.0 / low;
    }
}

RADLAB_INLINE void planes(const PatchRaster::Block& block, const Corners& corners, const RasterView& view,
                          Pieces& pieces) {
    const double pitch = 2.0 / view.width, x0 = 0.5 * pitch - 1.0, y0 = 0.5 * pitch + view.bottom;
    RADLAB_LANEWISE
    for (int k = 0; k < lanes; ++k) {
        const double nx = block.normalX[k], ny = block.normalY[k], nz = block.normalZ[k];
        const double x = nx * view.right.x + ny * view.right.y + nz * view.right.z;
        const double y = nx * view.up.x + ny * view.up.y + nz * view.up.z;
        const double w = nx * view.forward.x + ny * view.forward.y + nz * view.forward.z;
        const double height = x * corners.x[0][k] + y * corners.y[0][k] + w * corners.w[0][k];
        const double reach = std::abs(corners.x[0][k]) + std::abs(corners.y[0][k]) + std::abs(corners.w[0][k]);
        pieces.drawn[k] = std::abs(height) > planeTolerance * reach;
        pieces.atOrigin[k] = (x * x0 + y * y0 + w) / height;
        pieces.alongX[k] = x * pitch / height;
        pieces.alongY[k] = y * pitch / height;
    }
}

RADLAB_INLINE void setEdge(Edges& edges, int e, int k, double xa, double ya, double xb, double yb) {
    const bool up = ya <= yb;
    const double low = up ? ya : yb, high = up ? yb : ya, from = up ? xa : xb, to = up ? xb : xa;
    edges.x[e][k] = from;
    edges.low[e][k] = low;
    edges.height[e][k] = high - low;
    edges.slope[e][k] = (to - from) / (high - low);
}

// Where a corner shows, in pixels: the centre of the first pixel is at 0.
RADLAB_INLINE double columnOf(const RasterView& view, double x, double w) {
    return (x / w + 1.0) * (0.5 * view.width) - 0.5;
}

RADLAB_INLINE double rowOf(const RasterView& view, double y, double w) {
    return (y / w - view.bottom) * (0.5 * view.width) - 0.5;
}

RADLAB_INLINE void project(const Corners& corners, const RasterView& view, Pieces& pieces) {
    double x[4][lanes], y[4][lanes];
    for (int c = 0; c < 4; ++c) RADLAB_LANEWISE
    for (int k = 0; k < lanes; ++k) {
        x[c][k] = columnOf(view, corners.x[c][k], corners.w[c][k]);
        y[c][k] = rowOf(view, corners.y[c][k], corners.w[c][k]);
    }
    for (int c = 0; c < 4; ++c) RADLAB_LANEWISE
    for (int k = 0; k < lanes; ++k) setEdge(pieces.edges, c, k, x[c][k], y[c][k], x[(c + 1) % 4][k], y[(c + 1) % 4][k]);
    RADLAB_LANEWISE
    for (int k = 0; k < lanes; ++k) {
        pieces.low[k] = std::min(std::min(y[0][k], y[1][k]), std::min(y[2][k], y[3][k]));
        pieces.high[k] = std::max(std::max(y[0][k], y[1][k]), std::max(y[2][k], y[3][k]));
    }
}

// The smallest whole number that is not below a number of 0 or more.
RADLAB_INLINE int wholeAbove(double value) {
    const int whole = static_cast<int>(value);
    return whole + (static_cast<double>(whole) < value);
}

struct Brush {
    double atOrigin, alongX, alongY;
    float farthest, nearest;
    std::uint32_t patch;
};

// One of two numbers by a mask of all ones or zeros: compilers make conditional stores of the operator ?:.
template <class Bits, class Number>
RADLAB_INLINE Number chosen(Bits mask, Number yes, Number no) {
    return std::bit_cast<Number>((std::bit_cast<Bits>(yes) & mask) | (std::bit_cast<Bits>(no) & ~mask));
}

RADLAB_INLINE void drawGroup(PatchImage::Group& pixels, int first, int last, float base, float step,
                             const Brush& brush) {
    const float farthest = brush.farthest, nearest = brush.nearest;
    const std::uint32_t patch = brush.patch;
    RADLAB_LANEWISE
    for (int k = 0; k < group; ++k) {
        float near = base + step * static_cast<float>(k);
        near = near < nearest ? near : nearest;
        near = near > farthest ? near : farthest;
        const float old = pixels.nearness[k];
        const std::uint32_t oldPatch = pixels.patch[k];
        const std::int32_t wins = -((k >= first) & (k < last) & (near > old));
        pixels.nearness[k] = chosen(wins, near * sameDepth, old);
        pixels.patch[k] = chosen(wins, patch, oldPatch);
    }
}

RADLAB_INLINE void drawSpan(PatchImage::Group* row, int y, int from, int to, const Brush& brush) {
    const double start = brush.atOrigin + y * brush.alongY;
    const auto step = static_cast<float>(brush.alongX);
    for (int g = from / group; g * group < to; ++g)
        drawGroup(row[g], from - g * group, to - g * group, static_cast<float>(start + brush.alongX * (g * group)),
                  step, brush);
}

struct Spans {
    int from[lanes], to[lanes];
};

// The outermost places at which edges cross each of some rows: a convex outline has two of them.
RADLAB_INLINE void crossRows(const Edges& edges, int edgeCount, int lane, int firstRow, double width, Spans& spans) {
    double rows[lanes], left[lanes], right[lanes];
    RADLAB_LANEWISE
    for (int k = 0; k < lanes; ++k) {
        rows[k] = firstRow + k;
        left[k] = width;
        right[k] = -1.0;
    }
    for (int e = 0; e < edgeCount; ++e) {
        const double x = edges.x[e][lane], low = edges.low[e][lane], height = edges.height[e][lane],
                     slope = edges.slope[e][lane], most = height + slack;
        RADLAB_LANEWISE
        for (int k = 0; k < lanes; ++k) {
            const double up = rows[k] - low, within = std::min(std::max(up, 0.0), height), at = x + within * slope;
            const double start = up >= -slack ? at : width, leftmost = up <= most ? start : width;
            const double end = up >= -slack ? at : -1.0, rightmost = up <= most ? end : -1.0;
            left[k] = std::min(left[k], leftmost);
            right[k] = std::max(right[k], rightmost);
        }
    }
    RADLAB_LANEWISE
    for (int k = 0; k < lanes; ++k) {
        left[k] = std::max(left[k] - slack, 0.0);
        right[k] = std::min(right[k] + slack, width);
    }
    RADLAB_LANEWISE
    for (int k = 0; k < lanes; ++k) {
        spans.from[k] = wholeAbove(left[k]);
        spans.to[k] = wholeAbove(right[k]);
    }
}

RADLAB_INLINE void drawPiece(const Edges& edges, int edgeCount, int lane, int firstRow, int lastRow, const Brush& brush,
                             PatchImage& image) {
    Spans spans;
    for (int y = firstRow; y < lastRow; y += lanes) {
        crossRows(edges, edgeCount, lane, y, image.width(), spans);
        for (int k = 0; k < std::min(lanes, lastRow - y); ++k)
            if (spans.from[k] < spans.to[k]) drawSpan(image.row(y + k), y + k, spans.from[k], spans.to[k], brush);
    }
}

// Cuts a piece that reaches too far out; writes its edges, and returns their number.
inline int clip(const Corners& corners, const RasterView& view, int k, Pieces& pieces) {
    Corner outline[mostClipped];
    for (int c = 0; c < 4; ++c) outline[c] = {corners.x[c][k], corners.y[c][k], corners.w[c][k]};
    const int count = clipToGuard(outline);
    Range depths, rows;
    for (int c = 0; c < count; ++c) {
        const Corner &a = outline[c], &b = outline[(c + 1) % count];
        depths.add(a.w);
        rows.add(rowOf(view, a.y, a.w));
        setEdge(pieces.edges, c, k, columnOf(view, a.x, a.w), rowOf(view, a.y, a.w), columnOf(view, b.x, b.w),
                rowOf(view, b.y, b.w));
    }
    if (!(depths.low > 0.0)) return 0;
    pieces.farthest[k] = 1.0 / depths.high;
    pieces.nearest[k] = 1.0 / depths.low;
    pieces.low[k] = rows.low;
    pieces.high[k] = rows.high;
    return count;
}

RADLAB_INLINE void drawBlock(const PatchRaster::Block& block, const RasterView& view, double unit, std::uint32_t except,
                             PatchImage& image) {
    Corners corners;
    Pieces pieces;
    transform(block, view, corners);
    planes(block, corners, view, pieces);
    classify(corners, view, pieces);
    project(corners, view, pieces);
    for (int k = 0; k < lanes; ++k) {
        if (!pieces.drawn[k]) continue;
        if (block.patch[k] == except) continue;
        const int edgeCount = pieces.clipped[k] ? clip(corners, view, k, pieces) : 4;
        const double height = image.height();
        const int firstRow = wholeAbove(std::clamp(pieces.low[k] - slack, 0.0, height)),
                  lastRow = wholeAbove(std::clamp(pieces.high[k] + slack, 0.0, height));
        const Brush brush = {pieces.atOrigin[k] * unit,
                             pieces.alongX[k] * unit,
                             pieces.alongY[k] * unit,
                             static_cast<float>(pieces.farthest[k] * unit),
                             static_cast<float>(pieces.nearest[k] * unit),
                             block.patch[k]};
        drawPiece(pieces.edges, edgeCount, k, firstRow, lastRow, brush, image);
    }
}

}  // namespace radlab::engine::raster

#include "engine/PatchRaster.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/PatchRasterLoops.h"
#include "engine/Triangles.h"

namespace radlab::engine {

namespace {

using Quad = std::array<Point, 4>;
using Block = PatchRaster::Block;

// Cutting into convex pieces moves corners by a rounding error, and neighbours would no longer share them.
Point nearestCorner(const Polygon& polygon, const Point& point) {
    return *std::min_element(polygon.corners.begin(), polygon.corners.end(), [&](const Point& a, const Point& b) {
        return glm::distance(a, point) < glm::distance(b, point);
    });
}

std::vector<Quad> quadsOf(const Polygon& polygon) {
    std::vector<Quad> quads;
    for (const Polygon& piece : convexPiecesOf(polygon)) {
        std::vector<Point> corners;
        for (const Point& corner : piece.corners) corners.push_back(nearestCorner(polygon, corner));
        const std::size_t last = corners.size() - 1;
        for (std::size_t i = 1; i < last; i += 2)
            quads.push_back({corners[0], corners[i], corners[i + 1], corners[std::min(i + 2, last)]});
    }
    return quads;
}

void place(Block& block, int lane, const Quad& quad, const Point& normal, std::uint32_t patch) {
    for (int c = 0; c < 4; ++c) {
        const Point& corner = quad[static_cast<std::size_t>(c)];
        block.x[c][lane] = corner.x;
        block.y[c][lane] = corner.y;
        block.z[c][lane] = corner.z;
    }
    block.normalX[lane] = normal.x;
    block.normalY[lane] = normal.y;
    block.normalZ[lane] = normal.z;
    block.patch[lane] = patch;
}

struct Sphere {
    Point center;
    double radius;
};

Sphere sphereRound(const std::vector<Point>& points) {
    Sphere sphere{points.front(), 0.0};
    Point low = sphere.center, high = low;
    for (const Point& point : points) {
        low = glm::min(low, point);
        high = glm::max(high, point);
    }
    sphere.center = 0.5 * (low + high);
    double size = 0.0;
    for (const Point& point : points) {
        sphere.radius = std::max(sphere.radius, glm::distance(sphere.center, point));
        size = std::max(size, glm::length(point));
    }
    sphere.radius += 1e-12 * (size + sphere.radius);
    return sphere;
}

using DrawBlocks = void(const std::vector<Block>&, const std::vector<std::size_t>&, const RasterView&, double,
                        std::uint32_t, PatchImage&);

RADLAB_INLINE void drawAll(const std::vector<Block>& blocks, const std::vector<std::size_t>& which,
                           const RasterView& view, double unit, std::uint32_t except, PatchImage& image) {
    for (const std::size_t b : which) raster::drawBlock(blocks[b], view, unit, except, image);
}

void drawPlain(const std::vector<Block>& blocks, const std::vector<std::size_t>& which, const RasterView& view,
               double unit, std::uint32_t except, PatchImage& image) {
    drawAll(blocks, which, view, unit, except, image);
}

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define RADLAB_HAVE_WIDE

__attribute__((target("avx2"))) void drawAvx2(const std::vector<Block>& blocks, const std::vector<std::size_t>& which,
                                              const RasterView& view, double unit, std::uint32_t except,
                                              PatchImage& image) {
    drawAll(blocks, which, view, unit, except, image);
}

__attribute__((target("avx512f,avx512vl,avx512dq,avx512bw,prefer-vector-width=512"))) void drawAvx512(
    const std::vector<Block>& blocks, const std::vector<std::size_t>& which, const RasterView& view, double unit,
    std::uint32_t except, PatchImage& image) {
    drawAll(blocks, which, view, unit, except, image);
}

DrawBlocks* drawingBy(Simd simd) {
    return simd == Simd::avx512 ? drawAvx512 : simd == Simd::avx2 ? drawAvx2 : drawPlain;
}
#else
DrawBlocks* drawingBy(Simd) { return drawPlain; }
#endif

}  // namespace

Simd widestSimd() {
#ifdef RADLAB_HAVE_WIDE
    if (__builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw"))
        return Simd::avx512;
    if (__builtin_cpu_supports("avx2")) return Simd::avx2;
#endif
    return Simd::plain;
}

void PatchImage::reset(int width, int height) {
    columns = width;
    rows = height;
    stride = static_cast<std::size_t>((width + Group::size - 1) / Group::size);
    Group empty;
    std::fill(std::begin(empty.nearness), std::end(empty.nearness), 0.0f);
    std::fill(std::begin(empty.patch), std::end(empty.patch), nothing);
    groups.assign(stride * static_cast<std::size_t>(height), empty);
}

PatchRaster::PatchRaster(const std::vector<Polygon>& polygons, Simd wanted) : simd(wanted) {
    std::vector<Point> corners;
    int lane = lanes;
    const auto close = [&] {
        if (corners.empty()) return;
        const Sphere sphere = sphereRound(corners);
        spheres.x.push_back(sphere.center.x);
        spheres.y.push_back(sphere.center.y);
        spheres.z.push_back(sphere.center.z);
        spheres.radius.push_back(sphere.radius);
        corners.clear();
    };
    for (std::size_t i = 0; i < polygons.size(); ++i)
        for (const Quad& quad : quadsOf(polygons[i])) {
            if (lane == lanes) {
                close();
                blocks.push_back({});
                lane = 0;
            }
            place(blocks.back(), lane++, quad, polygons[i].normal, static_cast<std::uint32_t>(i));
            corners.insert(corners.end(), quad.begin(), quad.end());
            for (const Point& corner : quad) unit = std::max(unit, glm::length(corner));
        }
    close();
}

std::vector<std::size_t> PatchRaster::blocksIn(const RasterView& view) const {
    std::vector<std::size_t> found;
    for (std::size_t b = 0; b < blocks.size(); ++b) {
        const Point to = Point(spheres.x[b], spheres.y[b], spheres.z[b]) - view.eye;
        const double x = glm::dot(to, view.right), y = glm::dot(to, view.up), w = glm::dot(to, view.forward);
        const double reach = std::numbers::sqrt2 * spheres.radius[b];
        const double most = std::min(std::min(w + x, w - x), std::min(y - view.bottom * w, w - y));
        if (most > -reach) found.push_back(b);
    }
    return found;
}

void PatchRaster::draw(const RasterView& view, std::uint32_t except, PatchImage& image) const {
    image.reset(view.width, view.height());
    drawingBy(simd)(blocks, blocksIn(view), view, unit, except, image);
}

}  // namespace radlab::engine

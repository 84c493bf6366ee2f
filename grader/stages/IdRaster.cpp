#include "grader/stages/IdRaster.h"

#include <algorithm>
#include <cmath>

#include "base/Error.h"

namespace radlab::grader {

namespace {

using DrawnCorners = RasterStyle::Corners;
using Cull = RasterStyle::Cull;
using Facing = ScreenPolygon::Facing;

struct Fragment {
    std::size_t pixel;
    int patch;
    Coverage coverage;
};

// How many of a patch's corners are drawn; 0 where it is not drawn.
int cornersDrawn(const MyPolygon& patch, DrawnCorners corners) {
    if (corners == DrawnCorners::quadsOnly && patch.vertices != 4) return 0;
    if (corners == DrawnCorners::trianglesOnly && patch.vertices != 3) return 0;
    return corners == DrawnCorners::firstThree ? 3 : patch.vertices;
}

bool culled(Facing facing, Cull cull) {
    return (cull == Cull::back && facing == Facing::back) || (cull == Cull::front && facing == Facing::front);
}

void checkPatches(const State& state) {
    for (const MyPolygon& patch : state.patches) {
        RADLAB_CHECK((patch.vertices == 3 || patch.vertices == 4));
        for (int i = 0; i < patch.vertices; ++i) {
            const bool known = patch.vertex[i] >= 0 && static_cast<std::size_t>(patch.vertex[i]) < state.corners.size();
            RADLAB_CHECK(known);
        }
    }
}

// Both ways to cut a quadrilateral into triangles; OpenGL does not say which is taken, Mesa takes the first.
constexpr int splits[2][2][3] = {{{0, 1, 3}, {1, 2, 3}}, {{0, 1, 2}, {0, 2, 3}}};

// Draws into one view; sink is called with each Fragment that an OpenGL may draw.
template <class Sink>
class ViewRaster {
public:
    ViewRaster(const State& drawn, const IdView& from, const RasterStyle& how, int bufferWidth, Sink& to)
        : state(drawn), view(from), style(how), width(bufferWidth), sink(to) {
        corners.reserve(state.corners.size());
        for (const MyVertex& corner : state.corners)
            corners.push_back(clipCorner(glm::dvec3(corner.position), view.clipFromWorld));
    }

    void draw(int index) const {
        const MyPolygon& patch = state.patches[static_cast<std::size_t>(index)];
        const int count = cornersDrawn(patch, style.corners);
        if (count == 0) return;
        ClipPolygon clipped;
        for (int i = 0; i < count; ++i) clipped.add(corner(patch, i));
        if (!clipped.cut()) return;
        const ScreenPolygon polygon(clipped, view, style.subpixelBits);
        if (polygon.empty()) return;
        if (count == 3 || polygon.convex())
            drawConvex(polygon, index);
        else
            drawSplit(patch, index);
    }

private:
    const ClipCorner& corner(const MyPolygon& patch, int i) const {
        return corners[static_cast<std::size_t>(patch.vertex[i])];
    }

    std::size_t pixel(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
    }

    // What is known at a pixel, with what culling leaves of it.
    Coverage coverage(const ScreenPolygon& polygon, Facing facing, int x, int y) const {
        Coverage found = polygon.coverage(x + 0.5, y + 0.5);
        if (style.cull != Cull::none && facing == Facing::unclear) found.certain = false;
        return found;
    }

    // Which way a polygon faces, where that matters.
    Facing facingOf(const ScreenPolygon& polygon) const {
        return style.cull == Cull::none ? Facing::front : polygon.facing();
    }

    void drawConvex(const ScreenPolygon& polygon, int index) const {
        const Facing facing = facingOf(polygon);
        if (culled(facing, style.cull)) return;
        for (int y = polygon.first.y; y <= polygon.last.y; ++y) {
            const glm::ivec2 row = polygon.row(y);
            for (int x = row.x; x <= row.y; ++x)
                if (const Coverage found = coverage(polygon, facing, x, y); found.touched)
                    sink({pixel(x, y), index, found});
        }
    }

    struct Piece {
        ScreenPolygon polygon;
        Facing facing;
    };

    // The triangles of one way to cut a quadrilateral that are drawn.
    std::vector<Piece> triangles(const MyPolygon& patch, const int (&split)[2][3]) const {
        std::vector<Piece> found;
        for (const auto& three : split) {
            ClipPolygon clipped;
            for (const int i : three) clipped.add(corner(patch, i));
            if (!clipped.cut()) continue;
            const ScreenPolygon polygon(clipped, view, style.subpixelBits);
            if (polygon.empty()) continue;
            if (const Facing facing = facingOf(polygon); !culled(facing, style.cull))
                found.push_back({polygon, facing});
        }
        return found;
    }

    Coverage unite(const std::vector<Piece>& pieces, int x, int y) const {
        Coverage all;
        for (const auto& [polygon, facing] : pieces) {
            const glm::ivec2 at(x, y);
            if (at != glm::clamp(at, polygon.first, polygon.last)) continue;
            const Coverage found = coverage(polygon, facing, x, y);
            if (!found.touched) continue;
            all.low = all.touched ? std::min(all.low, found.low) : found.low;
            all.high = all.touched ? std::max(all.high, found.high) : found.high;
            if (!all.inside) all.depth = found.depth;
            all.touched = true;
            all.inside = all.inside || found.inside;
            all.certain = all.certain || found.certain;
        }
        return all;
    }

    // The shortest range that holds both; one that is empty holds nothing.
    static glm::ivec2 joined(const glm::ivec2& a, const glm::ivec2& b) {
        if (a.x > a.y) return b;
        if (b.x > b.y) return a;
        return {std::min(a.x, b.x), std::max(a.y, b.y)};
    }

    // A quadrilateral that is not convex on screen looks different by how OpenGL cuts it; it is certain where both ways
    // agree.
    void drawSplit(const MyPolygon& patch, int index) const {
        const std::vector<Piece> ways[2] = {triangles(patch, splits[0]), triangles(patch, splits[1])};
        int firstRow = view.y + view.height, lastRow = -1;
        for (const auto& way : ways)
            for (const Piece& piece : way) {
                firstRow = std::min(firstRow, piece.polygon.first.y);
                lastRow = std::max(lastRow, piece.polygon.last.y);
            }
        for (int y = firstRow; y <= lastRow; ++y) {
            glm::ivec2 row(view.x + view.width, -1);
            for (const auto& way : ways)
                for (const Piece& piece : way)
                    if (y >= piece.polygon.first.y && y <= piece.polygon.last.y)
                        row = joined(row, piece.polygon.row(y));
            for (int x = row.x; x <= row.y; ++x) {
                const Coverage one = unite(ways[0], x, y), other = unite(ways[1], x, y);
                if (!one.touched && !other.touched) continue;
                Coverage both = one.touched ? one : other;
                if (one.touched && other.touched) {
                    both.low = std::min(one.low, other.low);
                    both.high = std::max(one.high, other.high);
                }
                both.inside = one.inside;
                both.certain = one.certain && other.certain;
                sink({pixel(x, y), index, both});
            }
        }
    }

    const State& state;
    const IdView& view;
    const RasterStyle& style;
    const int width;
    Sink& sink;
    std::vector<ClipCorner> corners;
};

template <class Sink>
void rasterInto(Sink& sink, const State& state, std::span<const IdView> views, int width, int height,
                const RasterStyle& style) {
    checkPatches(state);
    const int count = static_cast<int>(state.patches.size());
    for (const IdView& view : views) {
        RADLAB_CHECK(view.x >= 0);
        RADLAB_CHECK(view.y >= 0);
        RADLAB_CHECK(view.x + view.width <= width);
        RADLAB_CHECK(view.y + view.height <= height);
        const ViewRaster<Sink> raster(state, view, style, width, sink);
        for (int i = 0; i < count; ++i) raster.draw(style.reverse ? count - 1 - i : i);
    }
}

std::size_t pixelCount(int width, int height) {
    RADLAB_CHECK(width >= 0);
    RADLAB_CHECK(height >= 0);
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
}

// Lists of what may be seen in each pixel, kept short: what a certain fragment hides is dropped at once.
class Contest {
public:
    Contest(std::size_t pixels, bool withDepth)
        : depthTest(withDepth), pixelHeads(pixels, none), nearest(pixels, INFINITY), filled(pixels, 0) {
        entries.reserve(2 * pixels);
    }

    void operator()(const Fragment& fragment) {
        const Coverage& coverage = fragment.coverage;
        double& limit = nearest[fragment.pixel];
        if (depthTest && coverage.low > limit) return;
        if (coverage.certain) {
            filled[fragment.pixel] = 1;
            const bool nearer = coverage.high < limit;
            limit = std::min(limit, coverage.high);
            if (nearer || !depthTest) dropHidden(fragment.pixel);  // else it hides nothing that was not hidden
        }
        int& head = pixelHeads[fragment.pixel];
        head = keep({fragment.patch, head, coverage.inside, coverage.depth, coverage.low});
    }

    IdImage result(int width, int height) const {
        IdImage image{
            width, height, std::vector<int>(pixelHeads.size(), -1), std::vector<std::uint8_t>(pixelHeads.size()),
            {},    {}};
        image.start.reserve(pixelHeads.size() + 1);
        for (std::size_t pixel = 0; pixel < pixelHeads.size(); ++pixel) {
            image.start.push_back(image.candidates.size());
            image.patch[pixel] = winner(pixelHeads[pixel]);
            const int head = pixelHeads[pixel];
            const int possible = (filled[pixel] ? 0 : 1) + (head == none ? 0 : entry(head).next == none ? 1 : 2);
            image.sure[pixel] = possible == 1;
            if (image.sure[pixel]) continue;
            for (int i = head; i != none; i = entry(i).next) image.candidates.push_back(entry(i).patch);
            if (!filled[pixel]) image.candidates.push_back(-1);
        }
        image.start.push_back(image.candidates.size());
        return image;
    }

private:
    struct Entry {
        int patch;
        int next;  // what was drawn before it, or none
        bool inside;
        double depth, low;
    };
    static constexpr int none = -1;

    const Entry& entry(int i) const { return entries[static_cast<std::size_t>(i)]; }

    int keep(const Entry& made) {
        if (unused == none) {
            entries.push_back(made);
            return static_cast<int>(entries.size()) - 1;
        }
        const int place = unused;
        unused = entry(place).next;
        entries[static_cast<std::size_t>(place)] = made;
        return place;
    }

    void dropHidden(std::size_t pixel) {
        int* link = &pixelHeads[pixel];
        while (*link != none) {
            Entry& here = entries[static_cast<std::size_t>(*link)];
            if (depthTest && here.low <= nearest[pixel]) {
                link = &here.next;
                continue;
            }
            const int dropped = *link;
            *link = here.next;
            here.next = unused;
            unused = dropped;
        }
    }

    // The patch at the pixel's centre; of two in one depth the one that was drawn first, as GL_LESS has it.
    int winner(int head) const {
        int best = none;
        for (int i = head; i != none; i = entry(i).next) {
            if (!entry(i).inside) continue;
            if (best == none || (depthTest && entry(i).depth <= entry(best).depth)) best = i;
        }
        return best == none ? -1 : entry(best).patch;
    }

    const bool depthTest;
    std::vector<int> pixelHeads;       // the entry drawn last, or none
    std::vector<double> nearest;       // at this depth at the latest something is seen
    std::vector<std::uint8_t> filled;  // whether the background is surely covered
    std::vector<Entry> entries;
    int unused = none;
};

// The depth buffer and the fragments that passed it.
class Layers {
public:
    Layers(std::size_t pixels, bool withDepth) : depthTest(withDepth), buffer(pixels), sure(pixels, 1) {}

    void operator()(const Fragment& fragment) {
        const Coverage& coverage = fragment.coverage;
        Depth& depth = buffer[fragment.pixel];
        if (depthTest && coverage.low > depth.high) return;
        const bool nearer = !depthTest || coverage.high < depth.low;
        if (!coverage.certain || !nearer) sure[fragment.pixel] = 0;
        if (!coverage.inside || (depthTest && coverage.depth >= depth.exact)) return;
        depth = {coverage.depth, coverage.low, coverage.high};
        passed.push_back({fragment.pixel, fragment.patch});
    }

    LayerImage result(int width, int height) {
        LayerImage image{width, height, std::move(sure), std::vector<std::size_t>(buffer.size() + 1),
                         std::vector<int>(passed.size())};
        for (const Passed& one : passed) ++image.start[one.pixel + 1];
        for (std::size_t pixel = 0; pixel < buffer.size(); ++pixel) image.start[pixel + 1] += image.start[pixel];
        std::vector<std::size_t> next(image.start.begin(), image.start.end() - 1);
        for (const Passed& one : passed) image.patches[next[one.pixel]++] = one.patch;
        return image;
    }

private:
    struct Depth {
        double exact = 1.0, low = 1.0, high = 1.0;
    };
    struct Passed {
        std::size_t pixel;
        int patch;
    };

    const bool depthTest;
    std::vector<Depth> buffer;
    std::vector<std::uint8_t> sure;
    std::vector<Passed> passed;
};

}  // namespace

IdImage rasterIds(const State& state, std::span<const IdView> views, int width, int height, const RasterStyle& style) {
    Contest contest(pixelCount(width, height), style.depthTest);
    rasterInto(contest, state, views, width, height, style);
    return contest.result(width, height);
}

LayerImage rasterLayers(const State& state, std::span<const IdView> views, int width, int height,
                        const RasterStyle& style) {
    Layers layers(pixelCount(width, height), style.depthTest);
    rasterInto(layers, state, views, width, height, style);
    return layers.result(width, height);
}

}  // namespace radlab::grader

#include "engine/PatchTree.h"

#include <algorithm>

#include <tbb/parallel_for.h>

#include "base/Interrupts.h"
#include "course/FacePolygon.h"

namespace radlab::engine {

namespace {

constexpr double sameLine =
    1e-5;  // of a cluster's extent: coordinates of floats that are nearer lie on one line of the mesh

using Index = std::uint32_t;

double turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// One side of the convex hull of points in order; points nearly on its edges are left out.
void addChain(Polygon2& hull, const Polygon2& points, double flat) {
    const std::size_t start = hull.size();
    for (const glm::dvec2& point : points) {
        while (hull.size() >= start + 2 && turn(hull[hull.size() - 2], hull.back(), point) <= flat) hull.pop_back();
        hull.push_back(point);
    }
    hull.pop_back();
}

// The convex hull, counter-clockwise.
// @source Andrew's monotone chain
Polygon2 hullOf(Polygon2 points, double flat) {
    const auto before = [](const glm::dvec2& a, const glm::dvec2& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; };
    std::sort(points.begin(), points.end(), before);
    Polygon2 hull;
    addChain(hull, points, flat);
    std::reverse(points.begin(), points.end());
    addChain(hull, points, flat);
    return hull;
}

// The tree of one face; clusters are numbered from 0 here.
struct FaceTree {
    struct Cluster {
        Index first, second;  // patches, or clusters where marked
        bool firstIsCluster, secondIsCluster;
        Polygon outline;
        double area;
    };
    std::vector<Cluster> clusters;
    std::vector<Index> patches;
};

class FaceTreeBuilder {
public:
    FaceTreeBuilder(const Geometry& shapes, FaceTree& made) : geometry(shapes), tree(made) {
        const Polygon& some = geometry.patches[tree.patches[0]];
        origin = some.center;
        x = glm::normalize(some.corners[1] - some.corners[0]);
        y = glm::cross(some.normal, x);
    }

    void build() {
        if (tree.patches.size() > 1) build(0, tree.patches.size());
    }

private:
    struct Built {
        Polygon2 outline;
        double area;
        Index index;
        bool isCluster;
    };

    glm::dvec2 flat(const Point& point) const { return {glm::dot(point - origin, x), glm::dot(point - origin, y)}; }

    Built build(std::size_t begin, std::size_t end) {
        if (end - begin == 1) return leaf(tree.patches[begin]);
        const std::size_t middle = split(begin, end);
        const Built first = build(begin, middle), second = build(middle, end);
        Built both{first.outline, first.area + second.area, static_cast<Index>(tree.clusters.size()), true};
        both.outline.insert(both.outline.end(), second.outline.begin(), second.outline.end());
        both.outline = hullOf(std::move(both.outline), sameLine * both.area);
        tree.clusters.push_back(
            {first.index, second.index, first.isCluster, second.isCluster, raised(both.outline), both.area});
        return both;
    }

    Built leaf(Index patch) const {
        Built built{{}, geometry.patches[patch].area, patch, false};
        Interrupts::check();
        for (const Point& corner : geometry.patches[patch].corners) built.outline.push_back(flat(corner));
        return built;
    }

    Polygon raised(const Polygon2& outline) const {
        std::vector<Point> corners;
        for (const glm::dvec2& corner : outline) corners.push_back(origin + corner.x * x + corner.y * y);
        return Polygon(std::move(corners));
    }

    // Orders the patches so that those on one side of a line of the mesh come first; returns where the others begin.
    std::size_t split(std::size_t begin, std::size_t end) {
        Interrupts::check();
        glm::dvec2 low(INFINITY), high(-INFINITY);
        for (std::size_t i = begin; i < end; ++i) {
            const glm::dvec2 at = flat(geometry.patches[tree.patches[i]].center);
            low = glm::min(low, at);
            high = glm::max(high, at);
        }
        const int axis = high.x - low.x >= high.y - low.y ? 0 : 1;
        const double tolerance = sameLine * (high[axis] - low[axis]);
        const auto at = tree.patches.begin();
        const auto place = [&](Index patch) { return flat(geometry.patches[patch].center)[axis]; };
        const auto from = at + static_cast<std::ptrdiff_t>(begin), to = at + static_cast<std::ptrdiff_t>(end),
                   middle = from + (to - from) / 2;
        std::nth_element(from, middle, to, [&](Index a, Index b) {
            const double placeA = place(a), placeB = place(b);
            return placeA != placeB ? placeA < placeB : a < b;
        });
        const double line = place(*middle);
        const auto below = std::partition(from, to, [&](Index p) { return place(p) < line - tolerance; });
        const auto upTo = std::partition(below, to, [&](Index p) { return place(p) <= line + tolerance; });
        auto chosen = middle - below <= upTo - middle ? below : upTo;
        if (chosen == from || chosen == to) chosen = chosen == from ? upTo : below;
        if (chosen == from || chosen == to) chosen = middle;
        return static_cast<std::size_t>(chosen - at);
    }

    const Geometry& geometry;
    FaceTree& tree;
    Point origin, x, y;
};

std::vector<FaceTree> treesOf(const Geometry& geometry) {
    std::vector<FaceTree> trees(geometry.faces.size());
    for (std::size_t i = 0; i < geometry.patches.size(); ++i)
        if (geometry.patches[i].area > 0.0) trees[geometry.faceOf[i]].patches.push_back(static_cast<Index>(i));
    tbb::parallel_for(std::size_t{0}, trees.size(), [&](std::size_t face) {
        if (!trees[face].patches.empty()) FaceTreeBuilder(geometry, trees[face]).build();
    });
    return trees;
}

}  // namespace

PatchTree::PatchTree(const Geometry& geometry) : leafCount(geometry.patches.size()), outlines(geometry) {
    nodes.resize(leafCount);
    for (const Polygon& patch : geometry.patches) areas.push_back(patch.area);
    std::vector<FaceTree> trees = treesOf(geometry);
    for (std::size_t face = 0; face < trees.size(); ++face) {
        if (trees[face].patches.empty()) continue;
        const auto base = static_cast<Index>(nodes.size());
        for (FaceTree::Cluster& cluster : trees[face].clusters) {
            const auto self = static_cast<Index>(nodes.size());
            const Index first = cluster.first + (cluster.firstIsCluster ? base : 0),
                        second = cluster.second + (cluster.secondIsCluster ? base : 0);
            nodes[first].parent = nodes[second].parent = self;
            nodes.push_back({none, first, second});
            areas.push_back(cluster.area);
            outlines.patches.push_back(std::move(cluster.outline));
            outlines.faceOf.push_back(face);
        }
        faceRoots.push_back(trees[face].clusters.empty() ? trees[face].patches[0]
                                                         : static_cast<Index>(nodes.size() - 1));
    }
}

void PatchTree::push(std::vector<double>& values) const {
    for (std::size_t i = nodes.size(); i-- > leafCount;)
        for (const Index child : {nodes[i].first, nodes[i].second}) values[child] += values[i];
}

}  // namespace radlab::engine

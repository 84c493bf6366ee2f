#include "engine/Shafts.h"

#include <algorithm>

#include <tbb/parallel_for.h>

#include "base/Interrupts.h"
#include "engine/Triangles.h"

namespace radlab::engine {

namespace {

constexpr double relativeTolerance = 1e-6;

// A face in convex pieces: itself where it is convex.
std::vector<Blocker> blockersOf(const Polygon& face, double tolerance, double through) {
    std::vector<Blocker> pieces;
    for (const Polygon& piece : convexPiecesOf(face)) pieces.emplace_back(piece, tolerance, through);
    return pieces;
}

// A point in the hull of a polygon's corners that lies on no line of symmetry.
Point somePoint(const Polygon& polygon) {
    Point sum(0.0);
    double weight = 1.0, weights = 0.0;
    for (const Point& corner : polygon.corners) {
        sum += weight * corner;
        weights += weight;
        weight *= 1.7548776662466927;
    }
    return sum / weights;
}

}  // namespace

Shafts::Shafts(const Geometry& shapes) : geometry(shapes) {
    for (const Polygon& patch : geometry.patches) patchBoxes.push_back(boxOf(patch));
    Box whole;
    for (const Polygon& face : geometry.faces) {
        faceBoxes.push_back(boxOf(face));
        whole.add(faceBoxes.back());
    }
    const std::size_t count = geometry.faces.size();
    if (count == 0) return;
    tolerance = relativeTolerance * glm::length(whole.high - whole.low);
    std::vector<bool> opaque;
    for (std::size_t i = 0; i < count; ++i) {
        Interrupts::check();
        blockers.push_back(
            blockersOf(geometry.faces[i], tolerance, geometry.through.empty() ? 0.0 : geometry.through[i]));
        opaque.push_back(!blockers[i].empty() && isOpaque(i));
    }
    tree = BoxTree(faceBoxes);
    edges = FaceEdges(geometry.faces, opaque);
    cut.resize(geometry.patches.size());
    tbb::parallel_for(std::size_t{0}, cut.size(), [&](std::size_t patch) {
        Interrupts::check();
        cut[patch] = isCut(patch);
    });
}

bool Shafts::isCut(std::size_t patch) const {
    bool found = false;
    tree.visit([&](const Box& box) { return box.meets(patchBoxes[patch], tolerance); },
               [&](std::size_t face) {
                   found = face != geometry.faceOf[patch] && isOpaque(face) &&
                           faceBoxes[face].meets(patchBoxes[patch], tolerance) &&
                           goesThrough(face, geometry.patches[patch]);
                   return !found;
               });
    return found;
}

// A face goes through a patch, or stands on it, where both reach to both sides of the other's plane, or to one and
// into it, and where the face meets the patch's plane not all beyond one of the patch's edges.
bool Shafts::goesThrough(std::size_t face, const Polygon& patch) const {
    const Polygon& other = geometry.faces[face];
    const Range ofPatch = heightsOver(patch, other.center, other.normal);
    if (ofPatch.low >= -tolerance || ofPatch.high <= tolerance) return false;
    const Range ofFace = heightsOver(other, patch.center, patch.normal);
    if (ofFace.low > tolerance || ofFace.high <= tolerance) return false;
    const std::vector<Point> met = metByEdges(face, patch);
    for (std::size_t i = 0; i < patch.corners.size(); ++i) {
        const Point &corner = patch.corners[i], &next = patch.corners[(i + 1) % patch.corners.size()];
        const Point inwards = glm::cross(patch.normal, next - corner);
        const double slack = tolerance * glm::length(inwards);
        const auto depth = [&](const Point& point) { return glm::dot(point - corner, inwards); };
        const auto isInside = [&](const Point& point) { return depth(point) >= -slack; };
        const auto isBeyond = [&](const Point& point) { return depth(point) <= slack; };
        if (std::all_of(patch.corners.begin(), patch.corners.end(), isInside) &&
            std::all_of(met.begin(), met.end(), isBeyond))
            return false;
    }
    return true;
}

// Where a face's outline meets a patch's plane.
std::vector<Point> Shafts::metByEdges(std::size_t face, const Polygon& patch) const {
    std::vector<Point> met;
    for (const FaceEdges::Edge& edge : edges.of(face)) {
        const double from = glm::dot(edge.from - patch.center, patch.normal),
                     to = glm::dot(edge.to - patch.center, patch.normal);
        if (std::abs(from) <= tolerance) met.push_back(edge.from);
        if (std::min(from, to) < -tolerance && std::max(from, to) > tolerance)
            met.push_back(edge.from + from / (from - to) * (edge.to - edge.from));
    }
    return met;
}

// Whether a line in a shaft may pass an edge of a face and cross the surface on one side of the edge alone.
bool Shafts::endsIn(Shaft& shaft, std::size_t face) const {
    const int here = shaft.direction(geometry.faces[face].normal);
    for (const FaceEdges::Edge& edge : edges.of(face)) {
        if (here != 0 && edge.beyond != FaceEdges::none) {
            const int there = shaft.direction(geometry.faces[edge.beyond].normal);
            if (there == (edge.turned ? -here : here)) continue;
        }
        if (!shaft.misses(edge.from, edge.to)) return true;
    }
    return false;
}

// Several opaque faces may decide together, where the ends of lines pass through none, and some line runs in front of
// both.
bool Shafts::mayDecide(std::size_t first, std::size_t second) const {
    const Polygon &a = geometry.patches[first], &b = geometry.patches[second];
    if (cut[first] || cut[second]) return false;
    return glm::dot(somePoint(b) - a.center, a.normal) > tolerance &&
           glm::dot(somePoint(a) - b.center, b.normal) > tolerance;
}

Sight Shafts::sight(std::size_t first, std::size_t second, Blockers& between, std::size_t enough) const {
    between.clear();
    const Polygon &a = geometry.patches[first], &b = geometry.patches[second];
    thread_local std::vector<std::size_t> opaque;
    opaque.clear();
    std::size_t looked = 0;
    bool hidden = false, partly = !mayDecide(first, second);
    Shaft shaft(a, patchBoxes[first], b, patchBoxes[second], tolerance);
    const auto lookForEnds = [&] {
        for (; looked < opaque.size() && !partly; ++looked) partly = endsIn(shaft, opaque[looked]);
        return partly;
    };
    const auto take = [&](std::size_t face) {
        if (face == geometry.faceOf[first] || face == geometry.faceOf[second]) return true;
        if (shaft.misses(geometry.faces[face], faceBoxes[face])) return true;
        hidden = addPieces(face, a, b, between, opaque);
        return !hidden && (between.size() <= enough || !lookForEnds());
    };
    tree.visit([&](const Box& box) { return !shaft.misses(box); }, take);
    if (hidden) return Sight::hidden;
    if (between.empty()) return Sight::clear;
    return opaque.size() < 2 || lookForEnds() ? Sight::partly : onOneLine(somePoint(a), somePoint(b), between);
}

// Adds what of a face stands between two patches; returns whether it hides all.
bool Shafts::addPieces(std::size_t face, const Polygon& a, const Polygon& b, Blockers& between,
                       std::vector<std::size_t>& opaque) const {
    const std::size_t before = between.size();
    for (const Blocker& blocker : blockers[face]) {
        const Sight sight = blocker.between(a, b);
        if (sight == Sight::hidden && blocker.through() == 0.0) return true;
        if (sight != Sight::clear) between.push_back(&blocker);
    }
    if (between.size() > before && isOpaque(face)) opaque.push_back(face);
    return false;
}

// Where one line stands for all, as far as opaque faces go: leaves only panes.
Sight Shafts::onOneLine(const Point& from, const Point& to, Blockers& between) const {
    const auto isPane = [](const Blocker* blocker) { return blocker->through() > 0.0; };
    const auto panesEnd = std::partition(between.begin(), between.end(), isPane);
    if (std::any_of(panesEnd, between.end(), [&](const Blocker* blocker) { return blocker->meets(from, to); }))
        return Sight::hidden;
    between.erase(panesEnd, between.end());
    return between.empty() ? Sight::clear : Sight::partly;
}

}  // namespace radlab::engine

#include "course/Mesher.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <cstdint>
#include <string>
#include <unordered_map>

#include "base/Warning.h"
#include "course/CreaseAngle.h"
#include "course/FacePolygon.h"

using namespace radlab;

namespace {

using Corners = std::vector<glm::dvec3>;

constexpr double planarTolerance = 1e-3;
constexpr double mostPatches = 16777214.0;  // 24-bit patch IDs, less background and one

void checkSize(float size, const std::string& name) {
    if (!std::isfinite(size) || size <= 0.0f)
        throw Error(name + ": found " + std::to_string(size) + ", expected a length above 0");
}

double cellsAlong(double length, double size) { return std::max(1.0, std::round(length / size)); }

double diameter(const Corners& corners) {
    double largest = 0.0;
    for (const glm::dvec3& a : corners)
        for (const glm::dvec3& b : corners) largest = std::max(largest, glm::distance(a, b));
    return largest;
}

Corners differentCorners(const std::vector<Vec3f>& positions, const Face& face) {
    Corners corners;
    for (const int index : face.corners) {
        RADLAB_CHECK(index >= 0);
        RADLAB_CHECK(static_cast<std::size_t>(index) < positions.size());
        const glm::dvec3 position(positions[static_cast<std::size_t>(index)]);
        if (corners.empty() || position != corners.back()) corners.push_back(position);
    }
    while (corners.size() > 1 && corners.back() == corners.front()) corners.pop_back();
    if (corners.size() < 3)
        throw Error(face.where, "degenerate face: found " + std::to_string(corners.size()) +
                                    " different corners, expected at least 3");
    return corners;
}

// Whether the face is thinner than what float coordinates of its size and place can tell apart.
bool hasNoArea(const Corners& corners, double area) {
    double farthest = 0.0;
    for (const glm::dvec3& corner : corners)
        for (int axis = 0; axis < 3; ++axis) farthest = std::max(farthest, std::abs(corner[axis]));
    return area <= 2.0 * FLT_EPSILON * farthest * diameter(corners);
}

void checkPlanar(const Corners& corners, const glm::dvec3& normal, const Location& where) {
    const glm::dvec3 centre = areaCentroid(corners, normal);
    double deviation = 0.0;
    for (const glm::dvec3& corner : corners)
        deviation = std::max(deviation, std::abs(glm::dot(corner - centre, normal)));
    const double allowed = planarTolerance * diameter(corners);
    if (deviation > allowed)
        throw Error(where, "face is not planar: found a corner " + std::to_string(deviation) +
                               " off its plane, expected at most " + std::to_string(allowed) +
                               "; split it into triangles");
}

// Gives points of a plane the same number where they are the same up to rounding.
class PointWelder {
public:
    explicit PointWelder(double tolerance) : cell(tolerance) {}

    int indexOf(const glm::dvec2& point) {
        const std::int64_t x = std::llround(point.x / cell), y = std::llround(point.y / cell);
        for (std::int64_t i = x - 1; i <= x + 1; ++i)
            for (std::int64_t j = y - 1; j <= y + 1; ++j)
                if (const auto found = indices.find(key(i, j)); found != indices.end()) return found->second;
        indices.emplace(key(x, y), static_cast<int>(points.size()));
        points.push_back(point);
        return static_cast<int>(points.size()) - 1;
    }

    // The polygon with every corner replaced by the first point that was the same, and without repeated corners.
    Polygon2 welded(const Polygon2& polygon) {
        Polygon2 result;
        for (const glm::dvec2& corner : polygon) {
            const glm::dvec2& point = points[static_cast<std::size_t>(indexOf(corner))];
            if (std::find(result.begin(), result.end(), point) == result.end()) result.push_back(point);
        }
        return result;
    }

    std::vector<int> indicesOf(const Polygon2& polygon) {
        std::vector<int> numbers;
        for (const glm::dvec2& corner : polygon) numbers.push_back(indexOf(corner));
        return numbers;
    }

    std::vector<glm::dvec2> points;

private:
    static std::uint64_t key(std::int64_t x, std::int64_t y) {
        return (static_cast<std::uint64_t>(x) << 32) ^ (static_cast<std::uint64_t>(y) & 0xffffffffu);
    }

    double cell;
    std::unordered_map<std::uint64_t, int> indices;
};

// Cuts one face; its patches and vertices are added to the output.
class FaceCutter {
public:
    FaceCutter(const Face& f, double s, std::vector<MyVertex>& v, std::vector<MyPolygon>& p)
        : face(f), size(s), outVertices(v), outPolygons(p) {}

    void cut(const Corners& corners, const glm::dvec3& normal) {
        if (corners.size() == 3)
            cutTriangle(corners);
        else if (corners.size() == 4 && isConvex(inPlane(corners, normal)))
            cutQuadrilateral(corners);
        else
            cutPolygon(corners, normal);
    }

private:
    void cutTriangle(const Corners& c) {
        const double longest =
            std::max({glm::distance(c[0], c[1]), glm::distance(c[1], c[2]), glm::distance(c[2], c[0])});
        const double wanted = cellsAlong(longest, size);
        reserve(wanted * wanted);
        const int n = static_cast<int>(wanted);
        std::vector<std::vector<int>> rows;  // row i has n - i + 1 vertices, from side 2-0 to side 1-2
        for (int i = 0; i <= n; ++i) {
            rows.emplace_back();
            for (int j = 0; j <= n - i; ++j)
                rows[i].push_back(
                    addVertex((c[0] * double(n - i - j) + c[1] * double(j) + c[2] * double(i)) / double(n)));
        }
        for (int i = 0; i < n; ++i) {
            for (int j = 0; j < n - i; ++j) {
                addPatch({rows[i][j], rows[i][j + 1], rows[i + 1][j]});
                if (j + 1 < n - i) addPatch({rows[i][j + 1], rows[i + 1][j + 1], rows[i + 1][j]});
            }
        }
    }

    void cutQuadrilateral(const Corners& c) {
        const double across = cellsAlong(std::max(glm::distance(c[0], c[1]), glm::distance(c[3], c[2])), size);
        const double along = cellsAlong(std::max(glm::distance(c[1], c[2]), glm::distance(c[0], c[3])), size);
        reserve(across * along);
        const int nu = static_cast<int>(across), nv = static_cast<int>(along);
        std::vector<int> grid;
        for (int j = 0; j <= nv; ++j)
            for (int i = 0; i <= nu; ++i) {
                const double u = double(i) / nu, v = double(j) / nv;
                grid.push_back(addVertex(glm::mix(glm::mix(c[0], c[1], u), glm::mix(c[3], c[2], u), v)));
            }
        const auto at = [&](int i, int j) { return grid[static_cast<std::size_t>(j) * (nu + 1) + i]; };
        for (int j = 0; j < nv; ++j)
            for (int i = 0; i < nu; ++i) addPatch({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
    }

    // Axes in the face's plane, the first along its longest edge.
    static std::pair<glm::dvec3, glm::dvec3> planeAxes(const Corners& corners, const glm::dvec3& normal) {
        glm::dvec3 longest(0.0);
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const glm::dvec3 edge = corners[(i + 1) % corners.size()] - corners[i];
            if (glm::dot(edge, edge) > glm::dot(longest, longest)) longest = edge;
        }
        const glm::dvec3 x = glm::normalize(longest - glm::dot(longest, normal) * normal);
        return {x, glm::cross(normal, x)};
    }

    static Polygon2 inPlane(const Corners& corners, const glm::dvec3& normal) {
        const auto [x, y] = planeAxes(corners, normal);
        Polygon2 flat;
        for (const glm::dvec3& corner : corners)
            flat.emplace_back(glm::dot(corner - corners[0], x), glm::dot(corner - corners[0], y));
        return flat;
    }

    void cutPolygon(const Corners& corners, const glm::dvec3& normal) {
        const Polygon2 flat = inPlane(corners, normal);
        const std::vector<Polygon2> pieces = convexPieces(flat);
        checkNotCrossing(flat, pieces);
        glm::dvec2 low = flat[0], high = flat[0];
        for (const glm::dvec2& p : flat) low = glm::min(low, p), high = glm::max(high, p);
        const glm::dvec2 extent = high - low;
        const double columns = cellsAlong(extent.x, size), rows = cellsAlong(extent.y, size);
        reserve(columns * rows);
        PointWelder welder(1e-7 * std::max(extent.x, extent.y));
        std::vector<std::vector<int>> cells;
        for (int i = 0; i < static_cast<int>(columns); ++i) {
            std::vector<Polygon2> strips;
            for (const Polygon2& piece : pieces) strips.push_back(between(piece, 0, low.x, extent.x / columns, i));
            for (int j = 0; j < static_cast<int>(rows); ++j) {
                std::vector<Polygon2> parts;
                for (const Polygon2& strip : strips)
                    if (Polygon2 part = welder.welded(between(strip, 1, low.y, extent.y / rows, j)); part.size() > 2)
                        parts.push_back(std::move(part));
                for (const Polygon2& cell : mergedWhereConvex(parts)) cells.push_back(welder.indicesOf(cell));
            }
        }
        addCells(cells, welder.points, corners, normal);
    }

    void checkNotCrossing(const Polygon2& whole, const std::vector<Polygon2>& pieces) const {
        double sum = 0.0;
        for (const Polygon2& piece : pieces) sum += std::abs(signedArea(piece));
        if (std::abs(sum - signedArea(whole)) > 1e-6 * sum)
            throw Error(face.where, "face crosses itself: expected corners in order around a simple polygon");
    }

    static Polygon2 between(const Polygon2& piece, int axis, double low, double width, int index) {
        return clipAtLine(clipAtLine(piece, axis, low + width * index, false), axis, low + width * (index + 1), true);
    }

    void addCells(const std::vector<std::vector<int>>& cells, const std::vector<glm::dvec2>& points,
                  const Corners& corners, const glm::dvec3& normal) {
        const auto [x, y] = planeAxes(corners, normal);
        const int first = static_cast<int>(outVertices.size());
        for (const glm::dvec2& point : points) addVertex(corners[0] + point.x * x + point.y * y);
        for (const std::vector<int>& cell : cells)
            for (std::size_t i = 1; i + 1 < cell.size(); i += 2) {
                std::vector<int> corner = {first + cell[0], first + cell[i], first + cell[i + 1]};
                if (i + 2 < cell.size()) corner.push_back(first + cell[i + 2]);
                addPatch(corner);
            }
    }

    void reserve(double patches) const {
        if (static_cast<double>(outPolygons.size()) + patches > mostPatches)
            throw Error(face.where, "too many patches: this face alone needs " + std::to_string(patches) + " at size " +
                                        std::to_string(size) +
                                        ", expected at most 16777214 in all; take a larger size");
    }

    int addVertex(const glm::dvec3& position) {
        exact.push_back(position);
        outVertices.emplace_back();
        outVertices.back().position = Vec3f(position);
        return static_cast<int>(outVertices.size()) - 1;
    }

    void addPatch(const std::vector<int>& corner) {
        const std::size_t before = outVertices.size() - exact.size();
        Corners positions;
        for (const int index : corner) positions.push_back(exact[static_cast<std::size_t>(index) - before]);
        const glm::dvec3 area = areaVector(positions);
        if (glm::length(area) <= 1e-12 * size * size && hasNoArea(positions, glm::length(area))) return;
        MyPolygon patch;
        patch.vertices = static_cast<int>(corner.size());
        std::copy(corner.begin(), corner.end(), patch.vertex);
        patch.area = static_cast<float>(glm::length(area));
        patch.normal = Vec3f(glm::normalize(area));
        patch.center = Vec3f(areaCentroid(positions, glm::normalize(area)));
        patch.diffuse = patch.color = face.material->diffuse;
        patch.emissive = patch.rad = patch.unshot_rad = face.material->emissive;
        outPolygons.push_back(patch);
    }

    const Face& face;
    double size;
    Corners exact;  // this face's vertices before they are rounded to float
    std::vector<MyVertex>& outVertices;
    std::vector<MyPolygon>& outPolygons;
};

void warnOfSlivers(int count, const Location& first) {
    if (count == 0) return;
    warn(first.file + (first.line > 0 ? ":" + std::to_string(first.line) : "") + ": passed over " +
         std::to_string(count) + (count == 1 ? " face" : " faces, this the first,") + " without area");
}

}  // namespace

std::vector<int> Mesher::mesh(const std::vector<Vec3f>& inVertices, const std::vector<Face>& inPolygons,
                              std::vector<MyVertex>& outVertices, std::vector<MyPolygon>& outPolygons, float patchSize,
                              float lightSize) {
    checkSize(patchSize, "patch size");
    checkSize(lightSize, "light patch size");
    outVertices.clear();
    outPolygons.clear();
    std::vector<int> faceOf;
    int slivers = 0;
    Location firstSliver;
    for (std::size_t i = 0; i < inPolygons.size(); ++i) {
        const Face& face = inPolygons[i];
        RADLAB_CHECK(face.material != nullptr);
        const Corners corners = differentCorners(inVertices, face);
        const glm::dvec3 area = areaVector(corners);
        if (hasNoArea(corners, glm::length(area))) {
            if (slivers++ == 0) firstSliver = face.where;
            continue;
        }
        checkPlanar(corners, glm::normalize(area), face.where);
        FaceCutter(face, face.material->emits() ? lightSize : patchSize, outVertices, outPolygons)
            .cut(corners, glm::normalize(area));
        faceOf.resize(outPolygons.size(), static_cast<int>(i));
    }
    warnOfSlivers(slivers, firstSliver);
    shareWithinCreaseAngle(inPolygons, faceOf, outVertices, outPolygons);
    return faceOf;
}

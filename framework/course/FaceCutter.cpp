#include "course/FaceCutter.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/Interrupts.h"
#include "course/PatchMesh.h"
#include "course/PointWelder.h"

namespace radlab {

namespace {

double cellsAlong(double length, double size) { return std::max(1.0, std::round(length / size)); }

// Axes in the face's plane, the first along its longest edge.
std::pair<glm::dvec3, glm::dvec3> planeAxes(const Corners& corners, const glm::dvec3& normal) {
    glm::dvec3 longest(0.0);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const glm::dvec3 edge = corners[(i + 1) % corners.size()] - corners[i];
        if (glm::dot(edge, edge) > glm::dot(longest, longest)) longest = edge;
    }
    const glm::dvec3 x = glm::normalize(longest - glm::dot(longest, normal) * normal);
    return {x, glm::cross(normal, x)};
}

Polygon2 inPlane(const Corners& corners, const glm::dvec3& normal) {
    const auto [x, y] = planeAxes(corners, normal);
    Polygon2 flat;
    for (const glm::dvec3& corner : corners)
        flat.emplace_back(glm::dot(corner - corners[0], x), glm::dot(corner - corners[0], y));
    return flat;
}

Polygon2 between(const Polygon2& piece, int axis, double low, double width, int index) {
    return clipAtLine(clipAtLine(piece, axis, low + width * index, false), axis, low + width * (index + 1), true);
}

}  // namespace

FaceCutter::FaceCutter(const Face& f, double s, std::vector<MyVertex>& v, std::vector<MyPolygon>& p)
    : face(f), size(s), outVertices(v), outPolygons(p) {}

void FaceCutter::cut(const Corners& corners, const glm::dvec3& normal) {
    if (corners.size() == 3)
        cutTriangle(corners);
    else if (corners.size() == 4 && isConvex(inPlane(corners, normal)))
        cutQuadrilateral(corners);
    else
        cutPolygon(corners, normal);
}

void FaceCutter::cutTriangle(const Corners& c) {
    const double longest = std::max({glm::distance(c[0], c[1]), glm::distance(c[1], c[2]), glm::distance(c[2], c[0])});
    const double wanted = cellsAlong(longest, size);
    checkRoom(wanted * wanted);
    const int n = static_cast<int>(wanted);
    std::vector<std::vector<int>> rows;  // row i has n - i + 1 vertices, from side 2-0 to side 1-2
    for (int i = 0; i <= n; ++i) {
        rows.emplace_back();
        for (int j = 0; j <= n - i; ++j)
            rows[i].push_back(addVertex((c[0] * double(n - i - j) + c[1] * double(j) + c[2] * double(i)) / double(n)));
    }
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n - i; ++j) {
            addPatch({rows[i][j], rows[i][j + 1], rows[i + 1][j]});
            if (j + 1 < n - i) addPatch({rows[i][j + 1], rows[i + 1][j + 1], rows[i + 1][j]});
        }
    }
}

void FaceCutter::cutQuadrilateral(const Corners& c) {
    const double across = cellsAlong(std::max(glm::distance(c[0], c[1]), glm::distance(c[3], c[2])), size);
    const double along = cellsAlong(std::max(glm::distance(c[1], c[2]), glm::distance(c[0], c[3])), size);
    checkRoom(across * along);
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

void FaceCutter::cutPolygon(const Corners& corners, const glm::dvec3& normal) {
    const Polygon2 flat = inPlane(corners, normal);
    const std::vector<Polygon2> pieces = convexPieces(flat);
    checkNotCrossing(flat, pieces);
    glm::dvec2 low = flat[0], high = flat[0];
    for (const glm::dvec2& p : flat) low = glm::min(low, p), high = glm::max(high, p);
    const glm::dvec2 extent = high - low;
    const double columns = cellsAlong(extent.x, size), rows = cellsAlong(extent.y, size);
    checkRoom(columns * rows);
    PointWelder welder(1e-7 * std::max(extent.x, extent.y));
    std::vector<std::vector<int>> cells;
    for (int i = 0; i < static_cast<int>(columns); ++i) {
        std::vector<Polygon2> strips;
        for (const Polygon2& piece : pieces) strips.push_back(between(piece, 0, low.x, extent.x / columns, i));
        for (int j = 0; j < static_cast<int>(rows); ++j) {
            Interrupts::check();
            std::vector<Polygon2> parts;
            for (const Polygon2& strip : strips)
                if (Polygon2 part = welder.welded(between(strip, 1, low.y, extent.y / rows, j)); part.size() > 2)
                    parts.push_back(std::move(part));
            for (const Polygon2& cell : mergedWhereConvex(parts)) cells.push_back(welder.indicesOf(cell));
        }
    }
    addCells(cells, welder.points, corners, normal);
}

void FaceCutter::checkNotCrossing(const Polygon2& whole, const std::vector<Polygon2>& pieces) const {
    double sum = 0.0;
    for (const Polygon2& piece : pieces) sum += std::abs(signedArea(piece));
    if (std::abs(sum - signedArea(whole)) > 1e-6 * sum)
        throw Error(face.where, "face crosses itself: expected corners in order around a simple polygon");
}

void FaceCutter::addCells(const std::vector<std::vector<int>>& cells, const std::vector<glm::dvec2>& points,
                          const Corners& corners, const glm::dvec3& normal) {
    const auto [x, y] = planeAxes(corners, normal);
    std::vector<int> numbers(points.size(), -1);  // only points that a cell uses become vertices
    const auto vertexOf = [&, x = x, y = y](int index) {
        const glm::dvec2& point = points[static_cast<std::size_t>(index)];
        int& number = numbers[static_cast<std::size_t>(index)];
        if (number < 0) number = addVertex(corners[0] + point.x * x + point.y * y);
        return number;
    };
    for (const std::vector<int>& cell : cells)
        for (std::size_t i = 1; i + 1 < cell.size(); i += 2) {
            std::vector<int> corner = {vertexOf(cell[0]), vertexOf(cell[i]), vertexOf(cell[i + 1])};
            if (i + 2 < cell.size()) corner.push_back(vertexOf(cell[i + 2]));
            addPatch(corner);
        }
}

void FaceCutter::checkRoom(double patches) const {
    if (static_cast<double>(outPolygons.size()) + patches > static_cast<double>(mostPatches))
        throw Error(face.where, "too many patches: this face alone needs " + std::to_string(patches) + " at size " +
                                    std::to_string(size) + ", expected at most " + std::to_string(mostPatches) +
                                    " in all; take a larger size");
}

int FaceCutter::addVertex(const glm::dvec3& position) {
    Interrupts::check();
    exact.push_back(position);
    outVertices.emplace_back();
    outVertices.back().position = Vec3f(position);
    return static_cast<int>(outVertices.size()) - 1;
}

void FaceCutter::addPatch(const std::vector<int>& corner) {
    Interrupts::check();
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

}  // namespace radlab

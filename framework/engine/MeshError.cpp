#include "engine/MeshError.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/Error.h"

namespace radlab::engine {

namespace {

struct Edge {
    int low, high;  // vertices
    std::size_t patch;

    bool isOf(const Edge& other) const { return low == other.low && high == other.high; }
};

// The edges of all patches, those between the same vertices together.
std::vector<Edge> edgesOf(const PatchMesh& mesh) {
    std::vector<Edge> edges;
    for (std::size_t i = 0; i < mesh.patches.size(); ++i) {
        const MyPolygon& patch = mesh.patches[i];
        for (int k = 0; k < patch.vertices; ++k) {
            const auto [low, high] = std::minmax(patch.vertex[k], patch.vertex[(k + 1) % patch.vertices]);
            edges.push_back({low, high, i});
        }
    }
    std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
        if (a.low != b.low) return a.low < b.low;
        return a.high != b.high ? a.high < b.high : a.patch < b.patch;
    });
    return edges;
}

}  // namespace

double estimateMeshError(const PatchMesh& mesh, const std::vector<Point>& radiosity) {
    RADLAB_CHECK(radiosity.size() == mesh.patches.size());
    std::vector<double> squares(radiosity.size());
    std::vector<int> neighbours(radiosity.size());
    const std::vector<Edge> edges = edgesOf(mesh);
    for (std::size_t k = 0; k + 1 < edges.size(); ++k) {
        if (!edges[k].isOf(edges[k + 1])) continue;
        const std::size_t one = edges[k].patch, other = edges[k + 1].patch;
        const Point difference = radiosity[one] - radiosity[other];
        for (const std::size_t patch : {one, other}) {
            squares[patch] += glm::dot(difference, difference);
            ++neighbours[patch];
        }
    }
    double error = 0.0, known = 0.0, area = 0.0, all = 0.0;
    for (std::size_t i = 0; i < radiosity.size(); ++i) {
        const double a = static_cast<double>(mesh.patches[i].area);
        area += a;
        all += a * glm::dot(radiosity[i], radiosity[i]);
        if (neighbours[i] == 0) continue;
        known += a;
        error += a * squares[i] / neighbours[i] * 2.0 / 12.0;
    }
    if (!(all > 0.0)) return 0.0;
    return known > 0.0 ? std::sqrt(error / known * area / all) : std::numeric_limits<double>::infinity();
}

}  // namespace radlab::engine

#include "engine/PatchShading.h"

#include <algorithm>
#include <cmath>

#include "base/Error.h"

namespace radlab::engine {

namespace {

std::array<double, 4> barycentric(const std::vector<Point>& c, const Point& normal, const Point& point) {
    std::array<double, 4> weights{};
    double sum = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
        const Point &from = c[(i + 1) % 3], &to = c[(i + 2) % 3];
        sum += weights[i] = std::max(0.0, glm::dot(glm::cross(to - from, point - from), normal));
    }
    if (!(sum > 0.0)) return {1.0, 0.0, 0.0, 0.0};
    for (double& weight : weights) weight /= sum;
    return weights;
}

double outside(double share) { return std::max({0.0, -share, share - 1.0}); }

// The root of a·x² + b·x + c that lies in 0..1, or nearest to it.
double rootInUnit(double a, double b, double c) {
    const double q = -0.5 * (b + std::copysign(std::sqrt(std::max(0.0, b * b - 4.0 * a * c)), b));
    const double small = q != 0.0 ? c / q : 0.0, large = a != 0.0 ? q / a : small;
    return std::clamp(outside(large) < outside(small) ? large : small, 0.0, 1.0);
}

// Solves (1 - v)·mix(c0, c1, u) + v·mix(c3, c2, u) = point.
std::array<double, 4> bilinear(const std::vector<Point>& c, const Point& normal, const Point& point) {
    const Point along = c[1] - c[0], across = c[3] - c[0], twist = c[0] - c[1] + c[2] - c[3], at = point - c[0];
    const auto cross = [&](const Point& a, const Point& b) { return glm::dot(glm::cross(a, b), normal); };
    const double v = rootInUnit(cross(twist, across), cross(along, across) + cross(at, twist), cross(at, along));
    const Point row = along + v * twist;
    const double square = glm::dot(row, row);
    const double u = square > 0.0 ? std::clamp(glm::dot(at - v * across, row) / square, 0.0, 1.0) : 0.0;
    return {(1.0 - u) * (1.0 - v), u * (1.0 - v), u * v, (1.0 - u) * v};
}

}  // namespace

std::array<double, 4> cornerWeights(const Polygon& patch, const Point& point) {
    return patch.corners.size() == 3 ? barycentric(patch.corners, patch.normal, point)
                                     : bilinear(patch.corners, patch.normal, point);
}

PatchShading::PatchShading(const PatchMesh& mesh, const Geometry& geometry, std::vector<Point> radiosity)
    : ofPatches(std::move(radiosity)), ofCorners(mesh.corners.size(), Point(0.0)), shapes(&geometry.patches) {
    RADLAB_CHECK(ofPatches.size() == mesh.patches.size());
    std::vector<int> sharing(mesh.corners.size(), 0);
    const auto forCorners = [&](const auto& visit) {
        for (std::size_t i = 0; i < mesh.patches.size(); ++i)
            for (int k = 0; k < mesh.patches[i].vertices; ++k)
                visit(i, std::size_t(k), std::size_t(mesh.patches[i].vertex[k]));
    };
    cornersOf.assign(mesh.patches.size(), {flat, flat, flat, flat});
    forCorners([&](std::size_t, std::size_t, std::size_t corner) { ++sharing[corner]; });
    forCorners([&](std::size_t patch, std::size_t, std::size_t corner) {
        if (sharing[corner] > 1) cornersOf[patch][0] = 0;
    });
    forCorners([&](std::size_t patch, std::size_t k, std::size_t corner) {
        if (cornersOf[patch][0] == flat) return;
        cornersOf[patch][k] = static_cast<int>(corner);
        ofCorners[corner] += ofPatches[patch] / static_cast<double>(sharing[corner]);
    });
    for (const auto& corners : cornersOf) smooth += corners[0] != flat;
}

Point PatchShading::radiosityAt(std::size_t patch, const Point& point) const {
    if (!isSmooth(patch)) return ofPatches[patch];
    const Polygon& shape = (*shapes)[patch];
    const std::array<double, 4> weights = cornerWeights(shape, point);
    Point mean(0.0);
    for (std::size_t k = 0; k < shape.corners.size(); ++k)
        mean += weights[k] * ofCorners[static_cast<std::size_t>(cornersOf[patch][k])];
    return mean;
}

Point PatchShading::radiosityAtCorner(std::size_t patch, std::size_t corner) const {
    return isSmooth(patch) ? ofCorners[static_cast<std::size_t>(cornersOf[patch][corner])] : ofPatches[patch];
}

}  // namespace radlab::engine

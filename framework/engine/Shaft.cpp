#include "engine/Shaft.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "course/FacePolygon.h"

namespace radlab::engine {

namespace {

constexpr int fewPolygons = 8;  // tested sooner than sides are made

// Directions round a circle.
const double diagonal = std::sqrt(0.5);
const std::array<std::array<double, 2>, 8> directions{{{1, 0},
                                                       {diagonal, diagonal},
                                                       {0, 1},
                                                       {-diagonal, diagonal},
                                                       {-1, 0},
                                                       {-diagonal, -diagonal},
                                                       {0, -1},
                                                       {diagonal, -diagonal}}};

Point farthest(const Polygon& polygon, const Point& direction) {
    Point found(0.0);
    double most = -std::numeric_limits<double>::infinity();
    for (const Point& corner : polygon.corners) {
        const double along = glm::dot(corner, direction);
        if (along <= most) continue;
        most = along;
        found = corner;
    }
    return found;
}

// Whether all of a box lies on or behind a plane.
bool behind(const Box& box, const Point& normal, double offset) {
    const Point corner = {normal.x > 0.0 ? box.high.x : box.low.x, normal.y > 0.0 ? box.high.y : box.low.y,
                          normal.z > 0.0 ? box.high.z : box.low.z};
    return glm::dot(normal, corner) <= offset;
}

bool behind(const Polygon& polygon, const Point& normal, double offset) {
    const double center = glm::dot(polygon.center, normal) - offset;
    if (std::abs(center) > polygon.radius) return center < 0.0;
    return std::all_of(polygon.corners.begin(), polygon.corners.end(),
                       [&](const Point& corner) { return glm::dot(normal, corner) <= offset; });
}

bool behind(const Point& from, const Point& to, const Point& normal, double offset) {
    return glm::dot(normal, from) <= offset && glm::dot(normal, to) <= offset;
}

}  // namespace

// Lane by lane, without early exit: a box is tested faster than a branch is foreseen.
bool Shaft::Sides::anyHas(const Box& box) const {
    const Point sum = box.low + box.high, extent = box.high - box.low;
    std::array<double, count> above;
    for (std::size_t i = 0; i < count; ++i)
        above[i] = x[i] * sum.x + y[i] * sum.y + z[i] * sum.z + std::abs(x[i]) * extent.x + std::abs(y[i]) * extent.y +
                   std::abs(z[i]) * extent.z - 2.0 * offset[i];
    double least = above[0];
    for (std::size_t i = 1; i < count; ++i) least = above[i] < least ? above[i] : least;
    return least <= 0.0;
}

Shaft::Shaft(const Polygon& one, const Box& boxA, const Polygon& other, const Box& boxB, double rounding)
    : a(one),
      b(other),
      around(boxA),
      tolerance(rounding),
      heightA(glm::dot(a.normal, a.center) + tolerance),
      heightB(glm::dot(b.normal, b.center) + tolerance) {
    around.add(boxB);
}

bool Shaft::misses(const Box& box) const {
    if (!around.meets(box, tolerance)) return true;
    if (behind(box, a.normal, heightA) || behind(box, b.normal, heightB)) return true;
    return hasSides && sides.anyHas(box);
}

bool Shaft::misses(const Polygon& polygon, const Box& box) {
    if (misses(box) || onOneSide(polygon)) return true;
    if (behind(polygon, a.normal, heightA) || behind(polygon, b.normal, heightB)) return true;
    if (!hasSides && ++notMissed < fewPolygons) return false;
    makeSides();
    return sides.any([&](const Point& inwards, double offset) { return behind(polygon, inwards, offset); });
}

bool Shaft::misses(const Point& from, const Point& to) {
    makeSides();
    Box box;
    box.add(from);
    box.add(to);
    if (!around.meets(box, tolerance)) return true;
    if (behind(from, to, a.normal, heightA) || behind(from, to, b.normal, heightB)) return true;
    return sides.any([&](const Point& inwards, double offset) { return behind(from, to, inwards, offset); });
}

// Whether a polygon's plane leaves both ends on one side; spheres round these mostly tell.
bool Shaft::onOneSide(const Polygon& polygon) const {
    const double toA = glm::dot(a.center - polygon.center, polygon.normal),
                 toB = glm::dot(b.center - polygon.center, polygon.normal);
    if (std::min(toA - a.radius, toB - b.radius) >= 0.0 || std::max(toA + a.radius, toB + b.radius) <= 0.0) return true;
    if (std::min(toA, toB) < -tolerance && std::max(toA, toB) > tolerance) return false;
    const Range ofA = heightsOver(a, polygon.center, polygon.normal),
                ofB = heightsOver(b, polygon.center, polygon.normal);
    return std::min(ofA.low, ofB.low) >= -tolerance || std::max(ofA.high, ofB.high) <= tolerance;
}

int Shaft::direction(const Point& normal) const {
    const Range ofA = heightsOver(a, b.center, normal), ofB = heightsOver(b, b.center, normal);
    if (ofB.low > ofA.high + tolerance) return 1;
    return ofB.high < ofA.low - tolerance ? -1 : 0;
}

void Shaft::makeSides() {
    if (hasSides) return;
    hasSides = true;
    const Point along = b.center - a.center;
    const Point across = glm::cross(along, axisAcross(along));
    if (!(glm::length(across) > 0.0)) return;
    const Point u = glm::normalize(across), v = glm::normalize(glm::cross(along, u));
    for (std::size_t i = 0; i < directions.size(); ++i) setSide(i, directions[i][0] * u + directions[i][1] * v, along);
}

// Turned, where that can be, until it touches both polygons.
void Shaft::setSide(std::size_t i, Point outwards, const Point& along) {
    const Point between = farthest(b, outwards) - farthest(a, outwards);
    const double rise = glm::dot(between, along);
    if (rise > 0.0) outwards = glm::normalize(outwards - glm::dot(between, outwards) / rise * along);
    sides.x[i] = -outwards.x;
    sides.y[i] = -outwards.y;
    sides.z[i] = -outwards.z;
    sides.offset[i] = -std::max(glm::dot(farthest(a, outwards), outwards), glm::dot(farthest(b, outwards), outwards));
}

}  // namespace radlab::engine

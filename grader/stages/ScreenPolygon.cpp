#include "grader/stages/ScreenPolygon.h"

#include <algorithm>
#include <cmath>

namespace radlab::grader {

namespace {

constexpr double floatRounding = 0x1p-24;

// Roundings of a clip coordinate in floats. The worst case is 10 (two matrices, their product, the product with the
// corner); none of Mesa's pixels needs more than 1, even a thousand units from the origin.
constexpr double clipRoundings = 4.0;

// Roundings of a window coordinate in floats.
constexpr double windowRoundings = 2.0;

// Steps of 2^-24 by which an OpenGL's depth may be off on a polygon that faces the eye: one for the buffer's rounding,
// the others for projection and interpolation in floats. Mesa needs 1.
constexpr double depthRoundings = 4.0;

// Rims of what is cut away, in clip coordinates: before the near plane and beside the viewport.
constexpr double nearRim = 1.1, sideRim = 1.5;

constexpr double shortestEdge = 1e-9;  // in pixels; shorter ones have no direction
constexpr double straightSine = 1e-6;  // of the angle by which rounding may bend a straight corner inwards

double cross(const glm::dvec3& a, const glm::dvec3& b) { return a.x * b.y - a.y * b.x; }

}  // namespace

ClipCorner clipCorner(const glm::dvec3& world, const glm::dmat4& m) {
    const glm::dvec3 size = glm::abs(world);
    const glm::dvec4 terms =
        glm::abs(m[0]) * size.x + glm::abs(m[1]) * size.y + glm::abs(m[2]) * size.z + glm::abs(m[3]);
    return {m * glm::dvec4(world, 1.0), clipRoundings * floatRounding * terms};
}

bool ClipPolygon::cut() {
    const std::array<glm::dvec4, 5> planes = {
        {{0, 0, 1, nearRim}, {1, 0, 0, sideRim}, {-1, 0, 0, sideRim}, {0, 1, 0, sideRim}, {0, -1, 0, sideRim}}};
    for (const glm::dvec4& plane : planes) {
        std::array<double, capacity> distances;
        bool all = true, none = true;
        for (std::size_t i = 0; i < count; ++i) {
            distances[i] = glm::dot(plane, corners[i].position);
            (distances[i] >= 0.0 ? none : all) = false;
        }
        if (all) continue;
        if (none) return false;
        const ClipPolygon whole = *this;
        count = 0;
        for (std::size_t i = 0; i < whole.count; ++i) {
            const std::size_t next = (i + 1) % whole.count;
            const double here = distances[i], there = distances[next];
            if (here >= 0.0) add(whole[i]);
            if ((here >= 0.0) == (there >= 0.0)) continue;
            const double t = here / (here - there);
            add({glm::mix(whole[i].position, whole[next].position, t), glm::mix(whole[i].error, whole[next].error, t)});
        }
    }
    return count >= 3;
}

ScreenPolygon::ScreenPolygon(const ClipPolygon& polygon, const IdView& view, int subpixelBits) {
    readCorners(polygon, view, subpixelBits);
    if (count < 3) return;
    findBox(view);
    if (empty()) return;
    findEdges();
    findDepth();
}

void ScreenPolygon::readCorners(const ClipPolygon& polygon, const IdView& view, int subpixelBits) {
    const glm::dvec3 scale = 0.5 * glm::dvec3(view.width, view.height, 1.0);
    const glm::dvec3 shift = scale + glm::dvec3(view.x, view.y, 0.0);
    low = glm::dvec3(INFINITY);
    high = glm::dvec3(-INFINITY);
    glm::dvec3 error(0.0);
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const ClipCorner& corner = polygon[i];
        const double w = corner.position.w;
        // The cut leaves no other w than 0 or more; a corner at 0 is at the eye.
        if (!(w > 0.0)) {
            count = 0;
            return;
        }
        const glm::dvec3 device = glm::dvec3(corner.position) / w;
        error = glm::max(error, scale * (glm::dvec3(corner.error) + glm::abs(device) * corner.error.w) / w);
        corners[count] = scale * device + shift;
        low = glm::min(low, corners[count]);
        high = glm::max(high, corners[count]);
        ++count;
    }
    const double farSide = std::max(view.x + view.width, view.y + view.height);
    margin = std::ldexp(0.5, -subpixelBits) + windowRoundings * floatRounding * farSide + std::max(error.x, error.y);
    cornerDepthError = depthRoundings * floatRounding + error.z;
}

void ScreenPolygon::findBox(const IdView& view) {
    const glm::dvec2 from = glm::ceil(glm::dvec2(low) - margin - 0.5), to = glm::floor(glm::dvec2(high) + margin - 0.5);
    const glm::dvec2 corner(view.x, view.y), size(view.width, view.height);
    first = glm::ivec2(glm::clamp(from, corner, corner + size));
    last = glm::ivec2(glm::clamp(to, corner - 1.0, corner + size - 1.0));
}

void ScreenPolygon::findEdges() {
    for (std::size_t i = 0; i < count; ++i)
        doubledArea += cross(corners[i] - corners[0], corners[(i + 1) % count] - corners[0]);
    const double inwards = doubledArea < 0.0 ? -1.0 : 1.0;
    for (std::size_t i = 0; i < count; ++i) {
        const glm::dvec3& from = corners[i];
        const glm::dvec3 edge = corners[(i + 1) % count] - from;
        const double length = std::abs(edge.x) + std::abs(edge.y);
        if (length < shortestEdge) continue;
        const double a = -inwards * edge.y / length, b = inwards * edge.x / length;
        edges[edgeCount++] = {a, b, -(a * from.x + b * from.y)};
    }
}

void ScreenPolygon::findDepth() {
    // Newell's normal: a mean plane where the corners are not quite in one.
    glm::dvec3 normal(0.0), sum(0.0);
    for (std::size_t i = 0; i < count; ++i) {
        normal += glm::cross(corners[i] - corners[0], corners[(i + 1) % count] - corners[0]);
        sum += corners[i];
    }
    middle = sum / static_cast<double>(count);
    depthError = high.z - low.z;
    if (std::abs(normal.z) < shortestEdge * shortestEdge) return;
    slope = -glm::dvec2(normal) / normal.z;
    double unevenness = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
        const glm::dvec3 off = corners[i] - middle;
        unevenness = std::max(unevenness, std::abs(off.z - glm::dot(slope, glm::dvec2(off))));
    }
    // Depth is interpolated between corners that may have been moved.
    depthError = std::min(depthError, (std::abs(slope.x) + std::abs(slope.y)) * margin + unevenness);
}

bool ScreenPolygon::convex() const {
    glm::dvec3 before(0.0);
    const auto turnsBack = [&](const glm::dvec3& edge) {
        const double sine = cross(before, edge) * (doubledArea < 0.0 ? -1.0 : 1.0);
        return sine < -straightSine * glm::length(glm::dvec2(before)) * glm::length(glm::dvec2(edge));
    };
    for (std::size_t i = 0; i < 2 * count; ++i) {
        const glm::dvec3 edge = corners[(i + 1) % count] - corners[i % count];
        if (std::abs(edge.x) + std::abs(edge.y) < shortestEdge) continue;
        if (turnsBack(edge)) return false;
        before = edge;
    }
    return true;
}

ScreenPolygon::Facing ScreenPolygon::facing() const {
    double outline = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
        const glm::dvec3 edge = glm::abs(corners[(i + 1) % count] - corners[i]);
        outline += edge.x + edge.y;
    }
    // By so much the doubled area changes where every corner moves by the margin.
    if (std::abs(doubledArea) <= 2.0 * margin * (outline + 4.0 * margin)) return Facing::unclear;
    return doubledArea > 0.0 ? Facing::front : Facing::back;
}

glm::ivec2 ScreenPolygon::row(int y) const {
    double from = first.x, to = last.x;
    for (std::size_t i = 0; i < edgeCount; ++i) {
        const Edge& edge = edges[i];
        const double rest = edge.b * (y + 0.5) + edge.c + margin;
        if (edge.a > 0.0) from = std::max(from, std::floor(-rest / edge.a - 0.5));
        if (edge.a < 0.0) to = std::min(to, std::ceil(-rest / edge.a - 0.5));
    }
    if (from > to) return {0, -1};
    return {static_cast<int>(from), static_cast<int>(to)};
}

Coverage ScreenPolygon::coverage(double x, double y) const {
    Coverage found;
    double distance = edgeCount == 0 ? 0.0 : INFINITY;
    for (std::size_t i = 0; i < edgeCount; ++i)
        distance = std::min(distance, edges[i].a * x + edges[i].b * y + edges[i].c);
    if (distance < -margin) return found;
    const double plane = middle.z + slope.x * (x - middle.x) + slope.y * (y - middle.y);
    found.depth = std::clamp(plane, low.z, high.z);
    found.low = std::max(found.depth - depthError, low.z) - cornerDepthError;
    found.high = std::min(found.depth + depthError, high.z) + cornerDepthError;
    // OpenGL cuts at the near and the far plane.
    found.touched = found.high >= 0.0 && found.low <= 1.0;
    found.inside = distance >= 0.0 && edgeCount >= 3 && found.depth >= 0.0 && found.depth <= 1.0;
    found.certain = distance > margin && found.low > 0.0 && found.high < 1.0;
    return found;
}

}  // namespace radlab::grader

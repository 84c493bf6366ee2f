#include "course/FacePolygon.h"

#include <cmath>

#include <doctest/doctest.h>

using namespace radlab;
using doctest::Approx;

namespace {

// Whether a point that is not on an edge lies in a polygon, convex or not.
bool contains(const Polygon2& polygon, const glm::dvec2& p) {
    bool in = false;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec2 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) in = !in;
    }
    return in;
}

}  // namespace

TEST_CASE("convex pieces of an L cover it, though its inner corner lies on the line between two others") {
    const Polygon2 arms = {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
    for (const double size : {1e-6, 1e-3, 0.1, 1.0, 1e6})
        for (int step = 0; step < 360; ++step) {
            CAPTURE(size);
            CAPTURE(step);
            const double angle = 0.0174 * step;
            const glm::dvec2 x(std::cos(angle), std::sin(angle)), y(-x.y, x.x);
            Polygon2 turned;
            for (const glm::dvec2& corner : arms) turned.push_back(size * (0.3 + corner.x * x + corner.y * y));
            double area = 0.0;
            for (const Polygon2& piece : convexPieces(turned)) {
                CHECK(isConvex(piece));
                area += signedArea(piece);
            }
            CHECK(area == Approx(3.0 * size * size).epsilon(1e-9));
            int covered = 0;
            for (const Polygon2& piece : convexPieces(turned))
                covered += contains(piece, size * (0.3 + 1.4 * x + 1.4 * y));
            CHECK(covered == 0);
        }
}

#include "engine/PatchRaster.h"

#include <cmath>
#include <random>

#include <doctest/doctest.h>

#include "engine/ClosedFormRoom.h"
#include "engine/Triangles.h"

using namespace radlab;
using namespace radlab::engine;

namespace {

constexpr std::uint32_t none = PatchImage::nothing;

struct Dice {
    std::mt19937 engine{7};
    double operator()(double low, double high) { return low + (high - low) * (engine() / 4294967296.0); }
    Point point(double size) {
        const double x = (*this)(-size, size), y = (*this)(-size, size);
        return {x, y, (*this)(-size, size)};
    }
};

// Parallelograms, triangles, concave and many-cornered plates around the origin, some through the view's own plane.
std::vector<Polygon> clutter(Dice& dice, int count) {
    std::vector<Polygon> plates;
    for (int i = 0; i < count; ++i) {
        const Point at = dice.point(4), u = dice.point(2), v = dice.point(2);
        const auto place = [&](double x, double y) { return at + x * u + y * v; };
        if (i % 4 == 0) plates.push_back(parallelogram(at, u, v));
        if (i % 4 == 1) plates.push_back(Polygon({place(0, 0), place(1, 0), place(0, 1)}));
        if (i % 4 == 2)
            plates.push_back(
                Polygon({place(0, 0), place(2, 0), place(2, .9), place(.8, .9), place(.8, 2), place(0, 2)}));
        if (i % 4 == 3)
            plates.push_back(Polygon({place(0, 0), place(1, -.3), place(1.5, .4), place(1, 1.2), place(-.2, 1)}));
    }
    return plates;
}

PatchImage drawn(const std::vector<Polygon>& plates, const RasterView& view, Simd simd = widestSimd()) {
    PatchImage image;
    PatchRaster(plates, simd).draw(view, none, image);
    return image;
}

Point rayThrough(const RasterView& view, int x, int y) {
    const double across = (2.0 * x + 1.0) / view.width - 1.0, up = (2.0 * y + 1.0) / view.width + view.bottom;
    return across * view.right + up * view.up + view.forward;
}

// What one ray meets, and whether a hair's breadth might change that.
struct Meeting {
    std::uint32_t patch = none;
    double nearness = 0.0;
    bool close = false;
};

void meet(Meeting& meeting, const Triangle& triangle, const Point& eye, const Point& ray, std::uint32_t patch) {
    const Point a = triangle[0] - eye, b = triangle[1] - eye, c = triangle[2] - eye;
    const Point normal = glm::normalize(glm::cross(b - a, c - a));
    const double sides[] = {glm::dot(glm::normalize(glm::cross(a, b)), ray),
                            glm::dot(glm::normalize(glm::cross(b, c)), ray),
                            glm::dot(glm::normalize(glm::cross(c, a)), ray)};
    const double sign = glm::dot(normal, a) > 0.0 ? 1.0 : -1.0;
    double inside = INFINITY;
    for (const double side : sides) inside = std::min(inside, sign * side);
    if (std::abs(inside) < 1e-5) meeting.close = true;
    if (inside < 0.0) return;
    const double nearness = glm::dot(normal, ray) / glm::dot(normal, a);
    if (std::abs(nearness - meeting.nearness) < 1e-5 * nearness) meeting.close = true;
    if (nearness <= meeting.nearness) return;
    meeting.nearness = nearness;
    meeting.patch = patch;
}

Meeting firstOn(const std::vector<std::vector<Triangle>>& triangles, const Point& eye, const Point& ray) {
    Meeting meeting;
    for (std::size_t i = 0; i < triangles.size(); ++i)
        for (const Triangle& triangle : triangles[i]) meet(meeting, triangle, eye, ray, static_cast<std::uint32_t>(i));
    return meeting;
}

RasterView viewAlong(const Point& forward, const Point& eye, int width, double bottom) {
    RasterView view;
    view.eye = eye;
    view.forward = glm::normalize(forward);
    view.right = glm::normalize(glm::cross(view.forward, Point(0.1, 0.9, 0.2)));
    view.up = glm::cross(view.right, view.forward);
    view.bottom = bottom;
    view.width = width;
    return view;
}

int count(const PatchImage& image, std::uint32_t patch) {
    int found = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) found += image.patchAt(x, y) == patch;
    return found;
}

int differences(const PatchImage& a, const PatchImage& b) {
    int found = 0;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x) found += a.patchAt(x, y) != b.patchAt(x, y);
    return found;
}

}  // namespace

TEST_CASE("raster: each pixel shows the patch that the ray through its centre meets first") {
    Dice dice;
    int compared = 0, shown = 0;
    for (const int size : {8, 10, 38, 64})
        for (int scene = 0; scene < 6; ++scene) {
            const std::vector<Polygon> plates = clutter(dice, 40);
            std::vector<std::vector<Triangle>> triangles;
            for (const Polygon& polygon : plates) triangles.push_back(trianglesOf(polygon));
            const RasterView view = viewAlong(dice.point(1), dice.point(1), size, scene % 2 - 1.0);
            const PatchImage image = drawn(plates, view);
            for (int y = 0; y < view.height(); ++y)
                for (int x = 0; x < view.width; ++x) {
                    const Meeting truth = firstOn(triangles, view.eye, rayThrough(view, x, y));
                    if (truth.close) continue;
                    ++compared;
                    shown += truth.patch != none;
                    REQUIRE(image.patchAt(x, y) == truth.patch);
                }
        }
    CHECK(compared > 25000);
    CHECK(shown > 10000);
}

TEST_CASE("raster: every width of instructions draws the same, to the bit") {
    Dice dice;
    for (const int size : {8, 12, 50, 256})
        for (int scene = 0; scene < 4; ++scene) {
            const std::vector<Polygon> plates = clutter(dice, 300);
            const RasterView view = viewAlong(dice.point(1), dice.point(1), size, scene % 2 - 1.0);
            const PatchImage plain = drawn(plates, view, Simd::plain);
            for (const Simd simd : {Simd::avx2, Simd::avx512}) {
                if (simd > widestSimd()) continue;
                const PatchImage wide = drawn(plates, view, simd);
                CHECK(differences(plain, wide) == 0);
                int unequal = 0;
                for (int y = 0; y < view.height(); ++y)
                    for (int x = 0; x < view.width; ++x) unequal += plain.nearnessAt(x, y) != wide.nearnessAt(x, y);
                CHECK(unequal == 0);
            }
        }
}

TEST_CASE(
    "raster: a closed box of small patches leaves no pixel empty, at any size, also where edges meet pixel centres") {
    const std::vector<Polygon> box = cut(boxSides(2, 2, 2), 6, 7).patches;
    const PatchRaster raster(box);
    PatchImage image;
    RasterView view;
    for (int size = 8; size <= 512; size += 2) {
        CAPTURE(size);
        view.width = size;
        view.eye = Point(1, 1, size % 4 ? 0.5 : 1.0);
        view.bottom = size % 3 ? -1.0 : 0.0;
        raster.draw(view, none, image);
        CHECK(count(image, none) == 0);
        RasterView turned = viewAlong(Point(0.3, 0.2, 1.0), Point(0.9, 1.2, 0.7), size, view.bottom);
        raster.draw(turned, none, image);
        CHECK(count(image, none) == 0);
    }
}

TEST_CASE("raster: patches that share an edge share no pixel: a plate covers as many as its patches do") {
    Dice dice;
    for (int round = 0; round < 20; ++round) {
        const Polygon plate = parallelogram(dice.point(0.5) + Point(-1, -1, 2), dice.point(0.4) + Point(2, 0, 0),
                                            dice.point(0.4) + Point(0, 2, 0));
        RasterView view;
        view.width = 64;
        const PatchImage whole = drawn({plate}, view), parts = drawn(cut({plate}, 5, 3).patches, view);
        CHECK(std::abs(count(whole, none) - count(parts, none)) <= 1);
    }
}

TEST_CASE("raster: of surfaces in one place the lower number is shown everywhere, however they are cut") {
    const Polygon plate = parallelogram({-3, -3, 1}, {6, 0, 2}, {0, 6, 1});
    std::vector<Polygon> plates = {plate};
    for (const Polygon& part : cut({plate}, 7, 5).patches) plates.push_back(part);
    RasterView view;
    view.width = 256;
    const std::size_t parts = plates.size() - 1;
    const PatchImage first = drawn(plates, view);
    CHECK(count(first, none) + count(first, 0) == 256 * 256);
    std::reverse(plates.begin(), plates.end());
    CHECK(count(drawn(plates, view), static_cast<std::uint32_t>(parts)) <= 1);
}

TEST_CASE("raster: the size of the scene and where it lies change nothing to speak of") {
    Dice dice;
    const std::vector<Polygon> plates = clutter(dice, 200);
    const RasterView view = viewAlong({.3, .1, 1}, {.2, .1, .3}, 128, -1.0);
    const PatchImage image = drawn(plates, view);
    const auto changed = [&](double scale, double offset) {
        std::vector<Polygon> others;
        for (const Polygon& polygon : plates) {
            std::vector<Point> corners = polygon.corners;
            for (Point& corner : corners) corner = scale * corner + Point(offset);
            others.emplace_back(corners);
        }
        RasterView other = view;
        other.eye = scale * view.eye + Point(offset);
        return differences(image, drawn(others, other));
    };
    for (const double scale : {0x1p-40, 0x1p-20, 0x1p20, 0x1p40}) CHECK(changed(scale, 0) == 0);
    for (const double scale : {1e-6, 1e6, 1e-30, 1e30}) {
        CAPTURE(scale);
        CHECK(changed(scale, 0) <= 2);
    }
    CHECK(changed(1, 1e6) <= 2);
}

TEST_CASE("raster: what has no area, is met edge-on, lies behind or is left out is not seen") {
    RasterView view;
    view.width = 64;
    const auto seen = [&](const Polygon& polygon) { return 64 * 64 - count(drawn({polygon}, view), none); };
    CHECK(seen(Polygon({Point(0, 0, 1), Point(1, 0, 1), Point(2, 0, 1)})) == 0);
    CHECK(seen(Polygon({Point(0, 0, 1), Point(0, 0, 1), Point(0, 0, 1)})) == 0);
    CHECK(seen(parallelogram({-1, 0, 1}, {2, 0, 0}, {0, 0, 3})) == 0);
    CHECK(seen(parallelogram({-1, 0, -1}, {2, 0, 0}, {0, 0, 3})) == 0);
    CHECK(seen(parallelogram({-1, -1, -1}, {2, 0, 0}, {0, 2, 0})) == 0);
    CHECK(seen(parallelogram({-1, -1, 0}, {2, 0, 0}, {0, 2, 0})) == 0);
    CHECK(seen(parallelogram({-2, -2, 1}, {4, 0, 0}, {0, 4, 0})) == 64 * 64);
    CHECK(seen(parallelogram({-1e3, -1e3, 1e-6}, {2e3, 0, 0}, {0, 2e3, 0})) == 64 * 64);
    PatchImage image;
    PatchRaster({onCeiling(-2, -2, 1, 4, 4), onCeiling(-2, -2, 2, 8, 8)}).draw(view, 0, image);
    CHECK(count(image, 0) == 0);
    CHECK(count(image, 1) > 0);
    PatchRaster({}).draw(view, 0, image);
    CHECK(count(image, none) == 64 * 64);
}

#include <algorithm>
#include <cmath>

#include <doctest/doctest.h>

#include "course/Extensions.h"

namespace {

// Light on one side of a line through the picture, and a display that is the square root, up to white.
struct HalfLit : PictureView {
    glm::dvec2 normal;
    double offset;
    Vec3f light;

    HalfLit(double turn, double from, float radiance)
        : normal(std::cos(turn), std::sin(turn)), offset(from), light(radiance) {}
    Vec3f radiance(float x, float y) const override {
        return glm::dot(normal, glm::dvec2(x, y)) < offset ? light : Vec3f(0.0f);
    }
    Vec3f display(const Vec3f& radiance) const override { return glm::sqrt(glm::min(radiance, Vec3f(1.0f))); }
};

// The share of the unit square with its corner at (x, y) that is lit, by strips: exact along x.
double coverage(const HalfLit& view, double x, double y) {
    const int strips = 2000;
    double sum = 0.0;
    for (int i = 0; i < strips; ++i) {
        const double end = (view.offset - view.normal.y * (y + (i + 0.5) / strips)) / view.normal.x;
        sum += std::clamp(view.normal.x > 0.0 ? end - x : x + 1.0 - end, 0.0, 1.0);
    }
    return sum / strips;
}

}  // namespace

TEST_CASE(
    "anti-aliasing: each pixel along an edge shows the light of the part that is lit, as well as the samples can "
    "tell") {
    for (const double turn : {0.1, 0.7, 1.2, 2.5, 4.0}) {
        const HalfLit view(turn, 8.3 * (std::cos(turn) + std::sin(turn)), 0.8f);
        for (const int samples : {1, 2, 8, 32}) {
            CAPTURE(turn);
            CAPTURE(samples);
            radlab::Image picture(16, 16, Vec3f(0.5f));
            antialias(view, samples, picture);
            for (int y = 0; y < 16; ++y)
                for (int x = 0; x < 16; ++x) {
                    const double shown = static_cast<double>(picture.at(x, y).g), light = shown * shown / 0.8;
                    // An edge crosses at most two squares of each row or column.
                    CHECK(std::abs(light - coverage(view, x, y)) < 1.0 / samples + 1e-3);
                }
        }
    }
}

TEST_CASE("anti-aliasing: with one sample, a pixel shows what is at its centre") {
    const HalfLit view(0.3, 5.0, 0.5f);
    radlab::Image picture(12, 7);
    antialias(view, 1, picture);
    for (int y = 0; y < 7; ++y)
        for (int x = 0; x < 12; ++x)
            CHECK(picture.at(x, y) ==
                  view.display(view.radiance(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f)));
}

TEST_CASE("anti-aliasing: a pixel that a lamp covers in part is as bright as its light, which may be white") {
    const HalfLit view(0.0, 3.25, 20.0f);  // a quarter of column 3
    radlab::Image picture(8, 1);
    antialias(view, 4, picture);
    CHECK(picture.at(2, 0) == Vec3f(1.0f));
    CHECK(picture.at(3, 0) == Vec3f(1.0f));
    CHECK(picture.at(4, 0) == Vec3f(0.0f));
}

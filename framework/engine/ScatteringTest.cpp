#include "engine/Scattering.h"

#include <cmath>
#include <numbers>

#include <doctest/doctest.h>

#include "engine/LowDiscrepancy.h"

using namespace radlab;
using namespace radlab::engine;
using doctest::Approx;

namespace {

// The share of light from a direction that the lobe reflects, at ks = 1.
double lobeAlbedo(const Point& direction, double exponent) {
    constexpr int samples = 20000;
    double sum = 0.0;
    for (int k = 0; k < samples; ++k) {
        const auto at = LowDiscrepancy(7).at(std::uint64_t(k));
        sum += lobeDirection(direction, Point(0, 0, 1), exponent, at[0], at[1]).weight / samples;
    }
    return sum;
}

}  // namespace

TEST_CASE("transparency takes its share first, and a surface never reflects more than arrives") {
    Material material;
    material.diffuse = Vec3f(0.5f, 0.75f, 0.0f);
    material.specular = Vec3f(0.25f, 0.5f, 1.0f);
    material.transparency = 0.5f;
    material.shininess = 0.5f;
    const Scattering glossy = scatteringOf(material);
    CHECK(glossy.diffuse == Point(0.25, 0.375, 0.0));
    CHECK(glossy.specular == Point(0.125, 0.125, 0.5));
    CHECK(glossy.through == 0.5);
    CHECK(glossy.exponent == 64.0);
    CHECK_FALSE(glossy.mirror);
    CHECK_FALSE(glossy.isMatt());
    material.shininess = 1.0f;
    CHECK(scatteringOf(material).mirror);
    CHECK(scatteringOf(Material{}).isMatt());
}

TEST_CASE("a lobe reflects all light that arrives along the normal, and less of what grazes") {
    for (const double exponent : {0.0, 1.0, 20.0, 128.0}) {
        CAPTURE(exponent);
        CHECK(lobeAlbedo(Point(0, 0, -1), exponent) == Approx(1.0).epsilon(1e-3));
        CHECK(lobeAlbedo(glm::normalize(Point(1, 0, -1)), exponent) < 1.0);
        CHECK(lobeAlbedo(glm::normalize(Point(3, 0, -1)), exponent) <
              lobeAlbedo(glm::normalize(Point(1, 0, -1)), exponent));
    }
}

TEST_CASE("a sharp lobe lies about the mirror direction, and directions about a normal follow the cosine") {
    const Point direction = glm::normalize(Point(1, 2, -2)), normal(0, 0, 1);
    CHECK(glm::length(mirrored(direction, normal) - direction * Point(1, 1, -1)) < 1e-15);
    Point sum(0.0);
    double cosines = 0.0;
    constexpr int samples = 20000;
    for (int k = 0; k < samples; ++k) {
        const auto at = LowDiscrepancy(3).at(std::uint64_t(k));
        sum += lobeDirection(direction, normal, 1e6, at[0], at[1]).direction / double(samples);
        const Point spread = cosineDirection(glm::normalize(Point(1, 1, 1)), at[2], at[3]);
        CHECK(glm::length(spread) == Approx(1.0).epsilon(1e-12));
        cosines += glm::dot(spread, glm::normalize(Point(1, 1, 1))) / samples;
    }
    CHECK(glm::length(sum - mirrored(direction, normal)) < 1e-5);
    CHECK(cosines == Approx(2.0 / 3.0).epsilon(1e-3));
}

TEST_CASE("the densities of directions add up to one, and say what a lobe reflects of even light") {
    const Point normal(0, 0, 1), direction = glm::normalize(Point(1, 0, -2));
    for (const double exponent : {0.0, 3.0, 40.0}) {
        CAPTURE(exponent);
        constexpr int samples = 100000;
        double density = 0.0, value = 0.0, cosines = 0.0;
        for (int k = 0; k < samples; ++k) {
            const auto at = LowDiscrepancy(5).at(std::uint64_t(k));
            const double z = 2.0 * at[0] - 1.0, angle = 2.0 * std::numbers::pi * at[1], r = std::sqrt(1.0 - z * z);
            const Point towards(r * std::cos(angle), r * std::sin(angle), z);
            const Reflection lobe = lobeReflection(direction, normal, exponent, towards);
            density += 4.0 * std::numbers::pi * lobe.density / samples;
            value += 4.0 * std::numbers::pi * lobe.value / samples;
            cosines += 4.0 * std::numbers::pi * diffuseReflection(normal, towards).density / samples;
        }
        CHECK(density == Approx(1.0).epsilon(2e-3));
        CHECK(cosines == Approx(1.0).epsilon(2e-3));
        CHECK(value == Approx(lobeAlbedo(direction, exponent)).epsilon(3e-3));
    }
}

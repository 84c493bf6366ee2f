#include "study/PowerFit.h"

#include <cmath>

#include <doctest/doctest.h>

using namespace radlab::study;
using doctest::Approx;

TEST_CASE("exact powers are found exactly") {
    for (const double exponent : {-0.5, 0.0, 1.0, 1.15, 2.0}) {
        CAPTURE(exponent);
        std::vector<glm::dvec2> points;
        for (const double x : {250.0, 1000.0, 4000.0, 64000.0}) points.emplace_back(x, 3e-6 * std::pow(x, exponent));
        const auto fit = fitPower(points);
        REQUIRE(fit);
        CHECK(fit->exponent == Approx(exponent).epsilon(1e-12));
        CHECK(fit->factor == Approx(3e-6).epsilon(1e-10));
        CHECK(fit->at(500) == Approx(3e-6 * std::pow(500.0, exponent)).epsilon(1e-10));
    }
}

TEST_CASE("fewer than two different places fit nothing, and what is 0 is passed over") {
    CHECK(!fitPower({}));
    CHECK(!fitPower({{1, 2}}));
    CHECK(!fitPower({{3, 2}, {3, 4}}));
    CHECK(!fitPower({{3, 2}, {0, 4}, {5, 0}}));
    CHECK(fitPower({{1, 1}, {10, 0}, {100, 100}})->exponent == Approx(1));
}

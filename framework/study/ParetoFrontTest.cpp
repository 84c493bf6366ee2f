#include "study/ParetoFront.h"

#include <doctest/doctest.h>

using namespace radlab::study;

namespace {

Measurement row(double seconds, double error) {
    Measurement made;
    made.seconds = seconds;
    made.solverError = error;
    return made;
}

}  // namespace

TEST_CASE("the Pareto front holds the points that none beats, from left to right") {
    const std::vector<glm::dvec2> points = {{3, 1}, {1, 5}, {2, 3}, {2, 4}, {4, 1}, {5, 0.5}, {2.5, 3}};
    CHECK(paretoFront(points) == std::vector<std::size_t>{1, 2, 0, 5});
}

TEST_CASE("of points that are alike the front has the first, and of none it has none") {
    CHECK(paretoFront({{1, 1}, {1, 1}}) == std::vector<std::size_t>{0});
    CHECK(paretoFront({}).empty());
}

TEST_CASE("for an error that is asked for the quickest row that keeps it is named, or none") {
    const Measurement rough = row(0.1, 0.05), good = row(1.0, 0.01), slow = row(2.0, 0.02), unknown = Measurement();
    const std::vector<const Measurement*> rows = {&slow, &good, &unknown, &rough};
    CHECK(quickestFor(rows, solverError, 0.1) == &rough);
    CHECK(quickestFor(rows, solverError, 0.05) == &rough);
    CHECK(quickestFor(rows, solverError, 0.03) == &good);
    CHECK(quickestFor(rows, solverError, 0.001) == nullptr);
    CHECK(quickestFor(rows, wholeError, 0.1) == nullptr);
    CHECK(bestRows(rows, solverError) == std::vector<const Measurement*>{&rough, &good});
}

TEST_CASE("an error counts for no less than that of its reference") {
    Measurement exact = row(1.0, 1e-9);
    CHECK(*solverError.of(exact) == ErrorKind::least);
    exact.solverReference = 2e-4;
    CHECK(*solverError.of(exact) == 2e-4);
    CHECK(quickestFor({&exact}, solverError, 1e-4) == nullptr);
    CHECK(!wholeError.of(exact));
}

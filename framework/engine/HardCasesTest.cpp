#include "engine/HardCases.h"
#include "engine/RoomSolver.h"

#include <cmath>

#include <doctest/doctest.h>

using namespace radlab::engine;

TEST_CASE("hard cases: every method gives a form factor, within the error that it is allowed") {
    constexpr std::size_t rays = 4096;
    CHECK(hardCases().size() >= 60);
    for (const HardCase& hard : hardCases())
        for (const Method method : {Method::point, Method::polygon, Method::exact, Method::hemicube, Method::hemisphere,
                                    Method::visibility}) {
            CAPTURE(hard.what);
            CAPTURE(nameOf(method));
            const double found = formFactorOf(hard, method, rays);
            CAPTURE(found);
            CAPTURE(hard.truth);
            CHECK(std::isfinite(found));
            CHECK(found >= 0.0);
            if (method != Method::point) CHECK(found <= 1.0 + 1e-12);
            CHECK(std::abs(found - hard.truth) <= allowedError(hard, method, rays));
        }
}

TEST_CASE(
    "hard rooms: every solver gives finite radiosities, none below what is emitted, within the error that it is "
    "allowed") {
    for (const HardRoom& room : hardRooms())
        for (const Solver solver : {Solver::matrix, Solver::shooting, Solver::links}) {
            if (std::isinf(allowedError(room, solver))) continue;
            CAPTURE(room.what);
            CAPTURE(nameOf(solver));
            CHECK(errorOf(room, solver) <= allowedError(room, solver));
        }
}

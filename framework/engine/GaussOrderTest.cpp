#include "engine/GaussOrder.h"

#include <cmath>

#include <doctest/doctest.h>

#include "engine/GaussLegendre.h"

using namespace radlab::engine;

TEST_CASE(
    "Gauss orders: nearer singularities and smaller tolerances need more nodes, and none suffice on the interval") {
    for (const double tolerance : {1e-2, 1e-6, 1e-12}) {
        const GaussOrders orders(tolerance), finer(0.01 * tolerance);
        CHECK(orders.at(1.0) == GaussOrders::most + 1);
        CHECK(orders.at(-3.0) == GaussOrders::most + 1);
        CHECK(orders.at(1e300) == 1);
        for (double distance = 1.01; distance < 1e6; distance *= 1.1) {
            CAPTURE(distance);
            CHECK(orders.at(1.1 * distance) <= orders.at(distance));
            CHECK(finer.at(distance) >= orders.at(distance));
        }
    }
}

TEST_CASE("Gauss orders: the integral of 1/x² is within the tolerance, whatever the distance of its pole") {
    for (const double tolerance : {1e-3, 1e-6, 1e-9, 1e-12}) {
        const GaussOrders orders(tolerance);
        for (double distance = 1.5; distance < 1e4; distance *= 1.17) {
            const int order = orders.at(distance);
            if (order > GaussOrders::most) continue;
            CAPTURE(distance);
            const double begin = distance - 1.0, end = distance + 1.0;
            double sum = 0.0;
            for (const GaussNode& node : gaussLegendre(order))
                sum += 2.0 * node.weight / std::pow(begin + 2.0 * node.position, 2.0);
            CHECK(std::abs(sum * begin * end / 2.0 - 1.0) <= tolerance);
        }
    }
}

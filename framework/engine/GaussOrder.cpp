#include "engine/GaussOrder.h"

#include <cmath>

namespace radlab::engine {

namespace {

bool suffices(int order, double distance, double tolerance) {
    const double ellipse = distance + std::sqrt(distance * distance - 1.0);
    return std::log(8.0 * distance / tolerance) <= 2.0 * order * std::log(ellipse);
}

}  // namespace

GaussOrders::GaussOrders(double tolerance) : error(tolerance) {
    for (int order = 1; order <= most; ++order) {
        double low = 1.0, high = 16.0 / tolerance;
        while (true) {
            const double middle = 0.5 * (low + high);
            if (middle <= low || middle >= high) break;
            (suffices(order, middle, tolerance) ? high : low) = middle;
        }
        nearest[static_cast<std::size_t>(order - 1)] = high;
    }
}

int GaussOrders::at(double distance) const {
    int order = 1;
    while (order <= most && distance < nearest[static_cast<std::size_t>(order - 1)]) ++order;
    return order;
}

}  // namespace radlab::engine

#include "engine/GaussLegendre.h"

#include <array>
#include <cmath>
#include <numbers>

#include "base/Error.h"

namespace radlab::engine {

namespace {

struct Legendre {
    double value, slope;
};

Legendre legendre(int degree, double x) {
    double before = 1.0, value = x;
    for (int k = 2; k <= degree; ++k) {
        const double next = ((2 * k - 1) * x * value - (k - 1) * before) / k;
        before = value;
        value = next;
    }
    return {value, degree * (x * value - before) / (x * x - 1.0)};
}

// Newton's iteration on the Legendre polynomial converges from these starts for every root.
double root(int count, int i) {
    double x = std::cos(std::numbers::pi * (i + 0.75) / (count + 0.5));
    for (int step = 0; step < 10; ++step) {
        const Legendre at = legendre(count, x);
        x -= at.value / at.slope;
    }
    return x;
}

std::vector<GaussNode> rule(int count) {
    if (count == 1) return {{0.5, 1.0}};
    std::vector<GaussNode> nodes;
    for (int i = 0; i < count; ++i) {
        const double x = root(count, i), slope = legendre(count, x).slope;
        nodes.push_back({0.5 * (1.0 - x), 1.0 / ((1.0 - x * x) * slope * slope)});
    }
    return nodes;
}

std::array<std::vector<GaussNode>, mostGaussNodes> table() {
    std::array<std::vector<GaussNode>, mostGaussNodes> rules;
    for (int i = 0; i < mostGaussNodes; ++i) rules[static_cast<std::size_t>(i)] = rule(i + 1);
    return rules;
}

}  // namespace

const std::vector<GaussNode>& gaussLegendre(int count) {
    static const std::array<std::vector<GaussNode>, mostGaussNodes> rules = table();
    RADLAB_CHECK(count >= 1);
    RADLAB_CHECK(count <= mostGaussNodes);
    return rules[static_cast<std::size_t>(count) - 1];
}

}  // namespace radlab::engine

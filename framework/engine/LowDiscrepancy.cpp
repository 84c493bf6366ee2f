#include "engine/LowDiscrepancy.h"

#include <cmath>

namespace radlab::engine {

namespace {

constexpr double root = 1.1673039782614187;  // of x⁵ = x + 1

// A mix of all bits (the finaliser of SplitMix64).
std::uint64_t mixed(std::uint64_t bits) {
    bits += 0x9e3779b97f4a7c15;
    bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9;
    bits = (bits ^ (bits >> 27)) * 0x94d049bb133111eb;
    return bits ^ (bits >> 31);
}

}  // namespace

std::array<double, 4> lowDiscrepancyPoint(std::uint64_t key, std::uint64_t k) {
    std::array<double, 4> point;
    double step = 1.0;
    std::uint64_t shift = mixed(key);
    for (double& coordinate : point) {
        step /= root;
        shift = mixed(shift);
        const double x = static_cast<double>(shift >> 11) * 0x1p-53 + step * static_cast<double>(k + 1);
        coordinate = x - std::floor(x);
    }
    return point;
}

}  // namespace radlab::engine

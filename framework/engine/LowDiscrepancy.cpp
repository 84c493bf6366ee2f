#include "engine/LowDiscrepancy.h"

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

const std::array<double, 4> LowDiscrepancy::steps = {1.0 / root, 1.0 / root / root, 1.0 / root / root / root,
                                                     1.0 / root / root / root / root};

LowDiscrepancy::LowDiscrepancy(std::uint64_t key) {
    std::uint64_t bits = mixed(key);
    for (double& shift : shifts) {
        bits = mixed(bits);
        shift = static_cast<double>(bits >> 11) * 0x1p-53;
    }
}

}  // namespace radlab::engine

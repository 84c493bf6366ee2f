#include "engine/LowDiscrepancy.h"

#include "engine/RandomNumbers.h"

namespace radlab::engine {

namespace {

constexpr double root = 1.1673039782614187;  // of x⁵ = x + 1

}  // namespace

const std::array<double, 4> LowDiscrepancy::steps = {1.0 / root, 1.0 / root / root, 1.0 / root / root / root,
                                                     1.0 / root / root / root / root};

LowDiscrepancy::LowDiscrepancy(std::uint64_t key) {
    std::uint64_t bits = mixedBits(key);
    for (double& shift : shifts) {
        bits = mixedBits(bits);
        shift = unitOf(bits);
    }
}

}  // namespace radlab::engine

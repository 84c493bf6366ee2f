#pragma once

#include <array>
#include <cstdint>

namespace radlab::engine {

/// A sequence of points that fills the unit cube of four dimensions evenly, shifted by a key.
///
/// The same for the same key on every machine; different keys give sequences that have nothing to do with each other.
///
/// @source additive recurrence by the powers of the root of x⁵ = x + 1, the generalised golden ratio
class LowDiscrepancy {
public:
    explicit LowDiscrepancy(std::uint64_t key);

    /// The k-th point.
    std::array<double, 4> at(std::uint64_t k) const {
        std::array<double, 4> point;
        for (std::size_t i = 0; i < point.size(); ++i) {
            const double x = shifts[i] + steps[i] * static_cast<double>(k + 1);
            point[i] = x - static_cast<double>(static_cast<std::uint64_t>(x));
        }
        return point;
    }

private:
    static const std::array<double, 4> steps;
    std::array<double, 4> shifts;
};

}  // namespace radlab::engine

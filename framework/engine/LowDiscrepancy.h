#pragma once

#include <array>
#include <cstdint>

namespace radlab::engine {

/// The k-th point of a sequence that fills the unit cube of four dimensions evenly, shifted by a key.
///
/// The same for the same key and k on every machine; different keys give sequences that have nothing to do with each other.
///
/// @source additive recurrence by the powers of the root of x⁵ = x + 1, the generalised golden ratio
std::array<double, 4> lowDiscrepancyPoint(std::uint64_t key, std::uint64_t k);

}  // namespace radlab::engine

#pragma once

#include <optional>

#include "engine/FormFactors.h"

namespace radlab::engine {

/// A pair of patches that a method cannot hold.
struct WorstPair {
    std::size_t from = 0, to = 0;
    double found = 0.0;  ///< the method's form factor, with nothing between
    double exact = 0.0;
};

/// The pair for which a method that takes patches for points errs most: near ones, and those that touch.
///
/// Looks at the nearest patch of each of a few hundred patches.
///
/// @return nothing where the worst is off by less than 0.05, and for methods that take patches whole
/// @cost   some ten milliseconds
std::optional<WorstPair> worstPair(const Geometry& geometry, Method method);

}  // namespace radlab::engine

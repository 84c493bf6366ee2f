#pragma once

#include <nlohmann/json.hpp>

namespace radlab {

/// The numbers of the handout that are the same on every machine, by the names that its text gives them.
///
/// @pre    a GlContext is current
/// @return texts to put into the handout, and one table: the delta form factors of a hemicube of size 8
/// @cost   some seconds
nlohmann::ordered_json handoutNumbers();

}  // namespace radlab

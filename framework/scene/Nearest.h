#pragma once

#include <span>
#include <string>
#include <string_view>

namespace radlab {

/// How many letters have to be added, dropped or changed to turn one word into another.
///
/// @cost the product of the lengths
/// @source [Levenshtein1966]
std::size_t editDistance(std::string_view from, std::string_view to);

/// A hint for a mistyped word: ", did you mean 'hemicube_size'?", or nothing where no known word is near.
std::string didYouMean(std::string_view word, std::span<const char* const> known);

}  // namespace radlab

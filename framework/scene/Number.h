#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace radlab {

/// The number that a piece of text spells, or nothing where it spells none.
///
/// The whole text must be the number: optional sign, digits with an optional point, optional exponent. Words
/// such as nan and inf, hexadecimal digits and suffixes are no numbers. The point is a point in every locale,
/// which strtof does not promise; std::from_chars would, but is not there for floats everywhere.
///
/// @return the value within a few units in the last place of a double; 0 below 1e-60, infinity above 1e60
/// @cost   one pass over the text
std::optional<double> parseNumber(std::string_view text);

/// The whole number that a piece of text spells, or nothing where it spells none or it does not fit an int.
std::optional<int> parseWhole(std::string_view text);

/// The pieces of a list as X3D writes it: separated by white space, commas or both.
std::vector<std::string_view> splitList(std::string_view text);

/// A number as messages show it, with a point in every locale.
std::string numberText(double value);

}  // namespace radlab

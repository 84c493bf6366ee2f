#pragma once

#include <charconv>
#include <cstdio>
#include <string>

namespace radlab {

/// Appends a number with so many significant digits, the same in every locale and fast enough for millions of them.
///
/// @param digits 1 to 17
inline void appendNumber(std::string& text, double value, int digits) {
    char number[32];
    text.append(number, std::to_chars(number, number + sizeof number, value, std::chars_format::general, digits).ptr);
}

/// A number by printf's form for one double, such as "%.2f %%".
///
/// @pre what comes out has fewer than 64 characters
inline std::string numberText(const char* form, double value) {
    char text[64];
    return {text, static_cast<std::size_t>(std::snprintf(text, sizeof text, form, value))};
}

/// "1,234,567".
inline std::string withCommas(std::size_t number) {
    std::string digits = std::to_string(number);
    for (auto place = static_cast<std::ptrdiff_t>(digits.size()) - 3; place > 0; place -= 3)
        digits.insert(static_cast<std::size_t>(place), ",");
    return digits;
}

}  // namespace radlab

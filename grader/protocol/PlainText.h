#pragma once

#include <string>
#include <string_view>

namespace radlab::grader {

// What a submission prints is hostile: it may break an encoding, forge lines of a report or send commands to
// a terminal. Everything of a submission passes through one of these before anybody sees it.

/// A character of a text in UTF-8.
struct Character {
    char32_t value = 0;      ///< U+FFFD where the bytes are not UTF-8
    std::size_t length = 0;  ///< in bytes, at least 1
    bool valid = true;
};

/// The first character of a text.
///
/// Overlong forms, surrogates and characters that are cut off are not valid.
///
/// @pre    bytes is not empty
/// @source Unicode 15, section 3.9, table 3-7; invalid bytes are grouped by its "maximal subparts"
Character firstCharacter(std::string_view bytes);

/// The text with U+FFFD in place of what is not UTF-8.
std::string validUtf8(std::string_view bytes);

/// The text as a person may see it: control characters spelled out ("\x1b", "\u202e"), the rest as in validUtf8.
///
/// Stays as it is: newline and tab. The end of line of Windows becomes a newline. Spelled out are all that a
/// terminal obeys and all that turns the direction of a text round.
std::string visibleText(std::string_view bytes);

/// The text as XML 1.0 may hold it, not yet escaped: validUtf8 without control characters but newline and tab.
///
/// @source XML 1.0, section 2.2; the control characters that it discourages are left out too
std::string xmlText(std::string_view bytes);

/// The first bytes of a text, at most so many, and never half a character.
std::string_view startOf(std::string_view text, std::size_t bytes);

}  // namespace radlab::grader

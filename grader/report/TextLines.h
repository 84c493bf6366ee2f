#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace radlab::grader {

// Lines of a terminal. All texts here are UTF-8 without control characters, as visibleText makes them.

/// How many columns a text takes in a terminal, rather too many than too few.
///
/// @source Unicode Standard Annex 11 (East Asian width), in broad blocks
int columnsOf(std::string_view text);

/// The text on one line: newlines and tabs become spaces, and what a terminal obeys is spelled out.
std::string oneLine(std::string_view bytes);

/// The text, or as much of it as fits with "…" at its end.
///
/// @pre columns >= 2
std::string cutLine(std::string_view text, int columns);

/// The text in lines of at most so many columns.
///
/// Lines end between words, in a word only where it is too long for a line. A line that fits keeps its spaces, and the
/// lines that one is broken into are indented as it was. Tabs become four spaces; empty lines at the end are left out.
///
/// @pre columns >= 4
std::vector<std::string> wrapText(std::string_view text, int columns);

/// Keeps the first lines, at most so many; "…" at the end of the last one says that more were left out.
void limitLines(std::vector<std::string>& lines, std::size_t most, int columns);

}  // namespace radlab::grader

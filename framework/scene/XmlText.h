#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace radlab {

/// A path as messages show it: UTF-8 on every platform.
std::string pathText(const std::filesystem::path& path);

/// The path that UTF-8 text spells.
std::filesystem::path pathFromText(std::string_view text);

/// A piece of a file as messages show it: in single quotes, shortened, without control characters.
std::string inQuotes(std::string_view text);

/// All text of a file.
///
/// @throws Error where there is no such file, it is a folder, cannot be read or is larger than 1 GiB
/// @return the bytes as they stand
/// @cost   one read of the whole file
std::string readTextFile(const std::filesystem::path& file);

/// Checks that bytes are text which XML may hold.
///
/// @throws Error with the line of the first byte that is not UTF-8, or is a control character other than tab
///         and line ends
/// @cost   one pass
void checkText(std::string_view text, const std::string& fileName);

/// Blanks out the document type, line ends kept: tinyxml2 stumbles over one with declarations in brackets.
///
/// @return text of the same length and the same lines
/// @cost   one copy
std::string withoutDoctype(std::string_view text);

}  // namespace radlab

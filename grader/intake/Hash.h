#pragma once

#include <map>
#include <string>
#include <string_view>

namespace radlab::grader {

/// SHA-256 of bytes, in hexadecimal: 64 digits.
std::string sha256(std::string_view bytes);

/// SHA-256 over files: no two sets of files give the same bytes to hash.
///
/// Hashed are how many there are, then for each the length of its name, its name, the length of its contents, and
/// these; numbers as eight bytes, the lowest first.
std::string hashOf(const std::map<std::string, std::string>& files);

}  // namespace radlab::grader

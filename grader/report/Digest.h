#pragma once

#include <string>
#include <string_view>

namespace radlab::grader {

/// Bytes as base64, as data: addresses hold them.
///
/// Errors: a build without libsodium.
/// @source RFC 4648, section 4
std::string base64(std::string_view bytes);

/// The SHA-256 of bytes as base64, as a page names the script that it allows.
///
/// Errors: a build without libsodium.
/// @source W3C, Content Security Policy Level 3, section 2.3.1
std::string sha256Base64(std::string_view bytes);

}  // namespace radlab::grader

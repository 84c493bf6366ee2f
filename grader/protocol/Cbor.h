#pragma once

#include <cstddef>
#include <string_view>

#include <nlohmann/json_fwd.hpp>

namespace radlab::grader {

/// Reads CBOR that nobody vouches for, in the form in which Json::to_cbor writes it.
///
/// The library's reader calls itself for each level, so that bytes of nothing but levels would overflow the stack.
/// Refused with them are tags and what does not say its length, which Json::to_cbor never writes, and more than a
/// million items, each of which takes many times as much memory as bytes.
///
/// @param depth the most arrays and objects inside one another; 0 allows a single number or text
/// Errors: deeper nesting, more items, bytes that are cut off, left over, or no CBOR.
/// @source RFC 8949, section 3
nlohmann::json cborWithin(std::string_view bytes, std::size_t depth);

}  // namespace radlab::grader

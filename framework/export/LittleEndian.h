#pragma once

#include <bit>
#include <concepts>
#include <cstdint>
#include <string>

#include "course/Vec3f.h"

namespace radlab {

/// Appends the bytes of an unsigned number, the lowest first.
template <std::unsigned_integral Number>
void appendBytes(std::string& bytes, Number number) {
    for (std::size_t i = 0; i < sizeof number; ++i) bytes += static_cast<char>((number >> (8 * i)) & 0xff);
}

/// The same for three floats.
inline void appendBytes(std::string& bytes, const Vec3f& v) {
    for (int c = 0; c < 3; ++c) appendBytes(bytes, std::bit_cast<std::uint32_t>(v[c]));
}

}  // namespace radlab

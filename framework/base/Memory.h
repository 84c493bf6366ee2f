#pragma once

#include <cstddef>
#include <string>

namespace radlab {

/// "2.3 GiB", "512 MiB", "12 KiB".
std::string bytesText(double bytes);

/// Makes sure that this machine has the memory that a work is about to take.
///
/// @param what  the work, for the message: "the form factors of 100,000 patches"
/// @param hint  what to do where there is not enough
/// Errors: less memory is free; the message says both figures. Where the machine does not say, nothing is refused.
void requireMemory(double bytes, const std::string& what, const std::string& hint);

}  // namespace radlab

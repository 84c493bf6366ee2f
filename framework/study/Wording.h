#pragma once

#include <string>

namespace radlab::study {

/// "0.031 %", "4.2 %", "123 %", with so many significant digits and a space that does not break.
std::string shareText(double share, int digits = 2);

/// "0.42 ms", "12 ms", "1.3 s", "48 s".
std::string secondsText(double seconds);

/// "1,056".
std::string countText(double count);

}  // namespace radlab::study

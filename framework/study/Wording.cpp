#include "study/Wording.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace radlab::study {

namespace {

// So many significant digits, no exponent.
std::string decimal(double value, int digits) {
    char text[64];
    std::snprintf(text, sizeof text, "%.*e", digits - 1, value);
    const int power = std::atoi(std::strchr(text, 'e') + 1);  // of the rounded number
    std::snprintf(text, sizeof text, "%.*f", std::clamp(digits - 1 - power, 0, 9), value);
    return text;
}

}  // namespace

std::string shareText(double share, int digits) { return decimal(100.0 * share, digits) + "\u00a0%"; }

std::string secondsText(double seconds) {
    return seconds < 0.1 ? decimal(1000.0 * seconds, 2) + " ms" : decimal(seconds, 2) + " s";
}

std::string countText(double count) {
    std::string digits = decimal(count, 1);
    for (auto place = static_cast<std::ptrdiff_t>(digits.size()) - 3; place > 0; place -= 3)
        digits.insert(static_cast<std::size_t>(place), ",");
    return digits;
}

}  // namespace radlab::study

#include "base/Memory.h"

#include <cstdio>
#include <fstream>

#include "base/Error.h"

namespace radlab {

namespace {

// Linux says how much memory a program could get without swapping; elsewhere the system's own limit must do.
double availableMemory() {
    std::ifstream info("/proc/meminfo");
    for (std::string line; std::getline(info, line);) {
        unsigned long long kibibytes = 0;
        if (std::sscanf(line.c_str(), "MemAvailable: %llu kB", &kibibytes) == 1)
            return static_cast<double>(kibibytes) * 1024.0;
    }
    return -1.0;
}

}  // namespace

std::string bytesText(double bytes) {
    const char* units[] = {"bytes", "KiB", "MiB", "GiB", "TiB"};
    std::size_t unit = 0;
    for (; bytes >= 1024.0 && unit < 4; ++unit) bytes /= 1024.0;
    char text[64];
    std::snprintf(text, sizeof text, bytes < 10.0 && unit > 0 ? "%.1f %s" : "%.0f %s", bytes, units[unit]);
    return text;
}

void requireMemory(double bytes, const std::string& what, const std::string& hint) {
    const double available = availableMemory();
    if (available < 0.0 || bytes <= available) return;
    throw Error(what + " need " + bytesText(bytes) + " of memory, and this machine has " + bytesText(available) +
                " left: " + hint);
}

}  // namespace radlab

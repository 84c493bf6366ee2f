#include "study/PeakMemory.h"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <string>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace radlab::study {

namespace {

std::optional<double> statusBytes(const std::string& name) {
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);) {
        unsigned long long kibibytes = 0;
        if (line.rfind(name, 0) == 0 && std::sscanf(line.c_str() + name.size(), ": %llu kB", &kibibytes) == 1)
            return static_cast<double>(kibibytes) * 1024.0;
    }
    return {};
}

}  // namespace

PeakMemory::PeakMemory() {
#ifdef __GLIBC__
    malloc_trim(0);
#endif
    std::ofstream refs("/proc/self/clear_refs");
    refs << "5" << std::flush;  // the peak starts anew
    if (refs) before = statusBytes("VmRSS");
}

std::optional<double> PeakMemory::growth() const {
    const std::optional<double> peak = before ? statusBytes("VmHWM") : std::nullopt;
    if (!peak) return {};
    return std::max(*peak - *before, 0.0);
}

}  // namespace radlab::study

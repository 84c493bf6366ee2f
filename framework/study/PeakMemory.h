#pragma once

#include <optional>

namespace radlab::study {

/// Watches by how much the program grows while it lives: what it holds in memory at most, less what it held before.
class PeakMemory {
public:
    /// Gives back what is free, and counts from there.
    PeakMemory();

    /// @return bytes; nothing where the system does not say (other than Linux)
    std::optional<double> growth() const;

private:
    std::optional<double> before;
};

}  // namespace radlab::study

#pragma once

#include <array>
#include <vector>

#include <glm/glm.hpp>

namespace radlab {

/// Which colour channels carry light of their own; the others are dark, or multiples of these.
struct Channels {
    static constexpr int dark = -1;

    std::array<int, 3> like{dark, dark, dark};   ///< the channel that each is a multiple of: itself where it is solved
    std::array<double, 3> ratio{0.0, 0.0, 0.0};  ///< to that channel

    bool solved(int channel) const { return like[static_cast<std::size_t>(channel)] == channel; }
    /// All three channels, where those that are solved are given.
    glm::dvec3 spread(const glm::dvec3& values) const {
        glm::dvec3 all(0.0);
        for (int c = 0; c < 3; ++c) {
            const auto at = static_cast<std::size_t>(c);
            if (like[at] != dark) all[c] = ratio[at] * values[like[at]];
        }
        return all;
    }
    int count() const { return solved(0) + solved(1) + solved(2); }
};

/// The fewest channels that give all three.
///
/// A channel without emission is dark. One whose reflectances are another's, and whose emissions are in one
/// proportion to that one's, is its multiple.
///
/// @pre as many emissions as reflectances
/// @cost one pass over both
Channels channelsOf(const std::vector<glm::dvec3>& emission, const std::vector<glm::dvec3>& reflectance);

/// "red", "green" or "blue".
const char* nameOfChannel(int channel);

}  // namespace radlab

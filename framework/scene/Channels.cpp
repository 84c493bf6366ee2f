#include "scene/Channels.h"

#include <algorithm>
#include <cmath>

#include "base/Error.h"

namespace radlab {

namespace {

using Colors = std::vector<glm::dvec3>;

bool isDark(const Colors& emission, int channel) {
    return std::all_of(emission.begin(), emission.end(), [=](const glm::dvec3& e) { return e[channel] == 0.0; });
}

bool areEqual(const Colors& reflectance, int a, int b) {
    return std::all_of(reflectance.begin(), reflectance.end(), [=](const glm::dvec3& rho) { return rho[a] == rho[b]; });
}

// By how much one channel's light is another's, or 0 where they are not in one proportion.
double proportion(const Colors& emission, int of, int to) {
    const auto brightest = std::max_element(emission.begin(), emission.end(),
                                            [=](const glm::dvec3& a, const glm::dvec3& b) { return a[to] < b[to]; });
    const double ratio = (*brightest)[of] / (*brightest)[to];
    for (const glm::dvec3& e : emission)
        if (std::abs(e[of] - ratio * e[to]) > 1e-12 * ratio * e[to]) return 0.0;
    return ratio;
}

}  // namespace

Channels channelsOf(const Colors& emission, const Colors& reflectance) {
    RADLAB_CHECK(emission.size() == reflectance.size());
    Channels channels;
    for (int channel = 0; channel < 3; ++channel) {
        if (isDark(emission, channel)) continue;
        const auto at = static_cast<std::size_t>(channel);
        channels.like[at] = channel;
        channels.ratio[at] = 1.0;
        for (int other = 0; other < channel; ++other) {
            if (!channels.solved(other) || !areEqual(reflectance, channel, other)) continue;
            const double ratio = proportion(emission, channel, other);
            if (ratio == 0.0) continue;
            channels.like[at] = other;
            channels.ratio[at] = ratio;
            break;
        }
    }
    return channels;
}

const char* nameOfChannel(int channel) { return std::array{"red", "green", "blue"}[static_cast<std::size_t>(channel)]; }

}  // namespace radlab

#include "display/FalseColor.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/glm.hpp>

namespace radlab {

namespace {

glm::vec3 fromHue(float hue, float saturation, float value) {
    const auto channel = [&](float shift) {
        const float k = std::fmod(shift + hue * 6.0f, 6.0f);
        return value - value * saturation * std::clamp(std::min(k, 4.0f - k), 0.0f, 1.0f);
    };
    return {channel(5.0f), channel(3.0f), channel(1.0f)};
}

}  // namespace

glm::vec3 idColor(std::size_t id) {
    if (id == 0) return glm::vec3(0.0f);
    const auto turns = [id](double step) { return static_cast<float>(std::fmod(static_cast<double>(id) * step, 1.0)); };
    return fromHue(turns(0.6180339887), 0.45f + 0.3f * turns(0.7548776662), 0.6f + 0.4f * turns(0.5698402910));
}

glm::vec3 heatColor(float share) {
    static const std::array<glm::vec3, 6> stops = {{{0.0f, 0.0f, 0.02f},
                                                    {0.26f, 0.06f, 0.42f},
                                                    {0.58f, 0.15f, 0.40f},
                                                    {0.87f, 0.32f, 0.23f},
                                                    {0.99f, 0.65f, 0.04f},
                                                    {0.99f, 1.00f, 0.75f}}};
    if (!(share > 0.0f)) return stops.front();
    const float place = std::min(share, 1.0f) * static_cast<float>(stops.size() - 1);
    const std::size_t below = std::min(static_cast<std::size_t>(place), stops.size() - 2);
    return glm::mix(stops[below], stops[below + 1], place - static_cast<float>(below));
}

glm::vec3 formFactorColor(float formFactor) {
    constexpr float lowest = -7.0f, highest = -2.0f;  // powers of ten
    if (!(formFactor > 0.0f)) return heatColor(0.0f);
    return heatColor((std::log10(formFactor) - lowest) / (highest - lowest));
}

}  // namespace radlab

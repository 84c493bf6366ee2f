#include "display/ToneMap.h"

#include <algorithm>
#include <cmath>

#include <glm/glm.hpp>

#include "base/Error.h"

namespace radlab {

float srgbFromLinear(float linear) {
    return linear <= 0.0031308f ? 12.92f * linear : 1.055f * std::pow(linear, 1.0f / 2.4f) - 0.055f;
}

glm::vec3 toneMap(const glm::vec3& radiance, float exposure) {
    const glm::vec3 clamped = glm::clamp(exposure * radiance, 0.0f, 1.0f);
    return {srgbFromLinear(clamped.r), srgbFromLinear(clamped.g), srgbFromLinear(clamped.b)};
}

Image toneMap(const Image& radiance, float exposure) {
    RADLAB_CHECK(exposure > 0.0f);
    Image shown = radiance;
    for (glm::vec3& pixel : shown.data()) pixel = toneMap(pixel, exposure);
    return shown;
}

float autoExposure(const Image& radiance) {
    std::vector<float> lit;
    for (const glm::vec3& pixel : radiance.data()) {
        const float brightest = std::max({pixel.r, pixel.g, pixel.b});
        if (brightest > 0.0f) lit.push_back(brightest);
    }
    if (lit.empty()) return 1.0f;
    const auto percentile = lit.begin() + static_cast<std::ptrdiff_t>(0.95 * static_cast<double>(lit.size() - 1));
    std::nth_element(lit.begin(), percentile, lit.end());
    return 0.8f / *percentile;
}

}  // namespace radlab

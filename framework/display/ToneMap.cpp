#include "display/ToneMap.h"

#include <algorithm>
#include <cmath>

#include <glm/glm.hpp>

#include "base/Error.h"

namespace radlab {

float srgbFromLinear(float linear) {
    return linear <= 0.0031308f ? 12.92f * linear : 1.055f * std::pow(linear, 1.0f / 2.4f) - 0.055f;
}

namespace {

float curved(float x, ToneCurve curve) {
    x = std::max(x, 0.0f);
    if (curve == ToneCurve::reinhard) x = x / (1.0f + x);
    if (curve == ToneCurve::filmic) x = x * (2.51f * x + 0.03f) / (x * (2.43f * x + 0.59f) + 0.14f);
    return std::min(x, 1.0f);
}

}  // namespace

glm::vec3 toneMapped(const glm::vec3& radiance, float exposure, ToneCurve curve) {
    const auto channel = [&](float value) { return srgbFromLinear(curved(exposure * value, curve)); };
    return {channel(radiance.r), channel(radiance.g), channel(radiance.b)};
}

Image toneMap(const Image& radiance, float exposure) {
    RADLAB_CHECK(exposure > 0.0f);
    Image shown = radiance;
    for (glm::vec3& pixel : shown.data()) pixel = toneMapped(pixel, exposure);
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

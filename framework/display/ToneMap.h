#pragma once

#include "base/Image.h"

namespace radlab {

/// How radiances times exposure are brought into 0..1.
enum class ToneCurve {
    clamp,     ///< what is above 1 is white
    reinhard,  ///< x / (1 + x): nothing is ever quite white [Reinhard2002, equation 3]
    filmic,    ///< a fit of the ACES film curve: deeper shadows, soft lights [Narkowicz2015]
};

/// One colour of linear radiance made ready for display: times exposure, by the curve into 0..1, through the sRGB curve.
///
/// @param exposure display value per radiance, > 0
glm::vec3 toneMapped(const glm::vec3& radiance, float exposure, ToneCurve curve = ToneCurve::clamp);

/// Makes linear radiance ready for display: times exposure, clamped to 0..1, through the sRGB curve.
///
/// @param exposure display value per radiance, > 0
/// @source [IEC61966]
Image toneMap(const Image& radiance, float exposure);

/// An exposure that shows all but the brightest twentieth of the lit pixels below white.
///
/// @return 0.8 over the 95th percentile of the largest channel of pixels that are not black; 1 where all are
float autoExposure(const Image& radiance);

/// The sRGB curve for one channel, 0..1 to 0..1.
///
/// @source [IEC61966]
float srgbFromLinear(float linear);

}  // namespace radlab

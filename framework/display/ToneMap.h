#pragma once

#include "base/Image.h"

namespace radlab {

/// Makes linear radiance ready for display: times exposure, clamped to 0..1, through the sRGB curve.
///
/// @param exposure display value per radiance, > 0
/// @source [IEC61966]
Image toneMap(const Image& radiance, float exposure);

/// The same for one colour.
glm::vec3 toneMap(const glm::vec3& radiance, float exposure);

/// An exposure that shows all but the brightest twentieth of the lit pixels below white.
///
/// @return 0.8 over the 95th percentile of the largest channel of pixels that are not black; 1 where all are
float autoExposure(const Image& radiance);

/// The sRGB curve for one channel, 0..1 to 0..1.
///
/// @source [IEC61966]
float srgbFromLinear(float linear);

}  // namespace radlab

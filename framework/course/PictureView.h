#pragma once

#include "course/Vec3f.h"

/// What is seen through a picture, and how it is shown.
///
/// x runs to the right and y down, both in pixels: pixel (3, 0) is the square from (3, 0) to (4, 1), in the top row.
class PictureView {
public:
    virtual ~PictureView() = default;

    /// The radiance that is seen at one point of the picture, W/(m² sr) per channel; it has no upper end.
    virtual Vec3f radiance(float x, float y) const = 0;

    /// How a radiance is shown on a screen, 0 to 1 per channel: cut off at white, then through a tone curve, which is
    /// not linear.
    ///
    /// @source [IEC61966]
    virtual Vec3f display(const Vec3f& radiance) const = 0;
};

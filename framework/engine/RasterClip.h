#pragma once

namespace radlab::engine::raster {

/// A corner as a view sees it: it shows at x/w, y/w.
struct Corner {
    double x, y, w;
};

constexpr int mostClipped = 8;  ///< corners of a piece of four after four cuts

/// What |x| and |y| may be of w without a cut: beyond, pixels would have coordinates without bound.
constexpr double guard = 8.0;

/// The part of a piece with |x| and |y| up to guard·w, which lies in front of the eye.
///
/// Pieces that share an edge share what is left of it, to the bit.
///
/// @param corners  4 before, room for mostClipped
/// @return how many corners are left
/// @source [SutherlandHodgman1974]; [BlinnNewell1978] in homogeneous coordinates
int clipToGuard(Corner* corners);

}  // namespace radlab::engine::raster

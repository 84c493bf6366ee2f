#pragma once

#include "course/ProgRef.h"

namespace radlab::grader {

/// What the point to point formula is made of, for one pair of patches.
struct Pair {
    double distance, cosineFrom, cosineTo;  ///< the cosines as they come, below 0 where turned away
    double areaFrom, areaTo, betweenNormals;
};

/// The pair as its centres have it; the cosines are no numbers where these coincide.
Pair pairOf(const MyPolygon& from, const MyPolygon& to);

/// F(from→to) between two points that stand for the patches.
///
/// @source [CohenWallace1993, chapter 4]
double pointToPoint(const Pair& pair);

}  // namespace radlab::grader

#include "engine/RasterClip.h"

#include <algorithm>

namespace radlab::engine::raster {

namespace {

Corner crossing(const Corner& in, double inside, const Corner& out, double outside) {
    const double t = inside / (inside - outside);
    return {in.x + t * (out.x - in.x), in.y + t * (out.y - in.y), in.w + t * (out.w - in.w)};
}

// Keeps what has a height of 0 or more.
template <class Height>
int cut(Corner* corners, int count, const Height& height) {
    Corner kept[mostClipped + 1];
    int left = 0;
    for (int i = 0; i < count; ++i) {
        const Corner &a = corners[i], &b = corners[(i + 1) % count];
        const double heightA = height(a), heightB = height(b);
        if (heightA >= 0.0) kept[left++] = a;
        // From the inside to the outside, so that both neighbours find the same point.
        if (heightA >= 0.0 && heightB < 0.0) kept[left++] = crossing(a, heightA, b, heightB);
        if (heightA < 0.0 && heightB >= 0.0) kept[left++] = crossing(b, heightB, a, heightA);
        if (left >= mostClipped) break;
    }
    std::copy(kept, kept + left, corners);
    return left;
}

}  // namespace

int clipToGuard(Corner* corners) {
    int count = 4;
    count = cut(corners, count, [](const Corner& c) { return guard * c.w - c.x; });
    count = cut(corners, count, [](const Corner& c) { return guard * c.w + c.x; });
    count = cut(corners, count, [](const Corner& c) { return guard * c.w - c.y; });
    return cut(corners, count, [](const Corner& c) { return guard * c.w + c.y; });
}

}  // namespace radlab::engine::raster

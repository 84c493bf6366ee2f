// Extension 2, solved: an anti-aliased display.

#include "Extensions.h"

// Over pixel (x, y), at the centres of its small squares.
static Vec3f meanRadiance(const PictureView& view, int x, int y, int samples) {
    const float edge = 1.0f / samples;  // of a small square
    Vec3f sum(0.0f);
    for (int j = 0; j < samples; ++j)
        for (int i = 0; i < samples; ++i) sum += view.radiance(x + (i + 0.5f) * edge, y + (j + 0.5f) * edge);
    return sum * edge * edge;
}

void antialias(const PictureView& view, int samples, radlab::Image& picture) {
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x) picture.at(x, y) = view.display(meanRadiance(view, x, y, samples));
}

#include "engine/Hemicubes.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <string>

#ifdef __SSE2__
#include <immintrin.h>
#endif

#include "base/Error.h"
#include "base/Interrupts.h"
#include "course/FacePolygon.h"

namespace radlab::engine {

namespace {

double topDensity(double x, double y) { return 1.0 / std::pow(x * x + y * y + 1.0, 2); }

double sideDensity(double x, double y) { return y / std::pow(x * x + y * y + 1.0, 2); }

int checkedSize(int size) {
    if (size < Hemicubes::smallestSize || size > Hemicubes::largestSize || size % 2 != 0)
        throw Error("hemicube size: found " + std::to_string(size) + ", expected an even number from " +
                    std::to_string(Hemicubes::smallestSize) + " to " + std::to_string(Hemicubes::largestSize));
    return size;
}

Point firstEdge(const Polygon& patch) {
    Point along = patch.corners[1] - patch.corners[0];
    along -= glm::dot(along, patch.normal) * patch.normal;
    if (!(glm::length(along) > planeTolerance * patch.radius))
        along = glm::cross(patch.normal, axisAcross(patch.normal));
    return glm::normalize(along);
}

// The top face, and the upper halves of the four faces around it.
std::array<RasterView, 5> viewsFrom(const Polygon& patch, int size) {
    const Point &eye = patch.center, &up = patch.normal, x = firstEdge(patch), y = glm::cross(up, x);
    return {{{eye, x, y, up, -1.0, size},
             {eye, y, up, x, 0.0, size},
             {eye, -y, up, -x, 0.0, size},
             {eye, -x, up, y, 0.0, size},
             {eye, x, up, -y, 0.0, size}}};
}

// Which of eight pixels show another patch than the one to their left, a bit for each.
unsigned startsIn(const PatchImage::Group& pixels, std::uint32_t left) {
    const std::uint32_t* patch = pixels.patch;
    unsigned starts = patch[0] != left;
#ifdef __SSE2__
    const auto same = [&](int k) {
        const __m128i now = _mm_loadu_si128(reinterpret_cast<const __m128i*>(patch + k)),
                      before = _mm_loadu_si128(reinterpret_cast<const __m128i*>(patch + k - 1));
        return static_cast<unsigned>(_mm_movemask_ps(_mm_castsi128_ps(_mm_cmpeq_epi32(now, before)))) << k;
    };
    return starts | (0xfeu & ~(same(1) | same(4)));
#else
    for (int k = 1; k < PatchImage::Group::size; ++k) starts |= unsigned{patch[k] != patch[k - 1]} << k;
    return starts;
#endif
}

}  // namespace

Hemicubes::Deltas::Deltas(int size, double (*density)(double x, double y))
    : stride(static_cast<std::size_t>(size) + 1) {
    for (int y = 0; y < size / 2; ++y) {
        double left = 0.0;
        upTo.push_back(left);
        for (int x = 0; x < size; ++x)
            upTo.push_back(left += density((2 * x + 1.0) / size - 1.0, (2 * y + 1.0) / size));
        sum += left;
    }
}

Hemicubes::Hemicubes(const std::vector<Polygon>& list, int wanted, Simd simd)
    : patches(list),
      size(checkedSize(wanted)),
      raster(list, simd),
      top(size, topDensity),
      side(size, sideDensity),
      scale(1.0 / (2.0 * top.sum + 4.0 * side.sum)) {}

// Pixel by pixel would add to one number again and again, each time after the last: a run of pixels is added at once.
void Hemicubes::add(const PatchImage& image, bool isTop, double* factors) const {
    constexpr int group = PatchImage::Group::size;
    for (int y = 0; y < image.height(); ++y) {
        const PatchImage::Group* row = image.row(y);
        const double* upTo = isTop ? top.row(y < size / 2 ? size / 2 - 1 - y : y - size / 2) : side.row(y);
        std::uint32_t patch = row[0].patch[0];
        int from = 0;
        const auto close = [&](int end) {
            if (patch != PatchImage::nothing) factors[patch] += upTo[end] - upTo[from];
            from = end;
        };
        for (int x = 0; x < size; x += group, ++row) {
            for (unsigned starts = startsIn(*row, patch); starts != 0; starts &= starts - 1) {
                const int k = std::countr_zero(starts);
                if (x + k >= size) break;
                close(x + k);
                patch = row->patch[k];
            }
        }
        close(size);
    }
}

void Hemicubes::row(std::size_t shooter, double* factors) const {
    std::fill(factors, factors + patches.size(), 0.0);
    const Polygon& patch = patches[shooter];
    if (!(patch.area > 0.0)) return;
    PatchImage& image = images.local();
    for (const RasterView& view : viewsFrom(patch, size)) {
        Interrupts::check();
        raster.draw(view, static_cast<std::uint32_t>(shooter), image);
        add(image, view.bottom < 0.0, factors);
    }
    for (std::size_t j = 0; j < patches.size(); ++j)
        if (factors[j] > 0.0)
            factors[j] *= heightOver(patch.center, patches[j].center, patches[j].normal) > 0.0 ? scale : 0.0;
}

}  // namespace radlab::engine

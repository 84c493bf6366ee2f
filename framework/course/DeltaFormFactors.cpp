#include "course/DeltaFormFactors.h"

#include <cmath>
#include <cstddef>

namespace radlab {

namespace {

constexpr double pi = 3.14159265358979323846;

// The weight at (u, v), both -2 to 2 from the middle of the buffer, of a pixel of area 1 of the half edge squared.
double weight(double u, double v) {
    const double across = std::fmax(std::fabs(u), std::fabs(v)), along = std::fmin(std::fabs(u), std::fabs(v));
    if (along > 1.0) return 0.0;
    if (across <= 1.0) return 1.0 / (pi * std::pow(u * u + v * v + 1.0, 2));
    const double height = 2.0 - across;
    return height / (pi * std::pow(along * along + height * height + 1.0, 2));
}

}  // namespace

std::vector<float> deltaFormFactors(int size) {
    const int edge = 2 * size;
    const auto centre = [size](int pixel) { return (2 * pixel + 1 - 2 * size) / static_cast<double>(size); };
    double sum = 0.0;
    for (int y = 0; y < edge; ++y)
        for (int x = 0; x < edge; ++x) sum += weight(centre(x), centre(y));
    std::vector<float> deltas;
    deltas.reserve(static_cast<std::size_t>(edge) * static_cast<std::size_t>(edge));
    for (int y = 0; y < edge; ++y)
        for (int x = 0; x < edge; ++x) deltas.push_back(static_cast<float>(weight(centre(x), centre(y)) / sum));
    return deltas;
}

}  // namespace radlab

#include "base/Image.h"

#include <algorithm>
#include <cmath>

#include "base/Error.h"

namespace radlab {

Image::Image(int width, int height, const glm::vec3& fill) : columns(width), rows(height) {
    RADLAB_CHECK(width > 0);
    RADLAB_CHECK(height > 0);
    pixels.assign(static_cast<std::size_t>(width) * height, fill);
}

void Image::paste(const Image& other, int x, int y) {
    const int left = std::max(x, 0), right = std::min(x + other.columns, columns);
    for (int row = std::max(y, 0); row < std::min(y + other.rows, rows); ++row)
        for (int column = left; column < right; ++column) at(column, row) = other.at(column - x, row - y);
}

Image Image::shrunk(int factor) const {
    RADLAB_CHECK(columns % factor == 0);
    RADLAB_CHECK(rows % factor == 0);
    Image small(columns / factor, rows / factor);
    const float share = 1.0f / static_cast<float>(factor * factor);
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < columns; ++x) small.at(x / factor, y / factor) += share * at(x, y);
    return small;
}

double rmsDifference(const Image& a, const Image& b) {
    RADLAB_CHECK(a.width() == b.width());
    RADLAB_CHECK(a.height() == b.height());
    RADLAB_CHECK(!a.empty());
    double sum = 0.0;
    for (std::size_t i = 0; i < a.data().size(); ++i) {
        const glm::dvec3 difference = glm::dvec3(a.data()[i]) - glm::dvec3(b.data()[i]);
        sum += difference.x * difference.x + difference.y * difference.y + difference.z * difference.z;
    }
    return std::sqrt(sum / (3.0 * static_cast<double>(a.data().size())));
}

}  // namespace radlab

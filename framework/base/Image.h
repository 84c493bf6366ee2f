#pragma once

#include <vector>

#include <glm/vec3.hpp>

namespace radlab {

/// A picture of RGB floats; row 0 is the top row.
///
/// What the numbers mean is the maker's: linear radiance out of a renderer, 0 to 1 ready for display
/// out of a tone mapping.
class Image {
public:
    Image() = default;
    Image(int width, int height, const glm::vec3& fill = glm::vec3(0.0f));

    int width() const { return columns; }
    int height() const { return rows; }
    bool empty() const { return pixels.empty(); }

    glm::vec3& at(int x, int y) { return pixels[index(x, y)]; }
    const glm::vec3& at(int x, int y) const { return pixels[index(x, y)]; }

    /// All pixels, row by row from the top.
    std::vector<glm::vec3>& data() { return pixels; }
    const std::vector<glm::vec3>& data() const { return pixels; }

    /// Copies other so that its top left pixel lies at (x, y); what sticks out is cut off.
    void paste(const Image& other, int x, int y);

    /// The mean of each factor x factor block of pixels.
    ///
    /// @pre factor divides width and height
    Image shrunk(int factor) const;

private:
    std::size_t index(int x, int y) const { return static_cast<std::size_t>(y) * columns + x; }

    int columns = 0;
    int rows = 0;
    std::vector<glm::vec3> pixels;
};

/// Root mean square difference over all pixels and channels.
///
/// @pre both have the same size, which is not 0
double rmsDifference(const Image& a, const Image& b);

}  // namespace radlab

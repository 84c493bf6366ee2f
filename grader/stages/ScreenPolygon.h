#pragma once

#include <array>
#include <cstddef>

#include <glm/glm.hpp>

namespace radlab::grader {

/// A view of the world and the rectangle of the buffer that shows it.
struct IdView {
    glm::dmat4 clipFromWorld{1.0};  ///< projection times view, as OpenGL's two matrices make it
    int x = 0, y = 0;               ///< the viewport's lower left corner in the buffer, in pixels
    int width = 0, height = 0;      ///< the viewport's size in pixels
};

/// A corner in clip coordinates, with how far an OpenGL that computes in floats may be off.
struct ClipCorner {
    glm::dvec4 position;
    glm::dvec4 error;  ///< bound for each coordinate
};

/// The corner of a polygon as a view sees it.
///
/// @cost 32 multiplications
ClipCorner clipCorner(const glm::dvec3& world, const glm::dmat4& clipFromWorld);

/// A polygon in clip coordinates, cut to what a view can show.
class ClipPolygon {
public:
    void add(const ClipCorner& corner) { corners[count++] = corner; }

    /// Cuts away what lies before the near plane and far beside the viewport.
    ///
    /// Both are left a rim, so that no edge made by cutting comes near a pixel that can be drawn: OpenGL's own cut at
    /// the near plane is judged pixel by pixel, from the depth.
    ///
    /// @return false where nothing is left
    bool cut();

    std::size_t size() const { return count; }
    const ClipCorner& operator[](std::size_t i) const { return corners[i]; }

private:
    // A quadrilateral that is not convex can gain half its corners at each of five planes: 4·1.5⁵ < 32.
    static constexpr std::size_t capacity = 32;

    std::array<ClipCorner, capacity> corners;
    std::size_t count = 0;
};

/// What is known of a polygon at one pixel.
struct Coverage {
    bool touched = false;          ///< an OpenGL may draw the pixel
    bool inside = false;           ///< the pixel's centre is inside, exactly computed
    bool certain = false;          ///< every OpenGL draws the pixel
    double depth = 0.0;            ///< window depth at the pixel's centre, 0 near to 1 far
    double low = 0.0, high = 0.0;  ///< between which an OpenGL's depth lies
};

/// A convex polygon in window coordinates, ready to be asked about pixels.
///
/// OpenGL moves corners to a grid before it draws: of 1/16 pixel with 4 bits of subpixel precision, the fewest that its
/// specification allows, of 1/256 with the 8 bits of Mesa's llvmpipe. So an edge moves by up to half a step along x and
/// y. A pixel that is nearer than that to an edge is touched, but neither certain nor surely missed. To this is added
/// what floats may do to the corner itself, and to depth: rounding, interpolation and the 24 bits of the buffer.
class ScreenPolygon {
public:
    enum class Facing { front, back, unclear };  ///< front: counter-clockwise on screen; unclear: nearly edge-on

    /// @param subpixelBits  GL_SUBPIXEL_BITS: how finely corners are placed
    ScreenPolygon(const ClipPolygon& polygon, const IdView& view, int subpixelBits);

    /// Whether no pixel can be touched; nothing else may be asked then.
    bool empty() const { return last.x < first.x || last.y < first.y; }

    /// Whether the corners turn one way only, so that coverage() holds. Triangles do, however rounding bends them.
    bool convex() const;

    Facing facing() const;

    /// What is known at the pixel with its centre at (x, y) in window coordinates.
    ///
    /// @pre convex, and the pixel is in the box
    Coverage coverage(double x, double y) const;

    /// The pixels that can be touched: first to last, both included.
    glm::ivec2 first{0}, last{-1};

    /// The pixels of a row among them, from x to y, both included, and perhaps one more on either side.
    ///
    /// @pre convex, and the row is in the box
    glm::ivec2 row(int y) const;

private:
    struct Edge {
        double a, b, c;  // a·x + b·y + c is the distance inside, in pixels, where |a| + |b| = 1
    };
    static constexpr std::size_t capacity = 32;

    void readCorners(const ClipPolygon& polygon, const IdView& view, int subpixelBits);
    void findBox(const IdView& view);
    void findEdges();
    void findDepth();

    std::array<glm::dvec3, capacity> corners;
    std::array<Edge, capacity> edges;
    std::size_t count = 0, edgeCount = 0;
    double doubledArea = 0.0;  // > 0 for counter-clockwise
    double margin = 0.0;       // how far edges may be off, in pixels
    double cornerDepthError = 0.0;
    glm::dvec3 low, high;   // of the corners
    glm::dvec3 middle;      // a point of the depth's plane
    glm::dvec2 slope{0.0};  // depth per pixel
    double depthError = 0.0;
};

}  // namespace radlab::grader

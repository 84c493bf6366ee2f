#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "gl/OpenGL.h"

namespace radlab {

/// The patches of `polygons` as vertex arrays, for pictures that are drawn again and again.
///
/// Each patch is a fan round its middle, so that a quadrilateral that is shaded smoothly shows no diagonal. Colours are ready for
/// display and arrive as they are; the caller sets state and camera. The arrays hold what `polygons` was when they were made.
///
/// @pre for the draw… functions: a GlContext is current
class PatchArrays {
public:
    PatchArrays();

    std::size_t patchCount() const { return firstCorner.size(); }

    /// One colour a patch, 0 to 1.
    ///
    /// @pre as many colours as patches
    void setColors(const std::vector<glm::vec3>& ofPatches);

    /// Colours from corner to corner.
    ///
    /// @pre as many colours as `vertices`, and as patches
    void setColors(const std::vector<glm::vec3>& ofVertices, const std::vector<glm::vec3>& ofMiddles);

    /// Every patch in the colour that is its ID: index plus 1, red the high byte.
    void setIdColors();

    /// @cost one call of OpenGL
    void draw() const;

    /// All outlines in the current colour.
    void drawOutlines() const;

    /// One patch's outline in the current colour.
    void drawOutline(std::size_t patch) const;

private:
    struct Point {
        glm::vec3 position;
        std::uint8_t color[4];
    };
    void addPatch(std::size_t patch);
    void paint(Point& point, const glm::vec3& color);
    void paintPatch(std::size_t patch, const glm::vec3& color);
    void bindPositions() const;

    std::vector<Point> points;             // of each patch: its middle, then its corners
    std::vector<GLuint> triangles, lines;  // indices of points
    std::vector<std::size_t> firstCorner;  // of each patch, the index of its first corner in points
    std::vector<int> vertexOf;             // of each point the index in `vertices`; -1 for middles
};

}  // namespace radlab

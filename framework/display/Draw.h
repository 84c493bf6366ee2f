#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "base/Image.h"
#include "course/DataFormat.h"
#include "scene/Scene.h"

namespace radlab {

/// The frame of a picture: from where, how large, how smooth.
struct View {
    Camera camera;
    int width = 800;
    int height = 800;
    int samples = 2;                         ///< per pixel along each edge, 1 or more
    glm::vec3 background = glm::vec3(0.0f);  ///< linear RGB
};

/// Sets the matrices to a view of `polygons`, for a viewport of the view's shape.
///
/// @pre a GlContext is current
void setCamera(const View& view);

/// The colour of an unlit patch: its reflectance, lifted so that black ones show; pale yellow where it emits. Linear RGB.
glm::vec3 unlitColor(const MyPolygon& patch);

/// How colours are spread over patches.
enum class Shading {
    flat,    ///< one colour a patch
    smooth,  ///< Gouraud: from vertex to vertex [Gouraud1971]
};

/// Draws the radiance that colorReconstruction left in `polygons` (flat) or `vertices` (smooth).
///
/// Fronts only: a patch is not seen from its back.
///
/// @pre    a GlContext is current
/// @return linear radiance, width x height
/// @cost   one drawing of all patches at samples² times the pixels
Image drawRadiance(const View& view, Shading shading);

/// Draws every patch in a colour of its own, unlit.
///
/// @param color what patch i shows, linear RGB
/// @pre as drawRadiance
Image drawColors(const View& view, const std::function<glm::vec3(std::size_t i)>& color);

/// Draws patch IDs with the given function and reads them back: what it drew, 0 where there is background.
///
/// @param draw what the course calls renderPatchIDs; whatever it does to the OpenGL state is undone
/// @pre as drawRadiance
/// @return width·samples x height·samples IDs, row by row from the bottom
/// Errors: draw leaving a glBegin open.
std::vector<std::uint32_t> readIds(const View& view, const std::function<void()>& draw);

/// Draws patch IDs with the given function and shows every ID that comes back in its false colour.
///
/// @param draw what the course calls renderPatchIDs
/// @pre as drawRadiance
/// @return ready for display
Image drawIds(const View& view, const std::function<void()>& draw);

/// Draws the outlines of the patches over their reflectance, hidden lines removed, ready for display.
///
/// @pre as drawRadiance
Image drawWireframe(const View& view);

}  // namespace radlab

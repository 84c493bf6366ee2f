#pragma once

#include <functional>

#include "base/Image.h"
#include "grader/protocol/State.h"
#include "scene/Scene.h"

namespace radlab::grader {

/// Edge of the judge's pictures, in pixels.
constexpr int pictureSize = 320;

/// Draws every patch in one colour, without OpenGL; fronts only.
///
/// @param color of patch i, linear RGB or ready for display: the picture is the mean of 2 x 2 samples a pixel
/// @return pictureSize squared, black where no patch is seen
Image drawFlat(const State& state, const Camera& camera, const std::function<glm::vec3(std::size_t i)>& color);

/// Draws every patch with its corners' colours spread over it, a quadrilateral as two triangles.
///
/// @param color of corner k of the state
/// @source [Gouraud1971]
Image drawSmooth(const State& state, const Camera& camera, const std::function<glm::vec3(std::size_t k)>& color);

/// The view of a camera for a square picture: clip coordinates from world coordinates.
glm::dmat4 clipFromWorld(const State& state, const Camera& camera);

}  // namespace radlab::grader

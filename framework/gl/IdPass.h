#pragma once

namespace radlab {

/// Sets the OpenGL state in which a colour that is set arrives in the framebuffer unchanged.
///
/// Off: dither, blending, multisampling, lighting, fog, textures, smoothing, alpha and stencil tests, logic
/// operations, stipple, clip planes, culling, polygon offset, programs. On: depth test, all masks, filled polygons,
/// flat shading. The viewport, scissor and matrices are the caller's.
///
/// @pre a GlContext is current; keep a SavedState to put things back
void setIdPassState();

}  // namespace radlab

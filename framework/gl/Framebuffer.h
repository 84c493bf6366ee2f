#pragma once

#include "gl/OpenGL.h"

namespace radlab {

/// A framebuffer object of its own size, with one sample a pixel and a depth buffer of 24 bits.
///
/// @pre a GlContext is current, the same one for all calls
class Framebuffer {
public:
    enum class Color { bytes, floats };  ///< 8 bits or a float for each of red, green, blue and alpha

    /// Errors: larger than the context allows.
    Framebuffer(int width, int height, Color color);
    ~Framebuffer();
    Framebuffer(const Framebuffer&) = delete;
    Framebuffer& operator=(const Framebuffer&) = delete;

    /// Draws and reads here from now on.
    void bind() const;

    int width() const { return columns; }
    int height() const { return rows; }

private:
    int columns, rows;
    GLuint framebuffer = 0;
    GLuint color = 0;
    GLuint depth = 0;
};

}  // namespace radlab

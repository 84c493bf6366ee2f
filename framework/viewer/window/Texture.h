#pragma once

#include "base/Image.h"
#include "gl/OpenGL.h"

namespace radlab {

/// A picture that ImGui can show.
///
/// @pre a GlContext is current, the same one for all calls
class Texture {
public:
    Texture() = default;
    ~Texture();
    Texture(const Texture&) = delete;
    Texture& operator=(const Texture&) = delete;

    /// Takes another picture, ready for display.
    void show(const Image& image);

    /// Its name in OpenGL; 0 before the first picture.
    GLuint id() const { return name; }

private:
    GLuint name = 0;
};

}  // namespace radlab

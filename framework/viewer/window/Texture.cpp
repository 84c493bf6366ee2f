#include "viewer/window/Texture.h"

#include "base/ImageFile.h"
#include "gl/SavedState.h"

namespace radlab {

Texture::~Texture() {
    if (name) glDeleteTextures(1, &name);
}

void Texture::show(const Image& image) {
    const SavedState saved;
    if (!name) glGenTextures(1, &name);
    glBindTexture(GL_TEXTURE_2D, name);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
    const std::string bytes = rgbBytes(image);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, image.width(), image.height(), 0, GL_RGB, GL_UNSIGNED_BYTE, bytes.data());
}

}  // namespace radlab

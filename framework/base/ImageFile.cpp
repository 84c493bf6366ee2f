#include "base/ImageFile.h"

#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include <glm/common.hpp>

#include "base/Error.h"
#include "base/WholeFile.h"

#ifdef RADLAB_HAVE_STB
#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#endif
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#define STBI_ONLY_HDR
#include <stb_image.h>
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#include <stb_image_write.h>
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif
#endif

namespace radlab {

namespace {

const glm::vec3 magenta(1.0f, 0.0f, 1.0f);

bool finite(const glm::vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

}  // namespace

bool isImageFile(const std::filesystem::path& file) { return file.extension() == ".png" || file.extension() == ".hdr"; }

std::string rgbBytes(const Image& image) {
    std::string bytes(image.data().size() * 3, '\0');
    std::size_t next = 0;
    for (const glm::vec3& pixel : image.data()) {
        const glm::vec3 shown = glm::clamp(finite(pixel) ? pixel : magenta, 0.0f, 1.0f) * 255.0f + 0.5f;
        for (int c = 0; c < 3; ++c) bytes[next++] = static_cast<char>(static_cast<int>(shown[c]));
    }
    return bytes;
}

#ifdef RADLAB_HAVE_STB

namespace {

constexpr float brightestHdr = 1.6e38f;  // above 2^127 stb's exponent byte runs over

void append(void* context, void* data, int size) {
    static_cast<std::string*>(context)->append(static_cast<const char*>(data), static_cast<std::size_t>(size));
}

// What the shared exponent can hold: magenta for what is not finite, nothing negative.
glm::vec3 storable(const glm::vec3& pixel) {
    const glm::vec3 shown = finite(pixel) ? pixel : magenta;
    return glm::min(glm::max(shown, glm::vec3(0.0f)), glm::vec3(brightestHdr));
}

std::string encodeHdr(const Image& image) {
    std::vector<glm::vec3> pixels;
    pixels.reserve(image.data().size());
    for (const glm::vec3& pixel : image.data()) pixels.push_back(storable(pixel));
    std::string encoded;
    stbi_write_hdr_to_func(append, &encoded, image.width(), image.height(), 3, &pixels[0].x);
    return encoded;
}

Image decodePng(const unsigned char* bytes, int size, const std::string& name) {
    int width = 0, height = 0, channels = 0;
    if (stbi_is_hdr_from_memory(bytes, size))  // stb would take it, and make other colours of it
        throw Error({name}, "not a whole PNG picture: it is a Radiance HDR");
    const std::unique_ptr<stbi_uc, void (*)(void*)> pixels(
        stbi_load_from_memory(bytes, size, &width, &height, &channels, 3), stbi_image_free);
    if (!pixels) throw Error({name}, std::string("not a whole PNG picture: ") + stbi_failure_reason());
    Image image(width, height);
    for (std::size_t i = 0; i < image.data().size(); ++i)
        for (int c = 0; c < 3; ++c) image.data()[i][c] = static_cast<float>(pixels.get()[3 * i + c]) / 255.0f;
    return image;
}

// Steps over one run-length encoded channel of a line; false where it ends early or does not fit the width.
bool skipChannel(const unsigned char*& at, const unsigned char* end, int width) {
    for (int x = 0; x < width;) {
        if (at >= end || *at == 0) return false;
        const int count = *at > 128 ? *at - 128 : *at;
        at += *at > 128 ? 2 : 1 + count;
        x += count;
        if (x > width) return false;
    }
    return at <= end;
}

// Whether all lines of an HDR are there. stb takes what is cut off for zeros, or waits for more forever.
bool holdsAllLines(const unsigned char* at, const unsigned char* end, int width, int height) {
    for (int y = 0; y < height; ++y) {
        const bool encoded =
            width >= 8 && width < 32768 && end - at >= 4 && at[0] == 2 && at[1] == 2 && (at[2] & 0x80) == 0;
        if (!encoded) return y == 0 && end - at >= std::int64_t{4} * width * height;
        at += 4;
        for (int channel = 0; channel < 4; ++channel)
            if (!skipChannel(at, end, width)) return false;
    }
    return true;
}

bool isWholeHdr(const unsigned char* bytes, int size) {
    int width = 0, height = 0, channels = 0;
    if (!stbi_is_hdr_from_memory(bytes, size) || !stbi_info_from_memory(bytes, size, &width, &height, &channels))
        return false;
    const std::string_view text(reinterpret_cast<const char*>(bytes), static_cast<std::size_t>(size));
    const std::size_t blank = text.find("\n\n");
    const std::size_t start = blank == text.npos ? text.npos : text.find('\n', blank + 2);
    return start != text.npos && holdsAllLines(bytes + start + 1, bytes + size, width, height);
}

Image decodeHdr(const unsigned char* bytes, int size, const std::string& name) {
    int width = 0, height = 0, channels = 0;
    const std::unique_ptr<float, void (*)(void*)> pixels(
        isWholeHdr(bytes, size) ? stbi_loadf_from_memory(bytes, size, &width, &height, &channels, 3) : nullptr,
        stbi_image_free);
    if (!pixels) throw Error({name}, "not a whole Radiance HDR picture");
    Image image(width, height);
    for (std::size_t i = 0; i < image.data().size(); ++i)
        for (int c = 0; c < 3; ++c) image.data()[i][c] = pixels.get()[3 * i + c];
    return image;
}

void requireImageFile(const std::filesystem::path& file) {
    if (!isImageFile(file))
        throw Error({file.string()}, "unknown kind of picture: found the ending '" + file.extension().string() +
                                         "', expected .png or .hdr");
}

}  // namespace

std::string pngBytes(const Image& image) {
    RADLAB_CHECK(!image.empty());
    std::string encoded;
    stbi_write_png_to_func(append, &encoded, image.width(), image.height(), 3, rgbBytes(image).data(),
                           3 * image.width());
    return encoded;
}

void writeImage(const std::filesystem::path& file, const Image& image) {
    RADLAB_CHECK(!image.empty());
    requireImageFile(file);
    writeFile(file, file.extension() == ".png" ? pngBytes(image) : encodeHdr(image));
}

Image readImage(const std::filesystem::path& file) {
    requireImageFile(file);
    const bool png = file.extension() == ".png";
    const std::string bytes = readFile(file);
    const auto* data = reinterpret_cast<const unsigned char*>(bytes.data());
    const int size = static_cast<int>(bytes.size());
    return png ? decodePng(data, size, file.string()) : decodeHdr(data, size, file.string());
}

#else

std::string pngBytes(const Image&) {
    throw Error("this build has no stb, so it cannot make PNG pictures: install stb and build again");
}

void writeImage(const std::filesystem::path& file, const Image&) {
    throw Error({file.string()}, "this build has no stb, so it cannot write pictures: install stb and build again");
}

Image readImage(const std::filesystem::path& file) {
    throw Error({file.string()}, "this build has no stb, so it cannot read pictures: install stb and build again");
}

#endif

}  // namespace radlab

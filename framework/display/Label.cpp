#include "display/Label.h"

#include <algorithm>
#include <cmath>

#include "base/Error.h"

#ifdef RADLAB_HAVE_STB
#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wmisleading-indentation"
#endif
#include <stb_easy_font.h>
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif
#endif

namespace radlab {

#ifdef RADLAB_HAVE_STB

namespace {

struct FontVertex {
    float x, y, z;
    unsigned char color[4];
};

void fill(Image& image, int left, int top, int right, int bottom, const glm::vec3& color) {
    for (int y = std::max(top, 0); y < std::min(bottom, image.height()); ++y)
        for (int x = std::max(left, 0); x < std::min(right, image.width()); ++x) image.at(x, y) = color;
}

}  // namespace

void writeText(Image& image, int x, int y, const std::string& text, int scale, const glm::vec3& color) {
    std::vector<FontVertex> corners(std::size_t{4} * 32 * (text.size() + 1));
    std::string line = text;
    const int quads = stb_easy_font_print(0, 0, line.data(), nullptr, corners.data(),
                                          static_cast<int>(corners.size() * sizeof(FontVertex)));
    const auto pixel = [scale](float v) { return static_cast<int>(std::lround(v)) * scale; };
    for (int i = 0; i < quads; ++i) {
        const FontVertex &first = corners[4 * static_cast<std::size_t>(i)],
                         &last = corners[4 * static_cast<std::size_t>(i) + 2];
        fill(image, x + pixel(first.x), y + pixel(first.y), x + pixel(last.x), y + pixel(last.y), color);
    }
}

int textWidth(const std::string& text, int scale) {
    std::string line = text;
    return stb_easy_font_width(line.data()) * scale;
}

#else

void writeText(Image&, int, int, const std::string&, int, const glm::vec3&) {}
int textWidth(const std::string&, int) { return 0; }

#endif

Image contactSheet(const std::vector<Image>& pictures, const std::vector<std::string>& titles, int columns) {
    RADLAB_CHECK(pictures.size() == titles.size());
    RADLAB_CHECK(!pictures.empty());
    constexpr int gap = 16, titleHeight = 32, textScale = 2;
    const int width = pictures[0].width() + gap, height = pictures[0].height() + gap + titleHeight;
    const int rows = (static_cast<int>(pictures.size()) + columns - 1) / columns;
    Image sheet(columns * width + gap, rows * height + gap, glm::vec3(0.11f, 0.12f, 0.14f));
    for (int i = 0; i < static_cast<int>(pictures.size()); ++i) {
        const Image& picture = pictures[static_cast<std::size_t>(i)];
        RADLAB_CHECK(picture.width() == pictures[0].width());
        RADLAB_CHECK(picture.height() == pictures[0].height());
        const int x = gap + i % columns * width, y = gap + i / columns * height;
        writeText(sheet, x, y + 4, titles[static_cast<std::size_t>(i)], textScale, glm::vec3(0.92f));
        sheet.paste(picture, x, y + titleHeight);
    }
    return sheet;
}

}  // namespace radlab

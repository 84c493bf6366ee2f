#include "base/ImageFile.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include <doctest/doctest.h>

#include "base/Error.h"
#include "base/TestFolder.h"
#include "base/WholeFile.h"

using namespace radlab;
using radlab::test::Folder;

namespace {

#ifdef RADLAB_HAVE_STB
constexpr bool canHoldPictures = true;
#else
constexpr bool canHoldPictures = false;
#endif

const glm::vec3 magenta(1.0f, 0.0f, 1.0f);
const float notANumber = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();

Image roundTrip(const Image& image, const std::string& ending) {
    const Folder folder;
    writeImage(folder / ("picture" + ending), image);
    CHECK(folder.entries() == 1);
    return readImage(folder / ("picture" + ending));
}

// Radiances over six orders of magnitude, with colours.
Image radiances(int width, int height) {
    std::mt19937 random(width);
    std::uniform_real_distribution<float> exponent(-2.0f, 4.0f), share(0.0f, 1.0f);
    Image image(width, height);
    for (glm::vec3& pixel : image.data())
        pixel = std::pow(10.0f, exponent(random)) * glm::vec3(share(random), share(random), share(random));
    return image;
}

std::string readError(const std::filesystem::path& file) {
    try {
        readImage(file);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST_SUITE_BEGIN("image files" * doctest::skip(!canHoldPictures));

TEST_CASE("a PNG keeps every number of its 8-bit grid exactly") {
    Image image(256, 3);
    for (int x = 0; x < 256; ++x)
        for (int y = 0; y < 3; ++y) image.at(x, y)[y] = static_cast<float>(x) / 255.0f;
    const Image back = roundTrip(image, ".png");
    CHECK(back.width() == 256);
    CHECK(back.height() == 3);
    CHECK(back.data() == image.data());
}

TEST_CASE("a PNG rounds to the nearest step of its grid") {
    const Image back = roundTrip(Image(1, 1, glm::vec3(100.4f, 100.6f, 254.9f) / 255.0f), ".png");
    CHECK(back.at(0, 0) == glm::vec3(100.0f / 255.0f, 101.0f / 255.0f, 1.0f));
}

TEST_CASE("a PNG clamps what is darker than black or brighter than white") {
    const Image back = roundTrip(Image(2, 2, glm::vec3(-3.0f, 0.0f, 1e30f)), ".png");
    for (const glm::vec3& pixel : back.data()) CHECK(pixel == glm::vec3(0, 0, 1));
}

TEST_CASE("in a PNG a number that is not finite is seen: magenta") {
    Image image(4, 1, glm::vec3(0.0f));
    image.at(0, 0) = glm::vec3(notANumber, 0.5f, 0.5f);
    image.at(1, 0) = glm::vec3(0.5f, infinity, 0.5f);
    image.at(2, 0) = glm::vec3(0.5f, 0.5f, -infinity);
    const Image back = roundTrip(image, ".png");
    for (int x = 0; x < 3; ++x) CHECK(back.at(x, 0) == magenta);
    CHECK(back.at(3, 0) == glm::vec3(0.0f));
}

TEST_CASE("a PNG in memory is the one of a file, and holds the bytes of its pixels") {
    Image image(2, 1, glm::vec3(1.0f, 0.5f, -1.0f));
    image.at(1, 0) = glm::vec3(notANumber);
    CHECK(rgbBytes(image) == std::string("\xff\x80\x00\xff\x00\xff", 6));
    const Folder folder;
    writeImage(folder / "image.png", image);
    CHECK(pngBytes(image) == readFile(folder / "image.png"));
    CHECK_THROWS_AS(pngBytes(Image()), std::logic_error);
}

TEST_CASE("an HDR keeps radiances over six orders of magnitude to 1 % of their pixel's brightest channel") {
    for (const int width : {3, 7, 8, 40, 300}) {  // below 8 pixels lines are stored otherwise
        CAPTURE(width);
        const Image image = radiances(width, 9);
        const Image back = roundTrip(image, ".hdr");
        REQUIRE(back.width() == width);
        REQUIRE(back.height() == 9);
        float worst = 0.0f, brightest = 0.0f;
        for (std::size_t i = 0; i < image.data().size(); ++i)
            for (int c = 0; c < 3; ++c) {
                const glm::vec3& pixel = image.data()[i];
                const float most = std::max({pixel.r, pixel.g, pixel.b});
                worst = std::max(worst, std::abs(back.data()[i][c] - pixel[c]) / most);
                brightest = std::max(brightest, back.data()[i][c]);
            }
        CHECK(worst < 0.01f);
        CHECK(brightest > 100.0f);
    }
}

TEST_CASE("an HDR keeps black black") {
    const Image back = roundTrip(Image(9, 2), ".hdr");
    for (const glm::vec3& pixel : back.data()) CHECK(pixel == glm::vec3(0.0f));
}

TEST_CASE("in an HDR negative light is black, and a number that is not finite is seen: magenta") {
    Image image(4, 1, glm::vec3(1.0f));
    image.at(0, 0) = glm::vec3(-1.0f, 2.0f, -0.001f);
    image.at(1, 0) = glm::vec3(notANumber, 2.0f, 2.0f);
    image.at(2, 0) = glm::vec3(2.0f, 2.0f, infinity);
    image.at(3, 0) = glm::vec3(3e38f, 0.0f, 0.0f);
    const Image back = roundTrip(image, ".hdr");
    CHECK(back.at(0, 0).r == 0.0f);
    CHECK(back.at(0, 0).g == doctest::Approx(2.0).epsilon(0.01));
    CHECK(back.at(0, 0).b == 0.0f);
    for (const int x : {1, 2}) {
        CHECK(back.at(x, 0).r == doctest::Approx(1.0).epsilon(0.01));
        CHECK(back.at(x, 0).g == 0.0f);
        CHECK(back.at(x, 0).b == doctest::Approx(1.0).epsilon(0.01));
    }
    CHECK(back.at(3, 0).r > 1e38f);
}

TEST_CASE("an ending that is neither .png nor .hdr is refused and named, in writing and in reading") {
    const Folder folder;
    for (const std::string name : {"picture.jpg", "picture", "picture.png.txt", ".png"}) {
        CAPTURE(name);
        CHECK_THROWS_WITH_AS(writeImage(folder / name, Image(1, 1)), doctest::Contains("expected .png or .hdr"), Error);
        CHECK(readError(folder / name).find("expected .png or .hdr") != std::string::npos);
    }
    CHECK(folder.entries() == 0);
    CHECK(readError(folder / "picture.jpg").find("found the ending '.jpg'") != std::string::npos);
}

TEST_CASE("a file that is cut off anywhere is an error that names the file, never a picture") {
    const Folder folder;
    for (const std::string ending : {".png", ".hdr"})
        for (const int width : {4, 64}) {
            CAPTURE(ending);
            CAPTURE(width);
            const auto whole = folder / ("whole" + ending), cut = folder / ("cut" + ending);
            writeImage(whole, radiances(width, 33));
            const std::string bytes = readFile(whole);
            for (int eighth = 0; eighth < 8; ++eighth) {
                CAPTURE(eighth);
                writeFile(cut, bytes.substr(0, bytes.size() * eighth / 8));
                CHECK(readError(cut).find(cut.string() + ": not a whole") == 0);
            }
            CHECK(readError(whole).empty());
        }
}

TEST_CASE("an HDR that lacks no more than whole lines, or a byte, is found out") {
    const Folder folder;
    for (const int width : {4, 64}) {
        CAPTURE(width);
        writeImage(folder / "whole.hdr", radiances(width, 16));
        const std::string bytes = readFile(folder / "whole.hdr");
        std::size_t accepted = 0;
        for (std::size_t length = bytes.size() - 400 % bytes.size(); length < bytes.size(); ++length) {
            writeFile(folder / "cut.hdr", bytes.substr(0, length));
            accepted += readError(folder / "cut.hdr").empty();
        }
        CHECK(accepted == 0);
    }
}

TEST_CASE("what is of another kind than its ending says is refused") {
    const Folder folder;
    writeImage(folder / "a.png", Image(9, 9, glm::vec3(0.5f)));
    writeImage(folder / "a.hdr", Image(9, 9, glm::vec3(0.5f)));
    std::filesystem::copy_file(folder / "a.png", folder / "b.hdr");
    std::filesystem::copy_file(folder / "a.hdr", folder / "b.png");
    writeFile(folder / "c.png", "This is no picture.");
    CHECK(readError(folder / "b.hdr").find("not a whole Radiance HDR") != std::string::npos);
    CHECK(readError(folder / "b.png").find("not a whole PNG") != std::string::npos);
    CHECK(readError(folder / "c.png").find("not a whole PNG") != std::string::npos);
    CHECK(readError(folder / "none.png").find("no such file") != std::string::npos);
}

TEST_CASE("a picture that cannot be written leaves nothing behind") {
    const Folder folder;
    CHECK_THROWS_AS(writeImage(folder / "none/picture.png", Image(2, 2)), Error);
    CHECK(folder.entries() == 0);
    std::filesystem::create_directory(folder / "taken.hdr");
    CHECK_THROWS_AS(writeImage(folder / "taken.hdr", Image(2, 2)), Error);
    CHECK(folder.entries() == 1);
}

TEST_CASE("a picture without pixels is never written") {
    const Folder folder;
    CHECK_THROWS_AS(writeImage(folder / "empty.png", Image()), std::logic_error);
    CHECK(folder.entries() == 0);
}

TEST_SUITE_END();

#include "base/Image.h"

#include <cmath>
#include <stdexcept>

#include <doctest/doctest.h>

using namespace radlab;
using doctest::Approx;

namespace {

const glm::vec3 white(1.0f);

// A picture whose pixels all differ.
Image numbered(int width, int height) {
    Image image(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) image.at(x, y) = glm::vec3(x + 1, y + 1, 0.5f);
    return image;
}

}  // namespace

TEST_CASE("a picture begins filled, row 0 on top and rows one after another") {
    Image image(3, 2, glm::vec3(0.25f, 0.5f, 1.0f));
    CHECK(image.width() == 3);
    CHECK(image.height() == 2);
    CHECK(image.data().size() == 6);
    for (const glm::vec3& pixel : image.data()) CHECK(pixel == glm::vec3(0.25f, 0.5f, 1.0f));
    image.at(2, 1) = white;
    CHECK(image.data()[5] == white);
    image.at(1, 0) = white;
    CHECK(image.data()[1] == white);
}

TEST_CASE("a picture without pixels is empty, and none can be made by size") {
    CHECK(Image().empty());
    CHECK_FALSE(Image(1, 1).empty());
    CHECK_THROWS_AS(Image(0, 1), std::logic_error);
    CHECK_THROWS_AS(Image(1, -1), std::logic_error);
}

TEST_CASE("pasting copies every pixel that lies inside and touches no other") {
    const Image stamp = numbered(3, 2);
    for (int left = -5; left <= 6; ++left)
        for (int top = -5; top <= 6; ++top) {
            CAPTURE(left);
            CAPTURE(top);
            Image image(4, 5);
            image.paste(stamp, left, top);
            for (int y = 0; y < 5; ++y)
                for (int x = 0; x < 4; ++x) {
                    const bool covered = x >= left && x < left + 3 && y >= top && y < top + 2;
                    CHECK(image.at(x, y) == (covered ? stamp.at(x - left, y - top) : glm::vec3(0.0f)));
                }
        }
}

TEST_CASE("a larger picture covers the whole, and an empty one nothing") {
    Image image(2, 2);
    image.paste(numbered(5, 5), -2, -1);
    CHECK(image.at(0, 0) == glm::vec3(3, 2, 0.5f));
    CHECK(image.at(1, 1) == glm::vec3(4, 3, 0.5f));
    const Image before = image;
    image.paste(Image(), 0, 0);
    CHECK(rmsDifference(image, before) == 0.0);
}

TEST_CASE("a shrunk picture holds the mean of each block") {
    const Image small = numbered(6, 4).shrunk(2);
    CHECK(small.width() == 3);
    CHECK(small.height() == 2);
    for (int y = 0; y < 2; ++y)
        for (int x = 0; x < 3; ++x) {
            CHECK(small.at(x, y).r == Approx(2 * x + 1.5));
            CHECK(small.at(x, y).g == Approx(2 * y + 1.5));
            CHECK(small.at(x, y).b == Approx(0.5));
        }
}

TEST_CASE("shrinking by 1 changes nothing, and by what does not divide the size is refused") {
    const Image image = numbered(6, 4);
    CHECK(rmsDifference(image.shrunk(1), image) == 0.0);
    CHECK_THROWS_AS(image.shrunk(4), std::logic_error);
    CHECK_THROWS_AS(image.shrunk(3), std::logic_error);
}

TEST_CASE("the difference is the root of the mean square over pixels and channels") {
    const Image black(4, 3);
    Image other(4, 3);
    CHECK(rmsDifference(black, other) == 0.0);
    other.at(3, 2) = glm::vec3(0.0f, 6.0f, 0.0f);
    CHECK(rmsDifference(black, other) == Approx(std::sqrt(36.0 / (4 * 3 * 3))));
    CHECK(rmsDifference(other, black) == rmsDifference(black, other));
    CHECK(rmsDifference(black, Image(4, 3, glm::vec3(0.5f))) == Approx(0.5));
}

TEST_CASE("pictures of different or no size cannot be compared") {
    CHECK_THROWS_AS(rmsDifference(Image(2, 3), Image(3, 2)), std::logic_error);
    CHECK_THROWS_AS(rmsDifference(Image(2, 3), Image(2, 2)), std::logic_error);
    CHECK_THROWS_AS(rmsDifference(Image(), Image()), std::logic_error);
}

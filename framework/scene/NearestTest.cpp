#include "scene/Nearest.h"

#include <array>

#include <doctest/doctest.h>

using namespace radlab;

TEST_CASE("the edit distance counts letters added, dropped and changed") {
    CHECK(editDistance("", "") == 0);
    CHECK(editDistance("", "abc") == 3);
    CHECK(editDistance("kitten", "sitting") == 3);
    CHECK(editDistance("size", "size") == 0);
}

TEST_CASE("a hint names the nearest word, and none where all are far") {
    const std::array<const char*, 2> known = {"hemicube_size", "file_name"};
    CHECK(didYouMean("hemicubesize", known) == ", did you mean 'hemicube_size'?");
    CHECK(didYouMean("Hemicube_Size", known) == ", did you mean 'hemicube_size'?");
    CHECK(didYouMean("filename", known) == ", did you mean 'file_name'?");
    CHECK(didYouMean("colour", known) == "");
    CHECK(didYouMean(std::string(100000, 'x'), known) == "");
}

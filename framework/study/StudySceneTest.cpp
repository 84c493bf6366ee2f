#include "study/StudyScene.h"

#include <doctest/doctest.h>

#include "base/Error.h"
#include "base/Warning.h"

using namespace radlab;
using namespace radlab::study;

TEST_CASE("a scene with mirrors is studied as matt, which is said; one without light is refused") {
    const std::string folder = RADLAB_SOURCE_DIR "/resources/scenes/";
    const WarningCapture warnings;
    CHECK(readStudyScene(folder + "cornell_2.x3d").name == "cornell_2");
    CHECK(warnings.texts.empty());
    CHECK(readStudyScene(folder + "mirror.x3d").name == "mirror");
    REQUIRE(warnings.texts.size() == 1);
    CHECK(warnings.texts[0].find("mirror.x3d: some faces mirror") != std::string::npos);
    CHECK_THROWS_WITH_AS(readStudyScene(folder + "dark.x3d"), doctest::Contains("nothing emits light"), Error);
}

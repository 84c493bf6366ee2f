// The fuzzer's seeds and finds, run as a plain test: none may end in anything but a scene or an Error.

#include <ctime>
#include <filesystem>

#include "scene/Effects.h"
#include "scene/ResourceFile.h"
#include "scene/SceneTestHelp.h"
#include "scene/XmlText.h"

using namespace radlab;
using namespace radlab::test;

TEST_CASE("the fuzzer's corpus ends in scenes or errors, each in little time") {
    const WarningCapture quiet;
    int files = 0, scenes = 0;
    for (const auto& entry :
         std::filesystem::directory_iterator(std::filesystem::path(RADLAB_SOURCE_DIR) / "resources" / "fuzz" / "x3d")) {
        const std::string name = pathText(entry.path().filename());
        CAPTURE(name);
        const std::string text = readTextFile(entry.path());
        CHECK(text.size() <= 2048);
        const std::clock_t start = std::clock();
        const std::string error = errorOf([&] { findEffects(parseX3d(text, name)); });
        errorOf([&] { parseResource(text, name); });
        CHECK(std::clock() - start < 60 * CLOCKS_PER_SEC);
        ++files;
        scenes += error.empty();
    }
    CHECK(files >= 25);
    CHECK(scenes >= 15);
}

#include "grader/judge/GradeFiles.h"

#include <doctest/doctest.h>

#include "base/ImageFile.h"
#include "base/WholeFile.h"
#include "grader/sandbox/Process.h"

using namespace radlab;
using namespace radlab::grader;

namespace {

Graded gradedText(const std::string& text, PngCache& pictures, Toolchain toolchain = readToolchain(RADLAB_TOOLCHAIN)) {
    JudgeOptions options;
    options.seed = 9;
    options.stages = {"maxenergy_patch"};
    Judge judge(readManifest(manifestFile()), std::move(toolchain), options);
    return gradeFiles({{"ProgRef.cpp", text}}, "ProgRef.cpp", judge, pictures);
}

const std::string rightText = readFile(RADLAB_SOURCE_DIR "/solutions/ProgRef.cpp");

}  // namespace

TEST_CASE("what compiles is graded, and its pictures come as PNG beside it") {
    PngCache pictures;
    const Graded graded = gradedText(rightText, pictures);
    CHECK(graded.result.compiled);
    CHECK(graded.result.submission == "ProgRef.cpp");
    CHECK(graded.result.score == 10.0);
    CHECK(graded.result.seed == 9);
    REQUIRE(graded.pictures.size() == 1);
    const CheckPicture& picture = graded.pictures[0];
    CHECK(picture.stage == "maxenergy_patch");
    CHECK(picture.check == "max.picture");
    CHECK(picture.rms <= picture.tolerance);
    REQUIRE(picture.images.size() == 3);
    CHECK(picture.images[0].title == "reference");
    CHECK(picture.images[1].title == "yours");
    CHECK(picture.images[2].title == "difference");
    for (const PngImage& image : picture.images) {
        CHECK(image.png.substr(0, 4) == "\x89PNG");
        CHECK(image.width == 320);
    }
}

TEST_CASE("what does not compile has no marks, and says what the compiler said, without naming a folder") {
    PngCache pictures;
    const Graded graded = gradedText("#include \"ProgRef.h\"\n\nint wrong = nonsense;\n", pictures);
    CHECK_FALSE(graded.result.compiled);
    CHECK(graded.result.compiler.find("ProgRef.cpp:3:13: error: ") == 0);
    CHECK(graded.result.compiler.find("/") == std::string::npos);
    CHECK(graded.result.score == 0.0);
    CHECK(graded.result.maxScore == 10.0);
    CHECK(graded.result.seed == 9);
    CHECK(graded.pictures.empty());
    for (const StageResult& stage : graded.result.stages) {
        CHECK(stage.status == Status::blocked);
        for (const CheckResult& check : stage.checks) {
            CHECK(check.status == Status::blocked);
            CHECK(check.message == "judged as soon as it compiles");
        }
    }
}

TEST_CASE("of several files the first is compiled, and finds those that the manifest names") {
    Manifest manifest = readManifest(manifestFile());
    manifest.files = {"Main.cpp", "Helper.h", "Unused.h"};
    JudgeOptions options;
    options.stages = {"maxenergy_patch"};
    Judge judge(manifest, readToolchain(RADLAB_TOOLCHAIN), options);
    PngCache pictures;
    const auto graded = [&](const std::string& helper, const std::string& header) {
        return gradeFiles({{"Main.cpp", "#include \"" + header + "\"\n" + rightText}, {header, helper}}, "Main.cpp",
                          judge, pictures);
    };
    CHECK(graded("constexpr int five = 5;\n", "Helper.h").result.score == 10.0);
    CHECK(graded("\nint wrong = nonsense;\n", "Helper.h").result.compiler.find("Helper.h:2:13: error: ") !=
          std::string::npos);
    const Graded other = graded("constexpr int five = 5;\n", "Other.h");
    CHECK(other.result.compiler.find("Main.cpp:1:10: fatal error: Other.h: No such file") == 0);
}

TEST_CASE("where the grader is at fault there is no mark") {
    Toolchain toolchain = readToolchain(RADLAB_TOOLCHAIN);
    toolchain.worker = "/bin/false";
    PngCache pictures;
    CHECK_THROWS_AS(gradedText(rightText, pictures, toolchain), MachineError);
}

TEST_CASE("names with folders are never written") {
    PngCache pictures;
    Judge judge(readManifest(manifestFile()), readToolchain(RADLAB_TOOLCHAIN), {});
    for (const std::string name : {"../ProgRef.cpp", "/tmp/ProgRef.cpp", "a/b.cpp"})
        CHECK_THROWS_AS(gradeFiles({{name, ""}}, name, judge, pictures), std::logic_error);
}

TEST_CASE("pictures that look alike are encoded once, as long as they are among the last") {
    PngCache pictures;
    const Image grey(4, 4, glm::vec3(0.5f)), same(4, 4, glm::vec3(0.5001f)), wide(8, 2, glm::vec3(0.5f));
    CHECK(pictures.bytes(grey) == pngBytes(grey));
    CHECK(pictures.bytes(same) == pngBytes(grey));
    CHECK(pictures.encoded() == 1);
    CHECK(pictures.bytes(wide) == pngBytes(wide));
    CHECK(pictures.encoded() == 2);
    for (int i = 0; i < 200; ++i) pictures.bytes(Image(4, 4, glm::vec3(static_cast<float>(i) / 255.0f)));
    const std::size_t before = pictures.encoded();
    CHECK(pictures.bytes(wide) == pngBytes(wide));
    CHECK(pictures.encoded() == before + 1);
}

TEST_CASE("the references are encoded before they are needed") {
    PngCache pictures;
    encodeReferences(readManifest(manifestFile()), pictures);
    const std::size_t before = pictures.encoded();
    CHECK(before > 5);
    gradedText(rightText, pictures);
    CHECK(pictures.encoded() <= before + 1);  // the difference, and what is drawn is the reference
}

TEST_CASE("extensions that are handed in are judged beside the marks, each by itself") {
    const Toolchain toolchain = readToolchain(RADLAB_TOOLCHAIN);
    const Manifest manifest = readManifest(manifestFile());
    JudgeOptions options;
    options.seed = 3;
    options.jobs = 1;
    const auto solved = [](const std::string& name) {
        return readFile(RADLAB_SOURCE_DIR "/solutions/extensions/" + name);
    };
    Result result;
    result.score = 55;
    result.maxScore = 100;
    addExtensions(
        {{"ProgRef.cpp", "not read"}, {"Hemisphere.cpp", solved("Hemisphere.cpp")}, {"Mirror.cpp", "nonsense"}},
        manifest, toolchain, options, result);
    CHECK(result.score == 55);
    CHECK(result.maxScore == 100);
    CHECK(result.compiled);
    CHECK(result.stages.empty());
    REQUIRE(result.extensions.size() == 2);
    CHECK(result.extensions[0].stage == "hemisphereFF");
    CHECK(result.extensions[0].status == Status::pass);
    CHECK(result.extensions[0].score == result.extensions[0].maxScore);
    CHECK(result.extensions[1].stage == "mirrorScene");
    CHECK(result.extensions[1].status == Status::blocked);
    CHECK(result.compiler.find("Mirror.cpp:1:1: error: ") == 0);
}

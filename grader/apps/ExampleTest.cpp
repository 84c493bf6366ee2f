// The failing cases that check prints are tests: they compile, fail with the submission and pass with the solution.

#include <doctest/doctest.h>

#include "base/TestFolder.h"
#include "base/WholeFile.h"
#include "grader/judge/Judge.h"
#include "grader/sandbox/Process.h"

using namespace radlab;
using namespace radlab::grader;

namespace {

const std::string solution = readFile(RADLAB_SOURCE_DIR "/solutions/ProgRef.cpp");

std::string exampleOf(const test::Folder& folder, const std::string& stage) {
    const Toolchain toolchain = readToolchain(RADLAB_TOOLCHAIN);
    const Manifest manifest = readManifest(manifestFile());
    compileSubmission(folder / "ProgRef.cpp", folder / "submission.so", toolchain, manifest);
    JudgeOptions options;
    options.stages = {stage};
    const Result result = Judge(manifest, toolchain, options).judge(folder / "submission.so");
    for (const CheckResult& check : result.stages.at(0).checks)
        if (!check.example.empty()) return check.example;
    return "";
}

// The exit code of the example as a test of what lies in ProgRef.cpp.
int outcome(const test::Folder& folder, const std::string& example) {
    writeFile(folder / "example.cpp",
              "#include <doctest/doctest.h>\n#include \"course/PatchMesh.h\"\n"
              "#include \"course/ProgRef.h\"\n" +
                  example);
    writeFile(folder / "build.sh", std::string("set -e\ncd \"$(dirname \"$0\")\"\n") + RADLAB_EXAMPLE_COMPILER +
                                       " -std=c++20 -I" RADLAB_SOURCE_DIR "/framework -I" RADLAB_SOURCE_DIR
                                       "/framework/course example.cpp ProgRef.cpp " RADLAB_EXAMPLE_LIBRARIES
                                       " -o example || exit 2\n./example\n");
    ProcessLimits limits;
    limits.seconds = 120.0;
    limits.file = std::size_t{256} << 20;
    limits.memory = 0;
    const Ended ended = run({{"/bin/sh", (folder / "build.sh").string()}}, "", limits);
    INFO(ended.output);
    REQUIRE(ended.how == Ended::How::exited);
    REQUIRE(ended.code != 2);
    return ended.code;
}

}  // namespace

TEST_CASE("a failing case that is printed fails with the submission, and passes with the solution") {
    const auto checkExample = [](const std::string& stage, const std::string& from, const std::string& to) {
        CAPTURE(stage);
        const test::Folder folder;
        std::string wrong = solution;
        REQUIRE(wrong.find(from) != std::string::npos);
        wrong.replace(wrong.find(from), from.size(), to);
        writeFile(folder / "ProgRef.cpp", wrong);
        const std::string example = exampleOf(folder, stage);
        REQUIRE_FALSE(example.empty());
        CAPTURE(example);
        CHECK(outcome(folder, example) == 1);
        writeFile(folder / "ProgRef.cpp", solution);
        CHECK(outcome(folder, example) == 0);
    };
    checkExample("calcAnalyticalFF", "return cosineFrom * cosineTo", "return std::sin(cosineFrom) * cosineTo");
    checkExample("distributeEnergy", "patch->diffuse * arriving", "patch->diffuse * arriving + Vec3f(0.01f)");
}

#include "grader/judge/Judge.h"

#include <doctest/doctest.h>

#include "base/TestFolder.h"
#include "base/WholeFile.h"
#include "grader/judge/Extension.h"

using namespace radlab;
using namespace radlab::grader;

namespace {

const std::string solution = readFile(RADLAB_SOURCE_DIR "/solutions/ProgRef.cpp");

std::string changed(const std::string& from, const std::string& to) {
    std::string text = "#include <signal.h>\n#include <unistd.h>\n#include <thread>\n" + solution;
    const std::size_t place = text.find(from);
    REQUIRE(place != std::string::npos);
    return text.replace(place, from.size(), to);
}

Result judged(const std::string& text, const std::vector<std::string>& stages, std::uint64_t seed = 1,
              double seconds = 60.0) {
    const Toolchain toolchain = readToolchain(RADLAB_TOOLCHAIN);
    Manifest manifest = readManifest(manifestFile());
    manifest.seconds = seconds;
    const test::Folder folder;
    writeFile(folder / "ProgRef.cpp", text);
    compileSubmission(folder / "ProgRef.cpp", folder / "submission.so", toolchain, manifest);
    JudgeOptions options;
    options.stages = stages;
    options.seed = seed;
    return Judge(manifest, toolchain, options).judge(folder / "submission.so");
}

const StageResult& stageOf(const Result& result, const std::string& name) {
    for (const StageResult& stage : result.stages)
        if (stage.stage == name) return stage;
    throw std::logic_error(name);
}

std::string firstMessage(const StageResult& stage) {
    for (const CheckResult& check : stage.checks)
        if (check.status != Status::pass) return check.message;
    return "";
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

const std::string inStage1 = "MyPolygon* maxenergy_patch() {";
const std::string inStage2 = "MyPolygon* calcAnalyticalFF() {";
const std::vector<std::string> twoStages = {"maxenergy_patch", "calcAnalyticalFF"};

Result in(const std::string& statement, double seconds = 60.0) {
    return judged(changed(inStage1, inStage1 + " " + statement), twoStages, 1, seconds);
}

// What is said of the first stage, which alone has lost its marks.
std::string only(const Result& result) {
    CHECK(stageOf(result, "calcAnalyticalFF").status == Status::pass);
    CHECK(stageOf(result, "maxenergy_patch").status == Status::fail);
    CHECK(stageOf(result, "maxenergy_patch").score == 0.0);
    return firstMessage(stageOf(result, "maxenergy_patch"));
}

}  // namespace

TEST_CASE("the solutions keep all marks, whichever seed") {
    for (const std::uint64_t seed : {1u, 2u, 77u}) {
        CAPTURE(seed);
        const Result result = judged(solution, {}, seed);
        CHECK(result.score == result.maxScore);
        CHECK(result.maxScore == 100.0);
        for (const StageResult& stage : result.stages) CHECK_MESSAGE(stage.status == Status::pass, firstMessage(stage));
    }
    const Result older = judged(readFile(RADLAB_SOURCE_DIR "/solutions/OlderStyle.cpp"), {});
    CHECK(older.score == 100.0);
    for (const StageResult& stage : older.stages) CHECK_MESSAGE(stage.status == Status::pass, firstMessage(stage));
}

TEST_CASE("stubs are not started, and lose no stage but their own its marks") {
    const Result result = judged(readFile(RADLAB_SOURCE_DIR "/exercises/ProgRef.cpp"), {});
    CHECK(result.score == 0.0);
    for (const StageResult& stage : result.stages)
        CHECK(stage.status == (stage.stage == "together" ? Status::blocked : Status::notStarted));
    const Result one = judged(changed(inStage1, inStage1 + " throw NotImplemented(\"maxenergy_patch\");"), {});
    CHECK(stageOf(one, "maxenergy_patch").status == Status::notStarted);
    CHECK(one.score == 90.0);
    CHECK(stageOf(one, "together").status == Status::blocked);
}

TEST_CASE("a crash, a hang, an exit and a closed descriptor cost their own stage alone, and are named") {
    CHECK(has(only(in("raise(11);")), "stopped by signal 11"));
    CHECK(has(only(in("std::abort();")), "stopped by signal 6"));
    CHECK(has(only(in("for (volatile unsigned i = 0;; i = i + 1) {}", 5.0)), "took longer than "));
    CHECK(has(only(in("std::cout << \"all passed, score 100\\n\"; std::exit(0);")),
              "ended by itself, with exit code 0, in maxenergy_patch"));
    CHECK(has(only(in("extern int closeNothing; for (int i = 3; i < 64; ++i) fclose(fdopen(i, \"w\"));")),
              "in maxenergy_patch"));
    CHECK(has(only(in("throw std::runtime_error(\"thrown here\");")), "ended with an exception: thrown here"));
    CHECK(has(only(in("throw 7;")), "exception"));
}

TEST_CASE(
    "who takes the processors from itself by many threads, or stops itself, loses marks, and no machine is blamed") {
    // At the limit of time, or where there are many processors, at that of what they may do together; never the machine's fault.
    CHECK(has(only(in("const auto spin = [] { for (volatile unsigned i = 0;; i = i + 1) {} }; "
                      "for (int i = 0; i < 40; ++i) std::thread(spin).detach(); spin();",
                      2.0)),
              " in maxenergy_patch"));
    CHECK(has(only(in("raise(19);", 2.0)), "took longer than "));
}

TEST_CASE("what a submission prints is kept, and believed by nobody") {
    const Result result =
        judged(changed(inStage1, inStage1 + " std::cout << \"{\\\"score\\\": 100} \\x1b[2J\"; return nullptr;"),
               {"maxenergy_patch"});
    const StageResult& stage = result.stages.at(0);
    CHECK(stage.score < 10.0);
    CHECK(has(stage.checks.at(0).output, "{\"score\": 100} \x1b[2J"));
    const Result flood =
        judged(changed(inStage1, inStage1 + " for (int i = 0; i < 1000000; ++i) std::cout << \"0123456789\";"),
               {"maxenergy_patch"});
    for (const CheckResult& check : flood.stages.at(0).checks) CHECK(check.output.size() <= 64u << 10);
}

TEST_CASE("numbers that are none, and patches that are no longer there, fail") {
    const std::string loop =
        "for (MyPolygon* patch : polygons) patch->formF = patch == shooter ? 0.0f : pointToPoint(shooter, patch);";
    for (const std::string number : {"NAN", "INFINITY", "-INFINITY"}) {
        CAPTURE(number);
        const Result result =
            judged(changed(loop, "for (MyPolygon* patch : polygons) patch->formF = " + number + ";"), twoStages);
        CHECK(stageOf(result, "calcAnalyticalFF").status == Status::fail);
        CHECK(stageOf(result, "maxenergy_patch").status == Status::pass);
    }
    const Result cleared = judged(changed(loop, loop + " polygons.clear(); vertices.clear();"), twoStages);
    CHECK(stageOf(cleared, "maxenergy_patch").status == Status::pass);
}

TEST_CASE("a wrong maxenergy_patch does not reach the stages that call it") {
    const Result result = judged(changed(inStage1, inStage1 + " static MyPolygon copy; return &copy;"), {});
    CHECK(result.score == 90.0 + stageOf(result, "maxenergy_patch").score);
    CHECK(stageOf(result, "maxenergy_patch").status == Status::fail);
}

TEST_CASE("a wrong renderPatchIDs does not reach calcFF") {
    const Result result = judged(changed("void renderPatchIDs() {", "void renderPatchIDs() { return;"), {});
    CHECK(stageOf(result, "renderPatchIDs").status == Status::fail);
    CHECK(stageOf(result, "calcFF").status == Status::pass);
    CHECK(stageOf(result, "together").status == Status::blocked);
}

TEST_CASE("a file that does not compile, or calls what is not there, is an Error with its line") {
    const Toolchain toolchain = readToolchain(RADLAB_TOOLCHAIN);
    const Manifest manifest = readManifest(manifestFile());
    const test::Folder folder;
    writeFile(folder / "ProgRef.cpp", "#include \"ProgRef.h\"\n\nint wrong = nonsense;\n");
    try {
        compileSubmission(folder / "ProgRef.cpp", folder / "submission.so", toolchain, manifest);
        FAIL("it compiled");
    } catch (const CompileError& error) {
        CHECK(has(error.what(), "ProgRef.cpp:3:13: error: "));
        CHECK(has(error.what(), "nonsense"));
    }
    CHECK_THROWS_AS(compileSubmission(folder / "absent.cpp", folder / "submission.so", toolchain, manifest), Error);
    const Result missing =
        judged("#include \"ProgRef.h\"\nvoid helper();\nMyPolygon* maxenergy_patch() { helper(); return nullptr; }\n",
               {"maxenergy_patch"});
    CHECK(has(firstMessage(missing.stages.at(0)), "helper"));
    const Result lacking = judged("#include \"ProgRef.h\"\n", {"maxenergy_patch"});
    CHECK(has(firstMessage(lacking.stages.at(0)), "no function maxenergy_patch"));
}

TEST_CASE("a compiler that fails at the course's own headers is the machine's fault, whatever the submission says") {
    const Manifest manifest = readManifest(manifestFile());
    const test::Folder folder;
    const auto reason = [&](const std::string& submission, const auto& breakIt) {
        Toolchain toolchain = readToolchain(RADLAB_TOOLCHAIN);
        breakIt(toolchain);
        writeFile(folder / "ProgRef.cpp", submission);
        try {
            compileSubmission(folder / "ProgRef.cpp", folder / "submission.so", toolchain, manifest);
        } catch (const MachineError& error) {
            return std::string(error.what());
        } catch (const CompileError& error) {
            return std::string("the submission's: ") + error.what();
        }
        return std::string("none");
    };
    const auto leave = [](Toolchain&) {};
    const auto flag = [](Toolchain& toolchain) { toolchain.flags.emplace_back("-fno-such-flag"); };
    const auto headers = [](Toolchain& toolchain) {
        std::erase_if(toolchain.flags, [](const std::string& one) { return one.rfind("-I", 0) == 0; });
    };
    const auto compiler = [](Toolchain& toolchain) { toolchain.compiler = "/bin/false"; };
    CHECK(reason(solution, leave) == "none");
    CHECK(has(reason(solution, flag), "do not compile on this machine"));
    CHECK(has(reason(solution, headers), "course/ProgRef.h"));
    CHECK(has(reason(solution, compiler), "ended with exit code 1"));
    CHECK(has(reason("int wrong = nonsense;\n", flag), "do not compile on this machine"));
    CHECK(has(reason("#error course's own headers do not compile on this machine\n", leave), "the submission's: "));
}

TEST_CASE("the same seed draws the same cases") {
    const std::string wrong = changed("static_cast<float>(M_1_PI) / distance2", "1.0f / (3.2f * distance2)");
    const Result first = judged(wrong, {"calcAnalyticalFF"}, 5), again = judged(wrong, {"calcAnalyticalFF"}, 5),
                 other = judged(wrong, {"calcAnalyticalFF"}, 6);
    const auto messages = [](const Result& result) {
        std::string all;
        for (const CheckResult& check : result.stages.at(0).checks) all += check.message + "\n";
        return all;
    };
    CHECK(messages(first) == messages(again));
    CHECK(messages(first) != messages(other));
}

TEST_CASE("a worker that does not start is an error of the machine, never marks lost") {
    Toolchain toolchain = readToolchain(RADLAB_TOOLCHAIN);
    toolchain.worker = "/bin/false";
    const Result result = Judge(readManifest(manifestFile()), toolchain, {}).judge("/nowhere.so");
    for (const StageResult& stage : result.stages)
        if (stage.stage != "together") CHECK(stage.status == Status::error);
    CHECK(has(firstMessage(result.stages.at(0)), "does not start on this machine"));
}

TEST_CASE("an extension whose file is a stub, or not there, is not started") {
    const Toolchain toolchain = readToolchain(RADLAB_TOOLCHAIN);
    const Manifest manifest = readManifest(manifestFile());
    for (const ManifestStage& extension : manifest.extensions)
        for (const char* folder : {"/exercises/extensions/", "/no/such/folder/"}) {
            CAPTURE(extension.stage);
            CAPTURE(folder);
            const Result result =
                judgeExtension(extension, RADLAB_SOURCE_DIR + (folder + extension.file), manifest, toolchain, {});
            CHECK(result.maxScore == 0.0);
            CHECK(result.stages.empty());
            REQUIRE(result.extensions.size() == 1);
            CHECK(result.extensions[0].status == Status::notStarted);
            CHECK(result.extensions[0].score == 0.0);
            CHECK(result.extensions[0].maxScore == 10.0);
            for (const CheckResult& check : result.extensions[0].checks) CHECK(check.status == Status::notStarted);
        }
}

TEST_CASE("the solved extensions keep all points, whichever seed") {
    const Toolchain toolchain = readToolchain(RADLAB_TOOLCHAIN);
    const Manifest manifest = readManifest(manifestFile());
    for (const ManifestStage& extension : manifest.extensions)
        for (const std::uint64_t seed : {1u, 5u}) {
            CAPTURE(extension.stage);
            CAPTURE(seed);
            JudgeOptions options;
            options.seed = seed;
            const Result result = judgeExtension(extension, RADLAB_SOURCE_DIR "/solutions/extensions/" + extension.file,
                                                 manifest, toolchain, options);
            CHECK(result.extensions[0].status == Status::pass);
            CHECK(result.extensions[0].score == 10.0);
        }
}

// A spread of the mutants, judged as bench-grader judges them all.

#include <doctest/doctest.h>

#include "base/TestFolder.h"
#include "base/WholeFile.h"
#include "grader/judge/Extension.h"
#include "grader/mutants/Mutant.h"

using namespace radlab;
using namespace radlab::grader;

namespace {

constexpr std::size_t spread = 37;  // every thirty-seventh
constexpr std::size_t spreadOfExtensions = 11;

// One judge for all, so that what is right is found once.
class MutantJudge {
public:
    MutantJudge() { manifest.seconds = 20.0; }

    Result judged(const Mutant& mutant) {
        const test::Folder folder;
        writeFile(folder / "ProgRef.cpp", mutant.source);
        compileSubmission(folder / "ProgRef.cpp", folder / "submission.so", toolchain, manifest);
        return judge.judge(folder / "submission.so");
    }

private:
    static JudgeOptions options() {
        JudgeOptions chosen;
        chosen.seed = 1000;
        return chosen;
    }

    const Toolchain toolchain = readToolchain(RADLAB_TOOLCHAIN);
    Manifest manifest = readManifest(manifestFile());
    Judge judge{manifest, toolchain, options()};
};

}  // namespace

TEST_CASE("wrong programs lose marks in the stage that is wrong alone, and right programs lose none") {
    const std::vector<Mutant> mutants = projectMutants();
    MutantJudge judge;
    for (std::size_t i = 0; i < mutants.size(); i += spread) {
        const Mutant& mutant = mutants[i];
        const std::string which = mutant.stage + " " + mutant.id;
        CAPTURE(which);
        const Result result = judge.judged(mutant);
        std::string name;
        for (const StageResult& stage : result.stages) {
            CHECK(stage.status != Status::error);
            const bool isWrong = mutant.wrong && stage.stage == mutant.stage;
            if (stage.maxScore > 0.0) CHECK((stage.score < stage.maxScore) == isWrong);
            for (const CheckResult& check : stage.checks)
                if (check.diagnosis) name = check.diagnosis->id;
        }
        if (!mutant.names.empty()) CHECK(std::count(mutant.names.begin(), mutant.names.end(), name) == 1);
    }
}

TEST_CASE("wrong extensions lose points and are named, right ones keep all, and neither has any marks") {
    const Toolchain toolchain = readToolchain(RADLAB_TOOLCHAIN);
    Manifest manifest = readManifest(manifestFile());
    manifest.seconds = 20.0;
    const std::vector<Mutant> mutants = extensionMutants();
    for (std::size_t i = 0; i < mutants.size(); i += spreadOfExtensions) {
        const Mutant& mutant = mutants[i];
        const std::string which = mutant.stage + " " + mutant.id;
        CAPTURE(which);
        const test::Folder folder;
        writeFile(folder / mutant.file, mutant.source);
        JudgeOptions options;
        options.seed = 2000 + i;
        const Result result =
            judgeExtension(manifest.find(mutant.stage), folder / mutant.file, manifest, toolchain, options);
        CHECK(result.maxScore == 0.0);
        CHECK(result.stages.empty());
        REQUIRE(result.extensions.size() == 1);
        const StageResult& stage = result.extensions[0];
        CHECK(stage.status == (mutant.wrong ? Status::fail : Status::pass));
        CHECK((stage.score < stage.maxScore) == mutant.wrong);
        if (mutant.names.empty()) continue;
        std::string name;
        for (const CheckResult& check : stage.checks)
            if (check.diagnosis) name = check.diagnosis->id;
        CHECK(std::count(mutant.names.begin(), mutant.names.end(), name) == 1);
    }
}

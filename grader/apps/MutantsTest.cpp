// A spread of the mutants, judged as bench-grader judges them all.

#include <doctest/doctest.h>

#include "base/TestFolder.h"
#include "base/WholeFile.h"
#include "grader/judge/Judge.h"
#include "grader/mutants/Mutant.h"

using namespace radlab;
using namespace radlab::grader;

namespace {

constexpr std::size_t spread = 23;  // every twenty-third

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

#include <set>

#include "grader/stages/IdDrawing.h"
#include "grader/stages/StageTestHelp.h"

using namespace radlab;
using namespace radlab::grader;

namespace {

const std::unique_ptr<Stage> stage = patchIdStage();

std::size_t patchesOf(const Case& asked) { return asked.steps[0].state->patches.size(); }

}  // namespace

TEST_CASE("renderPatchIDs: the right way passes") { checkRightWaysPass(*stage, 3); }

TEST_CASE("renderPatchIDs: every mistake fails and is named, most by small pictures alone") {
    const std::vector<Check> all = stage->checks(1);
    std::vector<Check> small = all;
    std::erase_if(small, [](const Check& check) { return check.id == "ids.many"; });
    int slow = 0;
    for (const Mistake& mistake : stage->mistakes()) {
        StageVerdict verdict = judgeAll(*stage, small, runsOf(small, mistake.computation));
        const auto name = [&] { return verdict.diagnosis ? verdict.diagnosis->id : ""; };
        if (name() != mistake.id) {
            ++slow;
            verdict = judgeAll(*stage, all, runsOf(all, mistake.computation));
        }
        CAPTURE(mistake.id);
        CAPTURE(mistake.text);
        CHECK(firstFailure(verdict) != "");
        CHECK(name() == mistake.id);
    }
    CHECK(slow < 8);
}

TEST_CASE("renderPatchIDs: texts are sentences") { checkWording(*stage); }

TEST_CASE("renderPatchIDs: drawing in reverse order is right, unless the depth test is off") {
    const IdDrawer drawer;
    for (const bool depthTest : {true, false}) {
        IdDrawing reversed;
        reversed.style.reverse = true;
        reversed.style.depthTest = depthTest;
        CHECK((firstFailure(judged(*stage, 1, drawer.draws(reversed))) == "") == depthTest);
    }
}

TEST_CASE("renderPatchIDs: IDs of one, two and three bytes are in view, and most pixels are judged") {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        CAPTURE(seed);
        std::set<std::size_t> high;
        for (const Check& check : stage->checks(seed))
            for (const Case& asked : check.cases) {
                CAPTURE(asked.what);
                const Step& step = asked.steps[0];
                const StepAnswer none;
                const Outcome right = stage->right()[0]({*step.state, step, none, nullptr});
                std::size_t open = 0, drawn = 0;
                for (std::size_t pixel = 0; pixel < right.pixels.size(); ++pixel) {
                    open += std::isinf(right.slack[pixel]);
                    drawn += right.pixels[pixel] > 0.0;
                    if (!std::isinf(right.slack[pixel]))
                        high.insert(static_cast<std::size_t>(right.pixels[pixel]) >> 15);
                }
                CHECK(5 * open < right.pixels.size());
                CHECK((drawn > 0) == (patchesOf(asked) > 0));
            }
        CHECK(high == std::set<std::size_t>{0, 1, 2});
    }
}

TEST_CASE("renderPatchIDs: messages name the pixel and both IDs") {
    const IdDrawer drawer;
    IdDrawing fromZero;
    fromZero.shade = [](const State&, int patch) { return shadeOf(static_cast<std::uint32_t>(patch)); };
    const std::string message = firstFailure(judged(*stage, 1, drawer.draws(fromZero)));
    CAPTURE(message);
    CHECK(message.find("in the case 'a single patch': pixel (") == 0);
    CHECK(message.find("is (0, 0, 0), the background, expected (0, 0, 1), the ID 1") != std::string::npos);
}

TEST_CASE("bytes of colours round to the nearest, and say where rounding decides") {
    bool sure = true;
    CHECK(byteOf(-1.0, sure) == 0);
    CHECK(byteOf(2.0, sure) == 255);
    CHECK(byteOf(17.4 / 255.0, sure) == 17);
    CHECK(byteOf(17.6 / 255.0, sure) == 18);
    CHECK(sure);
    byteOf(17.5 / 255.0, sure);
    CHECK(!sure);
}

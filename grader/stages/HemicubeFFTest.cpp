#include <numeric>

#include "grader/stages/HemicubeShot.h"
#include "grader/stages/StageTestHelp.h"

using namespace radlab;
using namespace radlab::grader;

namespace {

const std::unique_ptr<Stage> stage = hemicubeStage();

HemicubeCall render(const Vec3f& eye, const Vec3f& up, const Vec3f& direction) { return {false, eye, up, direction}; }
HemicubeCall read() { return {true, Vec3f(0.0f), Vec3f(0.0f), Vec3f(0.0f)}; }

// Calls of a submission, from the shooter.
Calls calling(const std::function<std::vector<HemicubeCall>(const State&, const MyPolygon& shooter)>& calls) {
    return [calls](const State& before, const Step& step) {
        if (step.shooter < 0) return std::vector<HemicubeCall>();
        return calls(before, before.patches[static_cast<std::size_t>(step.shooter)]);
    };
}

Vec3f firstEdge(const State& state, const MyPolygon& patch) {
    const auto corner = [&](int i) { return state.corners[static_cast<std::size_t>(patch.vertex[i])].position; };
    return corner(1) - corner(0);
}

HemicubeCall rightRender(const State& state, const MyPolygon& patch) {
    return render(patch.center, firstEdge(state, patch), patch.normal);
}

// Mistakes that show in the calls themselves.
Calls callsOf(const std::string& mistake) {
    if (mistake == "read-back-missing")
        return calling([](const State& state, const MyPolygon& patch) {
            return std::vector<HemicubeCall>{rightRender(state, patch)};
        });
    if (mistake == "render-missing")
        return calling([](const State&, const MyPolygon&) { return std::vector<HemicubeCall>{read()}; });
    if (mistake == "read-before-render")
        return calling([](const State& state, const MyPolygon& patch) {
            return std::vector<HemicubeCall>{read(), rightRender(state, patch)};
        });
    return noCalls;
}

double sumOfRow(const Outcome& outcome) {
    return std::accumulate(outcome.state.patches.begin(), outcome.state.patches.end(), 0.0,
                           [](double sum, const MyPolygon& patch) { return sum + static_cast<double>(patch.formF); });
}

const Case& caseOf(const std::vector<Check>& checks, const std::string& id, std::size_t k) {
    for (const Check& check : checks)
        if (check.id == id) return check.cases.at(k);
    throw Error("no check " + id);
}

}  // namespace

TEST_CASE("calcFF: the right way passes, any up vector in the patch's plane or off it") {
    checkRightWaysPass(*stage, 2);
    checkRightWaysPass(*stage, 2, calling([](const State& state, const MyPolygon& patch) {
        return std::vector<HemicubeCall>{rightRender(state, patch), read()};
    }));
    checkRightWaysPass(*stage, 1, calling([](const State& state, const MyPolygon& patch) {
        const Vec3f up = normalize(firstEdge(state, patch)) + 2.0f * patch.normal;
        return std::vector<HemicubeCall>{render(patch.center, up, 5.0f * patch.normal), read()};
    }));
}

TEST_CASE("calcFF: every mistake fails and is named, most without many patches") {
    const std::vector<Check> all = stage->checks(1);
    std::vector<Check> small = all;
    std::erase_if(small, [](const Check& check) { return check.id == "hemi.many"; });
    int slow = 0;
    for (const Mistake& mistake : stage->mistakes()) {
        const Calls calls = callsOf(mistake.id);
        StageVerdict verdict = judgeAll(*stage, small, runsOf(small, mistake.computation, calls));
        const auto name = [&] { return verdict.diagnosis ? verdict.diagnosis->id : ""; };
        if (name() != mistake.id) {
            ++slow;
            verdict = judgeAll(*stage, all, runsOf(all, mistake.computation, calls));
        }
        CAPTURE(mistake.id);
        CAPTURE(mistake.text);
        CHECK(firstFailure(verdict) != "");
        CHECK(name() == mistake.id);
    }
    CHECK(slow < 8);
}

TEST_CASE("calcFF: texts are sentences") { checkWording(*stage); }

TEST_CASE("calcFF: rows sum to 1 in closed rooms, and to less in the open") {
    const std::vector<Check> checks = stage->checks(1);
    for (const auto& [id, closed] : {std::pair{"hemi.closed", true}, std::pair{"hemi.few", false}})
        for (std::size_t k = 0; k < 5; ++k) {
            const Step& step = caseOf(checks, id, k).steps[0];
            const double sum = sumOfRow(stage->right()[0]({*step.state, step, {}, nullptr}));
            CAPTURE(id);
            CHECK(sum == doctest::Approx(closed ? 1.0 : sum).epsilon(1e-4));
            if (!closed) CHECK(sum < 0.9);
        }
}

TEST_CASE("calcFF: the first, the last and, of many, some patches of three bytes are well in view") {
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        CAPTURE(seed);
        const std::vector<Check> checks = stage->checks(seed);
        const auto row = [&](const std::string& id, std::size_t k) {
            const Step& step = caseOf(checks, id, k).steps[0];
            return stage->right()[0]({*step.state, step, {}, nullptr});
        };
        const Outcome few = row("hemi.few", 3), many = row("hemi.many", 2);
        const auto& fewPatches = few.state.patches;
        CHECK(fewPatches.front().formF > 10.0 * few.slack.front());
        CHECK(fewPatches.back().formF > 10.0 * few.slack.back());
        REQUIRE(many.state.patches.size() > 65536);
        double high = 0.0, signBit = 0.0;
        for (std::size_t j = 32767; j < many.state.patches.size(); ++j) {
            const double sure = static_cast<double>(many.state.patches[j].formF) - many.slack[j];
            if (sure > 0.0) (j < 65535 ? signBit : high) += sure;
        }
        CHECK(high > 0.01);
        CHECK(signBit > 0.01);
    }
}

TEST_CASE("the camera is the submission's own where it is right") {
    State state;
    MyPolygon patch;
    patch.center = Vec3f(1.0f, 2.0f, 3.0f);
    patch.normal = Vec3f(0.0f, 0.0f, 1.0f);
    patch.area = 4.0f;
    const Step step;
    const Vec3f up(1.0f, 1.0f, 0.0f), other(0.3f, -1.0f, 5.0f);
    const auto eyeWith = [&](const std::vector<HemicubeCall>& calls) {
        StepAnswer answer;
        answer.calls = calls;
        return rightCamera({state, step, answer, nullptr}, patch);
    };
    CHECK(eyeWith({render(patch.center, up, patch.normal), read()}).up == up);
    CHECK(eyeWith({render(patch.center, other, 3.0f * patch.normal), read()}).up == other);
    CHECK(eyeWith({render(other, up, patch.normal), read(), render(patch.center, other, patch.normal), read()}).up ==
          other);
    // Not its own: up along the normal, an eye behind the patch or aside, the wrong way.
    CHECK(eyeWith({render(patch.center, patch.normal, patch.normal), read()}).up != patch.normal);
    CHECK(eyeWith({render(patch.center - 0.001f * patch.normal, up, patch.normal), read()}).eye == patch.center);
    CHECK(eyeWith({render(patch.center + Vec3f(0.1f, 0, 0), up, patch.normal), read()}).eye == patch.center);
    CHECK(eyeWith({render(patch.center, up, -patch.normal), read()}).direction == patch.normal);
    CHECK(eyeWith({render(Vec3f(NAN), up, Vec3f(NAN)), read()}).eye == patch.center);
    CHECK(eyeWith({}).direction == patch.normal);
}

TEST_CASE("what a submission did with its hemicube is told from its calls") {
    const auto useWith = [](const std::vector<HemicubeCall>& calls) {
        StepAnswer answer;
        answer.calls = calls;
        return useOf(answer);
    };
    const HemicubeCall first = render(Vec3f(1), Vec3f(2), Vec3f(3)), second = render(Vec3f(4), Vec3f(5), Vec3f(6));
    CHECK(!useWith({}).camera);
    CHECK(useWith({first, read(), second}).camera->eye == Vec3f(1));
    CHECK(useWith({first, second, read()}).camera->eye == Vec3f(4));
    CHECK(useWith({read(), first}).readTooEarly);
    CHECK(!useWith({first, read()}).readTooEarly);
    CHECK(!useWith({first}).read);
    CHECK(!useWith({read()}).rendered);
}

#include "grader/stages/StageTestHelp.h"

using namespace radlab;
using namespace radlab::grader;

namespace {

const std::unique_ptr<Stage> stage = distributeStage();

using Factor = std::function<glm::dvec3(const MyPolygon& from, const MyPolygon& to)>;

// Right but for a factor, in single precision and in another order than the stage's own.
Computation shooting(const Factor& factor) {
    return [factor](const Situation& at) {
        Outcome outcome;
        outcome.state = at.before;
        if (at.step.shooter < 0) return outcome;
        outcome.returned = 1;
        MyPolygon& from = outcome.state.patches[static_cast<std::size_t>(at.step.shooter)];
        for (MyPolygon& to : outcome.state.patches) {
            if (&to == &from) continue;
            const Vec3f gain =
                from.unshot_rad * from.area * (to.diffuse / to.area) * to.formF * Vec3f(factor(from, to));
            to.rad += gain;
            to.unshot_rad += gain;
        }
        from.unshot_rad = Vec3f(0.0f);
        return outcome;
    };
}

Factor number(const std::function<double(const MyPolygon& from, const MyPolygon& to)>& factor) {
    return [factor](const MyPolygon& from, const MyPolygon& to) { return glm::dvec3(factor(from, to)); };
}

std::string diagnosis(std::uint64_t seed, const Factor& factor) {
    const StageVerdict verdict = judged(*stage, seed, shooting(factor));
    return verdict.diagnosis ? verdict.diagnosis->id + ": " + verdict.diagnosis->text : "";
}

using Ids = std::vector<std::string>;

Ids failedBy(const std::string& id) {
    for (const Mistake& mistake : stage->mistakes())
        if (mistake.id == id) return failedChecks(*stage, 1, mistake.computation);
    return {"no such mistake: " + id};
}

}  // namespace

TEST_CASE("distribute: the right way passes") { checkRightWaysPass(*stage, 50); }

TEST_CASE("distribute: floats, in any order, pass") {
    for (std::uint64_t seed = 1; seed <= 50; ++seed)
        CHECK(firstFailure(judged(*stage, seed, shooting(number([](auto&, auto&) { return 1.0; })))) == "");
}

TEST_CASE("distribute: a deviation of 0.01 % does not pass") {
    for (std::uint64_t seed = 1; seed <= 20; ++seed)
        CHECK(firstFailure(judged(*stage, seed, shooting(number([](auto&, auto&) { return 1.0001; })))) != "");
}

TEST_CASE("distribute: every mistake fails and is named") { checkMistakesAreNamed(*stage, 5); }

TEST_CASE("distribute: no two mistakes are the same") { checkMistakesDiffer(*stage, 1); }

TEST_CASE("distribute: texts are sentences") { checkWording(*stage); }

TEST_CASE("distribute: combinations of wrong factors are found by the fit") {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        CAPTURE(seed);
        CHECK(diagnosis(seed, [](const MyPolygon&,
                                 const MyPolygon& to) { return glm::dvec3(to.diffuse) * double(to.area); }) ==
              "exponents: Your numbers follow the formula but for this: the reflectance is squared; the receiver's "
              "area is missing.");
        CHECK(
            diagnosis(seed,
                      [](const MyPolygon& from, const MyPolygon& to) {
                          return glm::dvec3(from.diffuse) / double(from.area * to.formF);
                      }) ==
            "exponents: Your numbers follow the formula but for this: the shooter's reflectance is a factor too many; "
            "the form factor is missing; the shooter's area is missing.");
        CHECK(diagnosis(seed, number([](auto&, const MyPolygon& to) { return 4.0 * double(to.area); })) ==
              "exponents: Your numbers follow the formula but for this: the receiver's area is missing; all is 4 times "
              "what it should be.");
    }
}

TEST_CASE("distribute: one mistake costs its own marks") {
    CHECK(failedBy("returns-false") == Ids{"dist.null"});
    CHECK(failedBy("unshot-kept") == Ids{"dist.unshot", "dist.twice"});
    CHECK(failedBy("only-rad") == Ids{"dist.unshot", "dist.twice"});
    CHECK(failedBy("shooter-loses-rad") ==
          Ids{"dist.rad", "dist.channels", "dist.areas", "dist.twice", "dist.range", "dist.alone"});
}

TEST_CASE("distribute: form factors, areas and materials must stay") {
    const std::vector<std::function<void(MyPolygon&)>> changes = {
        [](MyPolygon& patch) { patch.formF = 0.0f; }, [](MyPolygon& patch) { patch.area *= 2.0f; },
        [](MyPolygon& patch) { patch.diffuse *= 0.5f; }, [](MyPolygon& patch) { patch.emissive = Vec3f(0.0f); }};
    for (const auto& change : changes) {
        const Computation way = [&](const Situation& at) {
            Outcome outcome = stage->right().front()(at);
            if (!at.earlier && at.step.shooter >= 0)
                for (MyPolygon& patch : outcome.state.patches) change(patch);
            return outcome;
        };
        const Ids failed = failedChecks(*stage, 1, way);
        CHECK(std::find(failed.begin(), failed.end(), "dist.alone") != failed.end());
    }
}

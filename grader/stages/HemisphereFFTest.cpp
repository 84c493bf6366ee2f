#include <cmath>

#include "course/RandomNumbers.h"
#include "grader/stages/HemisphereMistakes.h"
#include "grader/stages/Meshes.h"
#include "grader/stages/StageTestHelp.h"

using namespace radlab;
using namespace radlab::grader;

namespace {

const std::unique_ptr<Stage> stage = hemisphereStage();

// A program that uses rays that way: random ones, counted one by one.
Computation program(const RayUse& use) {
    return [use](const Situation& at) {
        Outcome outcome;
        outcome.state = at.before;
        outcome.returned = use.returnsShooter ? at.step.shooter : -1;
        if (at.step.shooter < 0) return outcome;
        const RayScene scene(at.before);
        RandomNumbers random(at.step.seed);
        const auto number = [&] { return static_cast<double>(random.next()); };
        std::vector<double> sums(at.before.patches.size());
        int met = 0;
        for (int i = 0; i < at.step.samples; ++i) {
            const Draw draw(number(), number(), number(), 0.0), start(number(), number(), 0.0, 0.0);
            double weight = 0.0;
            const int patch = scene.send(use, at.step.shooter, draw, start, weight);
            if (patch < 0) continue;
            sums[static_cast<std::size_t>(patch)] += weight;
            ++met;
        }
        const double over = use.over(at.step.samples, static_cast<double>(met) / at.step.samples) /
                            static_cast<double>(at.step.samples);
        for (std::size_t j = 0; j < sums.size(); ++j) {
            float& formFactor = outcome.state.patches[j].formF;
            formFactor = static_cast<float>(sums[j] * over) + (use.addsToLast ? formFactor : 0.0f);
        }
        return outcome;
    };
}

RayUse fromArea() {
    RayUse use;
    use.name = "from the area";
    use.fromArea = true;
    return use;
}

// Lambert's sum over the edges of a polygon that nothing hides, from a point with a normal.
double pointToPolygon(const State& state, const MyPolygon& patch, const glm::dvec3& point, const glm::dvec3& normal) {
    double sum = 0.0;
    const auto to = [&](int k) {
        const int index = patch.vertex[k % patch.vertices];
        return glm::normalize(glm::dvec3(state.corners[static_cast<std::size_t>(index)].position) - point);
    };
    for (int k = 0; k < patch.vertices; ++k) {
        const glm::dvec3 a = to(k), b = to(k + 1);
        sum += std::acos(glm::dot(a, b)) * glm::dot(normal, glm::normalize(glm::cross(a, b)));
    }
    return std::abs(sum) / (2.0 * std::acos(-1.0));
}

}  // namespace

TEST_CASE("hemisphere: what is right agrees with the closed form where nothing is hidden") {
    Random random(5);
    for (int i = 0; i < 20; ++i) {
        State state;
        const Vec3f normal = random.direction(), place = random.vector(-2, 2);
        addPatch(state, rectangle(place, normal, 0.3f, 0.2f));
        const Vec3f to = glm::normalize(normal + 0.6f * random.direction());
        addPatch(state, i % 2 ? rectangle(place + 3.0f * to, -to, 1.0f, 2.0f) : triangle(place + 2.0f * to, -to, 1, 2));
        const RayShooter shooter;
        CHECK(shooter.shares(state, 0, {})->patches[1] ==
              doctest::Approx(pointToPolygon(state, state.patches[1], glm::dvec3(place), glm::dvec3(normal)))
                  .scale(1)
                  .epsilon(7e-4));
        CHECK(shooter.shares(state, 0, {})->patches[0] == 0.0);
    }
}

TEST_CASE("hemisphere: in a closed room every ray meets a patch, from the centre and from all over") {
    Random random(6);
    const State state = room(random, 0.5f, 2);
    CHECK(RayShooter().shares(state, 0, {})->met == 1.0);
    CHECK(RayShooter().shares(state, 0, fromArea())->met > 0.9999);
}

TEST_CASE("hemisphere: random rays pass, from the centre and from all over the patch") {
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        CAPTURE(seed);
        CHECK(firstFailure(judged(*stage, seed, program({}))) == "");
        CHECK(firstFailure(judged(*stage, seed, program(fromArea()))) == "");
    }
}

TEST_CASE("hemisphere: every mistake fails and is named") {
    std::uint64_t seed = 0;
    for (const RayMistake& mistake : rayMistakes()) {
        CAPTURE(++seed);
        CAPTURE(mistake.use.name);
        CAPTURE(mistake.text);
        const StageVerdict verdict = judged(*stage, seed % 3, program(mistake.use));
        CHECK(firstFailure(verdict) != "");
        CHECK((verdict.diagnosis ? verdict.diagnosis->id : "") == mistake.id);
    }
}

TEST_CASE("hemisphere: rays that all go the same way are named") {
    RayUse one;
    one.direction = [](const Draw&) { return glm::dvec3(0.3, 0.2, 0.9); };
    const StageVerdict verdict = judged(*stage, 3, program(one));
    REQUIRE(verdict.diagnosis);
    CHECK(verdict.diagnosis->id == "one-direction");
}

TEST_CASE("hemisphere: form factors a hundredth too large are found") {
    RayUse large;
    large.over = [](int, double) { return 1.01; };
    CHECK(firstFailure(judged(*stage, 4, program(large))) != "");
}

TEST_CASE("hemisphere: what no mistake explains is told in words, and not as code that would not compile") {
    RayUse odd;
    odd.over = [](int rays, double) { return rays > 100 ? 0.6 : 0.7; };
    const StageVerdict verdict = judged(*stage, 4, program(odd));
    CHECK(firstFailure(verdict) != "");
    CHECK_FALSE(verdict.diagnosis);
    CHECK(verdict.example.empty());
}

TEST_CASE("hemisphere: texts are sentences") { checkWording(*stage); }

#include "grader/stages/StageTestHelp.h"

using namespace radlab;
using namespace radlab::grader;

namespace {

const std::unique_ptr<Stage> stage = maxenergyStage();

// The patch that gives the most, by any rule.
Computation choosing(const std::function<double(const MyPolygon&)>& value) {
    return [=](const Situation& at) {
        Outcome outcome;
        outcome.state = at.before;
        outcome.returned = -1;
        double most = -1.0;
        for (std::size_t i = 0; i < at.before.patches.size(); ++i)
            if (value(at.before.patches[i]) > most) {
                most = value(at.before.patches[i]);
                outcome.returned = static_cast<int>(i);
            }
        return outcome;
    };
}

double power(const MyPolygon& patch) { return double(length(patch.unshot_rad)) * double(patch.area); }
double radiosity(const MyPolygon& patch) { return double(length(patch.unshot_rad)); }

}  // namespace

TEST_CASE("maxenergy: the right ways pass") { checkRightWaysPass(*stage, 50); }

TEST_CASE("maxenergy: every mistake fails and is named") { checkMistakesAreNamed(*stage, 5); }

TEST_CASE("maxenergy: no two mistakes are the same") { checkMistakesDiffer(*stage, 1); }

TEST_CASE("maxenergy: texts are sentences") { checkWording(*stage); }

TEST_CASE("maxenergy: any measure of a colour passes that counts all channels") {
    for (std::uint64_t seed = 1; seed <= 50; ++seed) {
        CAPTURE(seed);
        const auto sum = [](const Vec3f& v) { return double(v.x) + double(v.y) + double(v.z); };
        const auto luminance = [](const Vec3f& v) {
            return 0.2126 * double(v.x) + 0.7152 * double(v.y) + 0.0722 * double(v.z);
        };
        for (const bool byPower : {true, false}) {
            const auto area = [=](const MyPolygon& p) { return byPower ? double(p.area) : 1.0; };
            const auto bySum = [=](const MyPolygon& p) { return sum(p.unshot_rad) * area(p); };
            const auto byLuminance = [=](const MyPolygon& p) { return luminance(p.unshot_rad) * area(p); };
            CHECK(firstFailure(judged(*stage, seed, choosing(bySum))) == "");
            CHECK(firstFailure(judged(*stage, seed, choosing(byLuminance))) == "");
        }
    }
}

TEST_CASE("maxenergy: one rule must hold throughout") {
    const Computation mixed = [](const Situation& at) {
        return choosing(at.before.patches.size() % 2 ? power : radiosity)(at);
    };
    for (std::uint64_t seed = 1; seed <= 20; ++seed) CHECK(firstFailure(judged(*stage, seed, mixed)) != "");
}

TEST_CASE("maxenergy: in the dark any patch is right, and nullptr, too") {
    for (const int answer : {-1, 0}) {
        const Computation way = [=](const Situation& at) {
            Outcome outcome = choosing(power)(at);
            const bool dark = outcome.returned >= 0 && power(at.before.patches[outcome.returned]) == 0.0;
            if (dark) outcome.returned = answer;
            return outcome;
        };
        CHECK(firstFailure(judged(*stage, 1, way)) == "");
    }
}

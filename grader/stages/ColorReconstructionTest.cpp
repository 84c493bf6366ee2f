#include "grader/stages/Manifest.h"
#include "grader/stages/StageTestHelp.h"

using namespace radlab;
using namespace radlab::grader;

namespace {

const std::unique_ptr<Stage> stage = colorStage();

// The right way in single precision; vertices by means of rad · 1/π.
Computation reconstructing(double inversePi) {
    return [inversePi](const Situation& at) {
        Outcome outcome;
        outcome.state = at.before;
        for (MyVertex& vertex : outcome.state.corners) {
            vertex.rad = Vec3f(0.0f);
            vertex.colorcount = 0;
        }
        for (MyPolygon& patch : outcome.state.patches) {
            patch.color = patch.rad * inversePi;
            for (int i = 0; i < patch.vertices; ++i) {
                MyVertex& vertex = outcome.state.corners[static_cast<std::size_t>(patch.vertex[i])];
                vertex.rad += patch.rad;
                ++vertex.colorcount;
            }
        }
        for (MyVertex& vertex : outcome.state.corners) {
            if (vertex.colorcount > 0) vertex.rad /= static_cast<float>(vertex.colorcount);
            vertex.color = vertex.rad * inversePi;
        }
        return outcome;
    };
}

using Ids = std::vector<std::string>;

Ids failedBy(const std::string& id) {
    for (const Mistake& mistake : stage->mistakes())
        if (mistake.id == id) return failedChecks(*stage, 1, mistake.computation);
    return {"no such mistake: " + id};
}

}  // namespace

TEST_CASE("color: the right way passes") { checkRightWaysPass(*stage, 50); }

TEST_CASE("color: π to four digits passes, in floats, and π to three does not") {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        CAPTURE(seed);
        for (const double inversePi : {1 / 3.1416, 1 / 3.1415, 1 / 3.142, 0.3183, 0.318310})
            CHECK(firstFailure(judged(*stage, seed, reconstructing(inversePi))) == "");
        for (const double inversePi : {1 / 3.14, 0.318})
            CHECK(firstFailure(judged(*stage, seed, reconstructing(inversePi))) != "");
    }
}

TEST_CASE("color: every mistake fails and is named") { checkMistakesAreNamed(*stage, 5); }

TEST_CASE("color: no two mistakes are the same") { checkMistakesDiffer(*stage, 1); }

TEST_CASE("color: texts are sentences") { checkWording(*stage); }

TEST_CASE("color: one mistake costs its own marks") {
    const Ids nodal = {"color.nodal", "color.again", "color.orphan", "color.corners", "color.rad", "color.count"};
    CHECK(failedBy("vertices-untouched") == nodal);
    CHECK(failedBy("rad-missing") == Ids{"color.rad"});
    CHECK(failedBy("count-missing") == Ids{"color.count"});
    CHECK(failedBy("orphans-left-stale") == Ids{"color.orphan", "color.rad", "color.count"});
    CHECK(failedBy("color-not-reset") == Ids{"color.again", "color.orphan"});
    CHECK(failedBy("triangles-as-quads") == Ids{"color.corners"});
    CHECK(failedBy("clamped") == Ids{"color.range", "color.nodal"});
    CHECK(failedBy("patch-color-missing") == Ids{"color.flat", "color.range", "color.repeat"});
}

TEST_CASE("color: flat shading alone earns 5 marks of 15") {
    const Ids failed = failedBy("vertices-untouched");
    const Manifest manifest = readManifest(manifestFile());
    double earned = 0.0;
    for (const ManifestCheck& check : manifest.find("colorReconstruction").checks)
        if (check.references.empty() && std::find(failed.begin(), failed.end(), check.id) == failed.end())
            earned += check.marks;
    CHECK(earned == 5.0);
}

#include "grader/stages/AnalyticalCases.h"

#include <algorithm>
#include <cmath>

#include "grader/stages/Meshes.h"
#include "grader/stages/PairFormula.h"

namespace radlab::grader {

namespace {

Step shotFrom(int shooter, State state) {
    for (MyPolygon& patch : state.patches) patch.unshot_rad *= 1e-4f;  // the brightest by far, whoever looks
    if (shooter >= 0) state.patches[static_cast<std::size_t>(shooter)].unshot_rad = Vec3f(500.0f, 400.0f, 300.0f);
    Step step;
    step.function = "calcAnalyticalFF";
    step.state = std::move(state);
    step.shooter = shooter;
    step.wanted = {"patch.formF"};
    return step;
}

Step nextShot(int shooter, std::size_t patches) {
    Step step;
    step.function = "calcAnalyticalFF";
    step.unshot.assign(patches, Vec3f(1e-4f));
    step.unshot[static_cast<std::size_t>(shooter)] = Vec3f(500.0f, 400.0f, 300.0f);
    step.shooter = shooter;
    step.wanted = {"patch.formF"};
    return step;
}

Case oneShot(const std::string& what, int shooter, State state) {
    return {what, {shotFrom(shooter, std::move(state))}};
}

// A shooter and a receiver, in the order of the seed; returns the shooter's index.
int twoPatches(Random& random, State& state, const std::vector<Vec3f>& shooter, const std::vector<Vec3f>& receiver) {
    const bool first = random.index(2) == 0;
    addPatch(state, first ? shooter : receiver);
    addPatch(state, first ? receiver : shooter);
    randomLight(random, state);
    return first ? 0 : 1;
}

// In round numbers, so that the first case that fails for most mistakes is read at a glance.
Case simplest(Random& random) {
    State state;
    const auto edge = [&] { return 0.5f * static_cast<float>(1 + random.index(3)); };
    addPatch(state, rectangle(Vec3f(0.0f), Vec3f(0, 0, 1), edge(), edge()));
    addPatch(state, rectangle(Vec3f(0, 0, 2), Vec3f(0, 0, -1), edge(), edge()));
    Case asked = oneShot("two facing patches, 2 apart", 0, std::move(state));
    for (MyPolygon& patch : asked.steps[0].state->patches) patch.formF = 0.125f;
    return asked;
}

Case facing(Random& random, double distance) {
    State state;
    const Vec3f place = random.vector(-2, 2), normal = random.direction();
    const auto edge = [&] { return static_cast<float>(distance * random.between(0.2, 0.8)); };
    const Vec3f opposite = place + static_cast<float>(distance) * normal;
    const int shooter = twoPatches(random, state, rectangle(place, normal, edge(), edge()),
                                   rectangle(opposite, -normal, edge(), edge()));
    return oneShot("two facing patches", shooter, std::move(state));
}

// A unit vector at the given angle to another one.
Vec3f turned(Random& random, const Vec3f& axis, double angle) {
    const glm::dvec3 aside = glm::normalize(glm::cross(glm::dvec3(axis), glm::dvec3(random.direction())));
    return Vec3f(glm::normalize(std::cos(angle) * glm::dvec3(axis) + std::sin(angle) * aside));
}

Case tilted(Random& random, const std::string& what, double shooterAngle, double receiverAngle) {
    State state;
    const Vec3f place = random.vector(-2, 2), direction = random.direction();
    const auto distance = static_cast<float>(random.between(1, 4));
    const auto edge = [&] { return distance * static_cast<float>(random.between(0.1, 0.6)); };
    const int shooter =
        twoPatches(random, state, triangle(place, turned(random, direction, shooterAngle), edge(), edge()),
                   rectangle(place + distance * direction, turned(random, -direction, receiverAngle), edge(), edge()));
    return oneShot(what, shooter, std::move(state));
}

std::vector<double> rowOf(const State& state, int shooter) {
    std::vector<double> row;
    for (std::size_t j = 0; j < state.patches.size(); ++j)
        if (static_cast<int>(j) != shooter)
            row.push_back(pointToPoint(pairOf(state.patches[static_cast<std::size_t>(shooter)], state.patches[j])));
    return row;
}

// Sees something, but nothing so near that the formula exceeds 1: some people cut it off there.
bool suits(const State& state, int shooter) {
    const std::vector<double> row = rowOf(state, shooter);
    return std::count_if(row.begin(), row.end(), [](double f) { return f > 0.0; }) > 1 &&
           std::all_of(row.begin(), row.end(), [](double f) { return f < 0.8; });
}

Case many(Random& random, const std::string& what, int count, double scale) {
    for (;;) {
        State state = scattered(random, count);
        for (MyPolygon& patch : state.patches) {
            patch.center *= static_cast<float>(scale);
            patch.area *= static_cast<float>(scale * scale);
        }
        for (MyVertex& corner : state.corners) corner.position *= static_cast<float>(scale);
        const int shooter = random.index(state.patches.size());
        if (suits(state, shooter)) return oneShot(what, shooter, std::move(state));
    }
}

Case backToBack(Random& random, int shooter) {
    State state;
    const Vec3f place = random.vector(-2, 2), normal = random.direction();
    addPatch(state, rectangle(place, normal, 1.0f, 0.7f));
    addPatch(state, rectangle(place + 2.0f * normal, -normal, 0.5f, 0.6f));
    addPatch(state, rectangle(place, -normal, 0.7f, 1.0f));
    state.patches[2].center = state.patches[0].center;
    randomLight(random, state);
    return oneShot("a patch back to back with the shooter, at the same centre", shooter, std::move(state));
}

// The axis that a direction is nearest to.
Vec3f nearestAxis(const Vec3f& direction) {
    const Vec3f size = glm::abs(direction);
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    Vec3f nearest(0.0f);
    nearest[axis] = direction[axis] < 0.0f ? -1.0f : 1.0f;
    return nearest;
}

// In a plane through axes, where rounding lifts no patch out of it.
Case coplanar(Random& random) {
    State state;
    const Vec3f normal = nearestAxis(random.direction());
    const std::vector<Vec3f> first = rectangle(Vec3f(0.0f), normal, 1.0f, 1.0f);
    addPatch(state, first);
    addPatch(state, rectangle(first[1] - first[0], normal, 1.0f, 1.0f));
    addPatch(state, rectangle(2.0f * (first[3] - first[0]), normal, 1.0f, 1.0f));
    randomLight(random, state);
    return oneShot("patches in the plane of the shooter", 0, std::move(state));
}

Case twoShots(Random& random) {
    for (;;) {
        Case shots = many(random, "two shots, one after the other", 20, 1.0);
        const State& state = *shots.steps[0].state;
        const int next = random.index(state.patches.size());
        if (next == shots.steps[0].shooter || !suits(state, next)) continue;
        shots.steps.push_back(nextShot(next, state.patches.size()));
        return shots;
    }
}

}  // namespace

std::vector<Check> analyticalChecks(std::uint64_t seed) {
    Random random(seed);
    Check face{"ff.facing", {}}, tilt{"ff.tilted", {}}, behind{"ff.behind", {}}, scale{"ff.scale", {}};
    face.cases.push_back(simplest(random));
    for (const double distance : {1.0, 2.0, 10.0}) face.cases.push_back(facing(random, distance));
    for (int i = 0; i < 3; ++i)
        tilt.cases.push_back(tilted(random, "two tilted patches", random.between(0.3, 1.2), random.between(0.3, 1.2)));
    for (const int count : {12, 40, 300})
        tilt.cases.push_back(many(random, std::to_string(count) + " patches, turned at random", count, 1.0));
    behind.cases = {tilted(random, "a receiver behind the shooter", random.between(2.0, 2.8), 0.4),
                    tilted(random, "a receiver that looks away", 0.4, random.between(2.0, 2.8)),
                    tilted(random, "both look away", random.between(2.0, 2.8), random.between(2.0, 2.8))};
    for (const double factor : {1e-4, 1e-2, 1e2, 1e4}) {
        char what[64];
        std::snprintf(what, sizeof what, "a scene of size %g", 20 * factor);
        scale.cases.push_back(many(random, what, 20, factor));
    }
    const Check self{"ff.self", {many(random, "the shooter among others", 30, 1.0), coplanar(random)}};
    const Check coincident{"ff.coincident", {backToBack(random, 0), backToBack(random, 2)}};
    const Check stale{"ff.stale", {twoShots(random), twoShots(random)}};
    const Check empty{"ff.empty", {oneShot("no patches", -1, State{})}};
    return {face, tilt, behind, scale, self, coincident, stale, empty};
}

}  // namespace radlab::grader

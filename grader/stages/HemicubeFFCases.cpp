#include "grader/stages/HemicubeFFCases.h"

#include <array>
#include <cstdio>

#include "grader/stages/HemicubeFFScenes.h"

namespace radlab::grader {

namespace {

const Vec3f brightest(500.0f, 400.0f, 300.0f);
constexpr float dim = 1e-4f;

Step shotFrom(int shooter, int size) {
    Step step;
    step.function = "calcFF";
    step.shooter = shooter;
    step.hemicubeSize = size;
    step.wanted = {"patch.formF"};
    return step;
}

// The shooter is the brightest by far, whatever the rule, for submissions that search for themselves; but another patch has
// more rad, all of which is shot already.
Step shot(Scene scene, int size) {
    std::vector<MyPolygon>& patches = scene.state.patches;
    for (MyPolygon& patch : patches) patch.unshot_rad *= dim;
    if (scene.shooter >= 0) {
        MyPolygon& shooter = patches[static_cast<std::size_t>(scene.shooter)];
        shooter.unshot_rad = brightest;
        shooter.rad += brightest;
        (scene.shooter == 0 ? patches.back() : patches.front()).rad += 3.0f * brightest;
    }
    Step step = shotFrom(scene.shooter, size);
    step.state = std::move(scene.state);
    return step;
}

Step nextShot(int shooter, std::size_t patches, int size) {
    Step step = shotFrom(shooter, size);
    step.unshot.assign(patches, Vec3f(dim));
    step.unshot[static_cast<std::size_t>(shooter)] = brightest;
    return step;
}

std::string withSize(const std::string& what, int size) { return what + ", hemicube size " + std::to_string(size); }

// With what an earlier shot has left in formF.
Case stale(const std::string& what, Scene scene, int size) {
    return {withSize(what, size), {shot(std::move(scene), size)}};
}

Case fresh(const std::string& what, Scene scene, int size) {
    for (MyPolygon& patch : scene.state.patches) patch.formF = 0.0f;
    return stale(what, std::move(scene), size);
}

Check few(Random& random) {
    Check check{"hemi.few", {}};
    const auto add = [&](const std::string& what, int others, Place place, int size) {
        check.cases.push_back(fresh(what, around(random, random.direction(), others, place), size));
    };
    add("two patches before the first one", 2, Place::first, 32);
    add("two patches before the last one", 2, Place::last, 24);
    add("two patches, the shooter between them in the list", 2, Place::middle, 48);
    add("seven patches in the open", 7, Place::middle, 64);
    add("twelve patches in the open", 12, Place::first, 32);
    return check;
}

Check closed(Random& random) {
    Check check{"hemi.closed", {}};
    for (const int size : {8, 10, 8, 12, 8, 10})
        check.cases.push_back(fresh("an empty room, one patch a wall", emptyRoom(random), size));
    check.cases.push_back(fresh("a room with blocks", furnishedRoom(random), 32));
    check.cases.push_back(fresh("a room with blocks", furnishedRoom(random), 64));
    return check;
}

Check turned(Random& random) {
    Check check{"hemi.turned", {}};
    constexpr std::array<char, 3> axes = {'x', 'y', 'z'};
    for (int axis = 0; axis < 3; ++axis)
        for (const bool negative : {false, true}) {
            Vec3f normal(0.0f);
            normal[axis] = negative ? -1.0f : 1.0f;
            const std::string what = std::string("a shooter that looks along ") + (negative ? '-' : '+') +
                                     axes[static_cast<std::size_t>(axis)];
            check.cases.push_back(fresh(what, around(random, normal, 5, Place::middle), negative ? 16 : 20));
        }
    check.cases.push_back(
        fresh("a shooter that looks anywhere", around(random, random.direction(), 5, Place::middle), 24));
    return check;
}

Check occluded(Random& random) {
    return {"hemi.hidden",
            {fresh("patches behind others", hidden(random), 48),
             fresh("patches in the shooter's plane and at its back", coplanar(random), 32),
             fresh("patches seen from both sides",
                   around(random, random.direction(), 16, Place::middle, Turned::anyWay), 64)}};
}

Check many(Random& random) {
    Check check{"hemi.many", {}};
    const auto add = [&](int cells, int size) {
        Scene scene = among(random, cells, 20);
        const std::string what = std::to_string(scene.state.patches.size()) + " patches";
        check.cases.push_back(fresh(what, std::move(scene), size));
    };
    add(18 + random.index(10), 48);
    add(166 + random.index(3), 32);
    add(235 + random.index(3), 64);
    return check;
}

Case twoShots(Random& random, int others, bool andBack, int size) {
    int next = 0;
    Scene scene = apart(random, others, next);
    const int first = scene.shooter;
    const std::size_t count = scene.state.patches.size();
    Case shots = stale(andBack ? "three shots" : "two shots", std::move(scene), size);
    shots.steps.push_back(nextShot(next, count, size));
    if (andBack) shots.steps.push_back(nextShot(first, count, size));
    return shots;
}

Check again(Random& random) {
    return {"hemi.again",
            {stale("form factors of an earlier shot", around(random, random.direction(), 10, Place::middle), 24),
             twoShots(random, 6, false, 32), twoShots(random, 10, true, 24)}};
}

Check scale(Random& random) {
    Check check{"hemi.scale", {}};
    int size = 24;
    for (const float factor : {1e-4f, 1e-2f, 1e2f, 1e4f}) {
        char what[64];
        std::snprintf(what, sizeof what, "a scene of size %g", 6.0 * static_cast<double>(factor));
        Scene scene = around(random, random.direction(), 8, Place::middle);
        check.cases.push_back(fresh(what, scaled(std::move(scene), factor), size));
        size = size == 24 ? 32 : 24;
    }
    return check;
}

Check none(Random&) { return {"hemi.empty", {fresh("no patches", {State{}, -1}, 16)}}; }

}  // namespace

std::vector<Check> hemicubeChecks(std::uint64_t seed) {
    Random random(seed);
    std::vector<Check> checks;
    for (const auto& check : {few, closed, turned, occluded, many, again, scale, none}) checks.push_back(check(random));
    return checks;
}

}  // namespace radlab::grader

#include "grader/stages/HemicubeFFCases.h"

#include <array>
#include <cmath>
#include <cstdio>

#include <glm/gtc/constants.hpp>

#include "grader/stages/ManyPatches.h"

namespace radlab::grader {

namespace {

const Vec3f brightest(500.0f, 400.0f, 300.0f);
constexpr float dim = 1e-4f;

// A state and the patch in it that is to shoot.
struct Scene {
    State state;
    int shooter = 0;
};

// The shooter is the brightest by far, whatever the rule, for submissions that search for themselves.
Step shot(Scene scene, int size) {
    for (MyPolygon& patch : scene.state.patches) patch.unshot_rad *= dim;
    if (scene.shooter >= 0) scene.state.patches[static_cast<std::size_t>(scene.shooter)].unshot_rad = brightest;
    Step step;
    step.function = "calcFF";
    step.state = std::move(scene.state);
    step.shooter = scene.shooter;
    step.hemicubeSize = size;
    step.wanted = {"patch.formF"};
    return step;
}

Step nextShot(int shooter, std::size_t patches, int size) {
    Step step;
    step.function = "calcFF";
    step.unshot.assign(patches, Vec3f(dim));
    step.unshot[static_cast<std::size_t>(shooter)] = brightest;
    step.shooter = shooter;
    step.hemicubeSize = size;
    step.wanted = {"patch.formF"};
    return step;
}

// Nothing is left in formF from an earlier shot.
Case fresh(const std::string& what, Scene scene, int size) {
    for (MyPolygon& patch : scene.state.patches) patch.formF = 0.0f;
    return {what + ", hemicube size " + std::to_string(size), {shot(std::move(scene), size)}};
}

Case stale(const std::string& what, Scene scene, int size) {
    return {what + ", hemicube size " + std::to_string(size), {shot(std::move(scene), size)}};
}

void addAny(Random& random, State& state, const Vec3f& center, const Vec3f& normal, double smallest, double largest) {
    const auto width = static_cast<float>(random.between(smallest, largest)),
               height = static_cast<float>(random.between(smallest, largest)),
               turn = static_cast<float>(random.between(0, 6));
    addPatch(state, random.index(2) ? rectangle(center, normal, width, height, turn)
                                    : triangle(center, normal, width, height, turn));
}

// Directions round a normal.
class Hemisphere {
public:
    explicit Hemisphere(const Vec3f& around)
        : normal(around),
          right(
              glm::normalize(glm::cross(normal, std::abs(normal.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0)))),
          up(glm::cross(normal, right)) {}

    glm::dvec3 direction(double angle, double azimuth) const {
        return std::cos(angle) * normal + std::sin(angle) * (std::cos(azimuth) * right + std::sin(azimuth) * up);
    }

private:
    glm::dvec3 normal, right, up;
};

// How patches that surround a shooter are turned.
enum class Turned { toShooter, anyWay };

// Adds a patch before the shooter at the given distance; half a turn lies between the first two, so that both are seen.
void addAround(Random& random, State& state, const Vec3f& place, const Hemisphere& hemisphere, int k, Turned turned) {
    const bool near = k < 2;
    const double azimuth = near ? k * glm::pi<double>() : random.between(0, glm::two_pi<double>()),
                 angle = near ? random.between(0.45, 0.7) : random.between(0.0, 1.4),
                 distance = near ? random.between(0.8, 1.0) : random.between(1.6, 3.0);
    const glm::dvec3 direction = hemisphere.direction(angle, azimuth);
    glm::dvec3 normal = -direction;
    if (turned == Turned::anyWay)
        normal = random.direction();
    else
        normal = glm::normalize(normal + 0.6 * glm::dvec3(random.direction()));
    addAny(random, state, Vec3f(glm::dvec3(place) + distance * direction), Vec3f(normal), near ? 0.3 : 0.5,
           near ? 0.5 : 1.2);
}

enum class Place { first, middle, last };

// A shooter and patches before it; the first and the last one of these are near and in full view.
Scene around(Random& random, const Vec3f& normal, int others, Place place, Turned turned = Turned::toShooter) {
    Scene scene;
    const Vec3f position = random.vector(-2, 2);
    const Hemisphere hemisphere(normal);
    const int before = place == Place::first  ? 0
                       : place == Place::last ? others
                                              : 1 + random.index(static_cast<std::size_t>(others - 1));
    const auto add = [&](int from, int to) {
        for (int i = from; i < to; ++i)
            addAround(random, scene.state, position, hemisphere, i == 0 ? 0 : i == others - 1 ? 1 : 2, turned);
    };
    add(0, before);
    scene.shooter = before;
    addAny(random, scene.state, position, normal, 0.3, 0.6);
    scene.state.patches.back().normal = normal;
    add(before, others);
    randomLight(random, scene.state);
    return scene;
}

Scene inRoom(Random& random, float patchSize, int blocks) {
    Scene scene{room(random, patchSize, blocks), 0};
    scene.shooter = random.index(scene.state.patches.size());
    return scene;
}

Scene scaled(Scene scene, float factor) {
    for (MyVertex& corner : scene.state.corners) corner.position *= factor;
    for (MyPolygon& patch : scene.state.patches) {
        patch.center *= factor;
        patch.area *= factor * factor;
    }
    return scene;
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
        check.cases.push_back(fresh("an empty room, one patch a wall", inRoom(random, 3.0f, 0), size));
    check.cases.push_back(fresh("a room with blocks", inRoom(random, 0.45f, 2), 32));
    check.cases.push_back(fresh("a room with blocks", inRoom(random, 0.25f, 1), 64));
    return check;
}

Check turned(Random& random) {
    Check check{"hemi.turned", {}};
    const std::array<const char*, 3> axes = {"x", "y", "z"};
    for (int axis = 0; axis < 3; ++axis)
        for (const bool negative : {false, true}) {
            Vec3f normal(0.0f);
            normal[axis] = negative ? -1.0f : 1.0f;
            const std::string what = std::string("a shooter that looks along ") + (negative ? "-" : "+") +
                                     axes[static_cast<std::size_t>(axis)];
            check.cases.push_back(fresh(what, around(random, normal, 5, Place::middle), negative ? 16 : 20));
        }
    check.cases.push_back(
        fresh("a shooter that looks anywhere", around(random, random.direction(), 5, Place::middle), 24));
    return check;
}

// A wall close before the shooter's right half hides most of what lies behind it.
Scene hidden(Random& random) {
    const Vec3f normal = random.direction();
    Scene scene = around(random, normal, 6, Place::middle);
    const MyPolygon shooter = scene.state.patches[static_cast<std::size_t>(scene.shooter)];
    const glm::dvec3 aside = Hemisphere(normal).direction(glm::half_pi<double>(), 0.0), front(normal),
                     middle(shooter.center);
    for (const double distance : {0.4, 0.9, 1.4})
        addPatch(scene.state, rectangle(Vec3f(middle + distance * front + 0.3 * aside), -normal, 0.5f, 0.6f));
    randomLight(random, scene.state);
    return scene;
}

// Some lie in the shooter's plane, one is its back, and one stands on the plane and touches it.
Scene coplanar(Random& random) {
    const Vec3f normal = random.direction();
    State state;
    const std::vector<Vec3f> own = rectangle(random.vector(-1, 1), normal, 1.0f, 1.0f);
    const Vec3f right = own[1] - own[0], up = own[3] - own[0];
    const auto moved = [&](const Vec3f& by) {
        std::vector<Vec3f> corners = own;
        for (Vec3f& corner : corners) corner += by;
        return corners;
    };
    addPatch(state, moved(right));
    addPatch(state, own);
    addPatch(state, {own[3], own[2], own[1], own[0]});
    addPatch(state, moved(up));
    addPatch(state, {own[3], own[2], own[2] + normal, own[3] + normal});
    addPatch(state, {own[1] + normal, own[0] + normal, own[0] + 0.2f * right + 1.5f * normal});
    randomLight(random, state);
    return {std::move(state), 1};
}

Check occluded(Random& random) {
    return {"hemi.hidden",
            {fresh("patches behind others", hidden(random), 48),
             fresh("patches in the shooter's plane, at its back and at its edge", coplanar(random), 32),
             fresh("patches seen from both sides",
                   around(random, random.direction(), 16, Place::middle, Turned::anyWay), 64)}};
}

// Large patches round a shooter among many small ones, which are the cells of a wall behind them.
Scene among(Random& random, int cells, int large) {
    Scene scene = around(random, Vec3f(0.0f, 0.0f, -1.0f), large, Place::first);
    const Vec3f place = scene.state.patches[0].center;
    State small = wall(random, cells);
    for (MyPolygon& patch : small.patches) {
        patch.center = 3.0f * patch.center + place - Vec3f(0.0f, 0.0f, 3.5f);
        patch.area *= 9.0f;
    }
    for (MyVertex& corner : small.corners) corner.position = 3.0f * corner.position + place - Vec3f(0.0f, 0.0f, 3.5f);
    append(scene.state, small);
    randomLight(random, scene.state);

    // The large ones are spread over the list, with some at its very end.
    std::vector<MyPolygon>& patches = scene.state.patches;
    const std::size_t count = patches.size(), last = count - 1;
    for (int k = large; k >= 1; --k) {
        const std::size_t other =
            k > large - 6
                ? last - static_cast<std::size_t>(31 * (large - k))
                : static_cast<std::size_t>(large + random.index(count - static_cast<std::size_t>(large) - 200));
        std::swap(patches[static_cast<std::size_t>(k)], patches[other]);
    }
    scene.shooter = random.index(count);
    std::swap(patches[0], patches[static_cast<std::size_t>(scene.shooter)]);
    return scene;
}

Check many(Random& random) {
    Check check{"hemi.many", {}};
    const auto add = [&](int cells, int large, int size) {
        Scene scene = among(random, cells, large);
        const std::string what = std::to_string(scene.state.patches.size()) + " patches";
        check.cases.push_back(fresh(what, std::move(scene), size));
    };
    add(18 + random.index(10), 20, 48);
    add(166 + random.index(3), 24, 32);
    add(235 + random.index(3), 24, 64);
    return check;
}

Case twoShots(Random& random, const std::string& what, Scene scene, int size) {
    const std::size_t count = scene.state.patches.size();
    const int first = scene.shooter;
    Case shots = stale(what, std::move(scene), size);
    int next = first;
    while (next == first) next = random.index(count);
    shots.steps.push_back(nextShot(next, count, size));
    return shots;
}

Check again(Random& random) {
    return {"hemi.again",
            {stale("form factors of an earlier shot", around(random, random.direction(), 10, Place::middle), 24),
             twoShots(random, "two shots in a room", inRoom(random, 0.6f, 1), 32),
             twoShots(random, "two shots in the open",
                      around(random, random.direction(), 12, Place::middle, Turned::anyWay), 24)}};
}

Check scale(Random& random) {
    Check check{"hemi.scale", {}};
    int size = 24;
    for (const float factor : {1e-4f, 1e-2f, 1e2f, 1e4f}) {
        char what[64];
        std::snprintf(what, sizeof what, "a scene of size %g", 6.0 * static_cast<double>(factor));
        Scene scene = factor < 1.0f ? inRoom(random, 0.7f, 1) : around(random, random.direction(), 8, Place::middle);
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

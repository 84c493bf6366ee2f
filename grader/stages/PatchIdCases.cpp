#include "grader/stages/PatchIdCases.h"

#include <cmath>

#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "grader/stages/ManyPatches.h"

namespace radlab::grader {

namespace {

enum class Shape { quads, triangles, both };

// All scenes lie in a ball of this radius round the origin.
constexpr double sceneRadius = 1.75;

// How far from the z axis a camera stands, in radians.
struct Tilt {
    double least = 0.1, most = 0.4;
};

// With the camera's up anywhere.
glm::dmat4 camera(Random& random, double distance, const Tilt& from = {}) {
    const double tilt = random.between(from.least, from.most), turn = random.between(0, glm::two_pi<double>()),
                 roll = random.between(0, glm::two_pi<double>());
    const glm::dvec3 eye =
        distance * glm::dvec3(std::sin(tilt) * std::cos(turn), std::sin(tilt) * std::sin(turn), std::cos(tilt));
    return glm::lookAt(eye, glm::dvec3(0.0), glm::dvec3(std::cos(roll), std::sin(roll), 0.0));
}

glm::mat4 perspective(Random& random) {
    const double distance = random.between(4, 6), spread = 2.0 * std::asin(sceneRadius / distance);
    return glm::mat4(glm::perspective(spread, 1.0, distance - sceneRadius, distance + sceneRadius) *
                     camera(random, distance));
}

glm::mat4 orthographic(Random& random, const Tilt& from = {}) {
    const double r = sceneRadius;
    return glm::mat4(glm::ortho(-r, r, -r, r, 0.5, 0.5 + 2.0 * r) * camera(random, 0.5 + r, from));
}

Step picture(State state, const glm::mat4& view, int size) {
    Step step;
    step.function = "renderPatchIDs";
    step.state = std::move(state);
    step.view = view;
    step.width = step.height = size;
    return step;
}

bool drawsTriangle(Random& random, Shape shape) {
    return shape == Shape::triangles || (shape == Shape::both && random.index(2) == 0);
}

// Patches side by side, none before another; with backs, about half of them are seen from behind.
State tiles(Random& random, int columns, int rows, Shape shape, bool backs = false) {
    State state;
    const auto cell = static_cast<float>(2.0 / std::max(columns, rows));
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            const auto x = static_cast<float>(column) - 0.5f * static_cast<float>(columns - 1),
                       y = static_cast<float>(row) - 0.5f * static_cast<float>(rows - 1);
            const auto edge = [&] { return cell * static_cast<float>(random.between(0.4, 0.65)); };
            const Vec3f center(cell * x, cell * y, 0.0f), normal(0.0f, 0.0f, backs && random.index(2) ? -1.0f : 1.0f);
            const auto turn = static_cast<float>(random.between(0, 6));
            const float width = edge(), height = edge();
            addPatch(state, drawsTriangle(random, shape) ? triangle(center, normal, width, height, turn)
                                                         : rectangle(center, normal, width, height, turn));
        }
    shuffle(random, state);
    randomLight(random, state);
    return state;
}

// Patches before and behind each other, in any order; up to `tilt` away from the z axis. The first and the last one
// are before all others.
State heap(Random& random, int count, double tilt, double smallest, double largest) {
    State state;
    const auto addTop = [&](float x) {
        const auto turn = static_cast<float>(random.between(0, 6));
        addPatch(state, rectangle(Vec3f(x, 0.0f, 1.35f), Vec3f(0.0f, 0.0f, 1.0f), 0.4f, 0.4f, turn));
    };
    addTop(-0.45f);
    for (int i = 2; i < count; ++i) {
        const double angle = random.between(0, tilt), around = random.between(0, glm::two_pi<double>());
        const Vec3f normal(
            glm::dvec3(std::sin(angle) * std::cos(around), std::sin(angle) * std::sin(around), std::cos(angle)));
        const auto width = static_cast<float>(random.between(smallest, largest)),
                   height = static_cast<float>(random.between(smallest, largest)),
                   turn = static_cast<float>(random.between(0, 6));
        const Vec3f center = random.vector(-0.55, 0.55);
        addPatch(state, drawsTriangle(random, Shape::both) ? triangle(center, normal, width, height, turn)
                                                           : rectangle(center, normal, width, height, turn));
    }
    addTop(0.45f);
    randomLight(random, state);
    return state;
}

State shuffledWall(Random& random, int cells) {
    State state = wall(random, cells);
    shuffle(random, state);
    randomLight(random, state);
    return state;
}

// Adds the backs of the first patches, in the same places.
void addBacks(State& state, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
        MyPolygon back = state.patches[i];
        std::reverse(back.vertex, back.vertex + back.vertices);
        back.normal = -back.normal;
        state.patches.push_back(back);
    }
}

Case one(const std::string& what, State state, const glm::mat4& view, int size) {
    return {what, {picture(std::move(state), view, size)}};
}

Case counted(State state, const glm::mat4& view, int size) {
    const std::string what = std::to_string(state.patches.size()) + " patches";
    return one(what, std::move(state), view, size);
}

Check few(Random& random) {
    const int middle = random.index(3);
    return {"ids.few",
            {one("a single patch", tiles(random, 1, 1, Shape::quads), perspective(random), 64),
             one("6 quadrilaterals side by side", tiles(random, 3, 2, Shape::quads), orthographic(random), 96),
             one("quadrilaterals side by side", tiles(random, 5, 3 + middle, Shape::quads), perspective(random), 128)}};
}

Check kinds(Random& random) {
    return {"ids.kinds",
            {one("12 triangles side by side", tiles(random, 4, 3, Shape::triangles), perspective(random), 112),
             one("triangles and quadrilaterals", tiles(random, 6, 5, Shape::both), orthographic(random), 128),
             one("triangles and quadrilaterals", tiles(random, 4, 4, Shape::both), perspective(random), 96)}};
}

Check middleByte(Random& random) {
    return {"ids.middle",
            {counted(tiles(random, 21, 20 + random.index(4), Shape::both), orthographic(random), 160),
             counted(tiles(random, 36, 34 + random.index(6), Shape::both), perspective(random), 256)}};
}

Check highByte(Random& random) {
    return {"ids.many",
            {counted(shuffledWall(random, 166 + random.index(3)), perspective(random), 320),
             counted(shuffledWall(random, 235 + random.index(3)),
                     random.index(2) ? perspective(random) : orthographic(random), 512)}};
}

Check depth(Random& random) {
    const std::string what = "patches before and behind each other";
    return {"ids.depth",
            {one(what, heap(random, 50, 0.7, 0.4, 1.0), perspective(random), 160),
             one(what, heap(random, 80, 0.7, 0.3, 1.0), orthographic(random), 192)}};
}

Check backs(Random& random) {
    State heaped = heap(random, 60, glm::pi<double>(), 0.3, 1.0);
    addBacks(heaped, 8);
    const Tilt aslant{0.9, 1.2};  // so that a patch's side on screen is not that of its normal along the z axis
    return {"ids.backs",
            {one("patches seen from both sides", tiles(random, 5, 4, Shape::both, true), perspective(random), 128),
             one("patches turned at random, some back to back", std::move(heaped), orthographic(random, aslant), 192)}};
}

Check again(Random& random) {
    Case twice = one("two pictures of the same patches", tiles(random, 4, 3, Shape::both), perspective(random), 96);
    twice.steps.push_back(twice.steps[0]);
    twice.steps[1].state.reset();
    twice.steps[1].view = orthographic(random);
    return {"ids.again",
            {twice, one("other patches", heap(random, 20, 0.7, 0.4, 1.0), perspective(random), 96),
             one("no patches", State{}, orthographic(random), 32)}};
}

}  // namespace

std::vector<Check> patchIdChecks(std::uint64_t seed) {
    Random random(seed);
    std::vector<Check> checks;
    for (const auto& check : {few, kinds, middleByte, highByte, depth, backs, again}) checks.push_back(check(random));
    return checks;
}

}  // namespace radlab::grader

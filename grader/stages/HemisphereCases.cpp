#include "grader/stages/HemisphereCases.h"

#include <cmath>

#include "grader/stages/Meshes.h"

namespace radlab::grader {

namespace {

constexpr int manyRays = 65536;  // a power of two: sums of its inverse are exact
constexpr Vec3f bright(500.0f, 400.0f, 300.0f), dim(1e-4f);
const Vec3f zAxis(0.0f, 0.0f, 1.0f);

Step shot(Random& random, int shooter, std::size_t patches, int rays) {
    Step step;
    step.function = "hemisphereFF";
    step.unshot.assign(patches, dim);
    if (shooter >= 0) step.unshot[static_cast<std::size_t>(shooter)] = bright;
    step.shooter = shooter;
    step.samples = rays;
    step.seed = static_cast<std::uint64_t>(random.between(1, 1e15));
    step.wanted = {"patch.formF"};
    return step;
}

Case oneShot(Random& random, const std::string& what, int shooter, State state, int rays) {
    Step step = shot(random, shooter, state.patches.size(), rays);
    step.state = std::move(state);
    return {what + ", " + std::to_string(rays) + (rays == 1 ? " ray" : " rays"), {step}};
}

int facing(const State& state, const Vec3f& direction) {
    for (std::size_t i = 0; i < state.patches.size(); ++i)
        if (glm::dot(state.patches[i].normal, direction) > 0.999f) return static_cast<int>(i);
    return 0;
}

// A shooter in the middle of the plane z = 0, and patches of all heights around and over it: straight above, aslant,
// near the horizon.
State openScene(Random& random) {
    State state;
    addPatch(state, rectangle(Vec3f(0.0f), zAxis, 0.5f, 0.5f));
    for (const float height : {0.15f, 0.5f, 1.2f, 3.0f}) {
        const float turn = static_cast<float>(random.between(0, 6.28)),
                    size = static_cast<float>(random.between(1, 1.6));
        const Vec3f to = glm::normalize(Vec3f(std::cos(turn), std::sin(turn), height));
        addPatch(state, rectangle(2.0f * to, -to, size, 0.7f * size, static_cast<float>(random.between(0, 6))));
    }
    randomLight(random, state);
    return state;
}

// Few large patches: the six sides of a box, with the origin in the middle of the floor.
State smallRoom(Random& random) {
    State state;
    const Vec3f half = random.vector(1, 2);
    for (const std::vector<Vec3f>& side : sidesOfBox(Vec3f(-half.x, -half.y, 0.0f), half, true)) addPatch(state, side);
    randomLight(random, state);
    shuffle(random, state);
    return state;
}

// From the floor.
Case inRoom(Random& random, State state, int rays) {
    const int floor = facing(state, zAxis);
    return oneShot(random, "a closed room", floor, std::move(state), rays);
}

// A screen over a part of the shooter's sky, with patches behind it.
State screened(Random& random) {
    State state = openScene(random);
    for (const float height : {1.0f, 2.5f})
        addPatch(state, rectangle(Vec3f(random.vector(-0.3, 0.3)) * Vec3f(1, 1, 0) + height * zAxis,
                                  height < 2.0f ? zAxis : -zAxis, height, 0.8f * height));
    randomLight(random, state);
    return state;
}

State turned(Random& random, const Vec3f& normal) {
    State state;
    const Vec3f place = random.vector(-2, 2);
    addPatch(state, rectangle(place, normal, 0.4f, 0.6f, static_cast<float>(random.between(0, 6))));
    for (int i = 0; i < 5; ++i) {
        const Vec3f side = random.direction(), to = glm::normalize(normal + 0.9f * side);
        addPatch(state, rectangle(place + static_cast<float>(1 + i) * to, -to, 0.5f * static_cast<float>(1 + i),
                                  0.7f * static_cast<float>(1 + i)));
    }
    randomLight(random, state);
    return state;
}

Check share(Random& random) {
    Check check{"rays.share", {}};
    for (const int rays : {1, 8, 100, fewRays}) check.cases.push_back(inRoom(random, smallRoom(random), rays));
    check.cases.push_back(oneShot(random, "an open scene", 0, openScene(random), 100));
    return check;
}

Check density(Random& random) {
    Check check{"rays.density", {}};
    check.cases.push_back(inRoom(random, smallRoom(random), manyRays));
    for (int i = 0; i < 2; ++i) check.cases.push_back(oneShot(random, "an open scene", 0, openScene(random), manyRays));
    check.cases.push_back(oneShot(random, "an open scene", 0, openScene(random), 10000));
    return check;
}

Check turnedShooters(Random& random) {
    Check check{"rays.turned", {}};
    for (int axis = 0; axis < 3; ++axis)
        for (const float sign : {1.0f, -1.0f}) {
            Vec3f normal(0.0f);
            normal[axis] = sign;
            check.cases.push_back(oneShot(random, "a shooter along an axis", 0, turned(random, normal), manyRays / 4));
        }
    for (int i = 0; i < 4; ++i)
        check.cases.push_back(
            oneShot(random, "a shooter turned at random", 0, turned(random, random.direction()), manyRays));
    return check;
}

Check closed(Random& random) {
    Check check{"rays.closed", {}};
    for (const int blocks : {0, 2}) {
        State state = room(random, 0.6f, blocks);
        shuffle(random, state);
        check.cases.push_back(inRoom(random, std::move(state), manyRays));
    }
    return check;
}

Check hidden(Random& random) {
    Check check{"rays.hidden", {}};
    for (int i = 0; i < 2; ++i)
        check.cases.push_back(oneShot(random, "a screen in between", 0, screened(random), manyRays));
    return check;
}

Check again(Random& random) {
    Check check{"rays.again", {}};
    Case twice = inRoom(random, smallRoom(random), manyRays / 2);
    twice.steps.push_back(shot(random, facing(*twice.steps[0].state, zAxis), twice.steps[0].unshot.size(), 64));
    check.cases.push_back(std::move(twice));
    check.cases.push_back(oneShot(random, "no patches", -1, {}, 10));
    return check;
}

}  // namespace

std::vector<Check> hemisphereChecks(std::uint64_t seed) {
    Random random(seed);
    return {share(random), density(random), turnedShooters(random), closed(random), hidden(random), again(random)};
}

}  // namespace radlab::grader

#include "grader/stages/AntiAliasCases.h"

#include "grader/stages/Meshes.h"

namespace radlab::grader {

namespace {

// Looks straight at a picture whose pixels are squares of edge 1 of the plane z = 0, x to the right and y down.
glm::mat4 straightAt(int width, int height) {
    glm::mat4 view(1.0f);
    view[0][0] = 2.0f / static_cast<float>(width);
    view[1][1] = -2.0f / static_cast<float>(height);
    view[2][2] = 0.01f;
    view[3] = glm::vec4(-1.0f, 1.0f, 0.0f, 1.0f);
    return view;
}

Step drawn(State state, int width, int height, int samples) {
    Step step;
    step.function = "antialias";
    step.state = std::move(state);
    step.view = straightAt(width, height);
    step.width = width;
    step.height = height;
    step.samples = samples;
    step.inFloats = true;
    return step;
}

Case picture(const std::string& what, State state, int width, int height, int samples) {
    return {what + ", " + std::to_string(samples) + " x " + std::to_string(samples) + " samples a pixel",
            {drawn(std::move(state), width, height, samples)}};
}

const Vec3f towards(0.0f, 0.0f, -1.0f);

// Patches of random sizes and places, turned at random in the picture's plane, one behind the other.
State crowd(Random& random, int width, int height, int count, double brightest) {
    State state;
    for (int i = 0; i < count; ++i) {
        const Vec3f center(random.between(0, width), random.between(0, height), 2.0f + static_cast<float>(i));
        const auto edge = [&] { return static_cast<float>(random.between(0.2, 0.7) * height); };
        const float turn = static_cast<float>(random.between(0, 6));
        addPatch(state, i % 3 ? rectangle(center, towards, edge(), edge(), turn)
                              : triangle(center, towards, 1.5f * edge(), 1.5f * edge(), turn));
    }
    randomLight(random, state);
    for (MyPolygon& patch : state.patches) patch.color = random.vector(0.05, brightest);
    return state;
}

// One half dark, the other lit: an edge of any slope through the middle.
State halves(Random& random, int width, int height, double bright) {
    State state;
    const float size = 4.0f * static_cast<float>(width + height), turn = static_cast<float>(random.between(0, 6.28));
    const Vec3f middle(0.5f * static_cast<float>(width), 0.5f * static_cast<float>(height), 2.0f),
        side(std::cos(turn), std::sin(turn), 0.0f);
    std::vector<Vec3f> corners;
    const Vec3f along(-side.y, side.x, 0.0f);
    for (const Vec3f& corner :
         {middle - size * along, middle + size * along, middle + size * (along + side), middle + size * (side - along)})
        corners.push_back(corner);
    addPatch(state, corners);
    randomLight(random, state);
    state.patches[0].color = Vec3f(static_cast<float>(bright)) * random.vector(0.7, 1.0);
    return state;
}

Check one(Random& random) {
    return {"aa.one",
            {picture("patches", crowd(random, 24, 16, 6, 0.9), 24, 16, 1),
             picture("an edge", halves(random, 9, 9, 0.9), 9, 9, 1)}};
}

Check edge(Random& random) {
    Check check{"aa.edge", {}};
    for (const int samples : {2, 4, 5})
        check.cases.push_back(picture("an edge", halves(random, 9, 9, 0.8), 9, 9, samples));
    return check;
}

Check crowds(Random& random) {
    Check check{"aa.scene", {}};
    for (const int samples : {2, 3})
        check.cases.push_back(picture("patches", crowd(random, 32, 20, 12, 0.9), 32, 20, samples));
    check.cases.push_back(picture("patches", crowd(random, 12, 20, 7, 0.9), 12, 20, 4));
    return check;
}

Check bright(Random& random) {
    return {"aa.bright",
            {picture("a lamp's edge", halves(random, 9, 9, 20.0), 9, 9, 4),
             picture("bright patches", crowd(random, 24, 16, 8, 8.0), 24, 16, 3)}};
}

// The view changes between two calls, and there may be nothing to see.
Check again(Random& random) {
    Case twice = picture("one picture after the other", crowd(random, 16, 12, 5, 0.9), 16, 12, 2);
    twice.steps.push_back(drawn(crowd(random, 12, 16, 5, 0.9), 12, 16, 3));
    return {"aa.again", {twice, picture("no patches", {}, 4, 3, 2)}};
}

}  // namespace

std::vector<Check> antialiasChecks(std::uint64_t seed) {
    Random random(seed);
    return {one(random), edge(random), crowds(random), bright(random), again(random)};
}

}  // namespace radlab::grader

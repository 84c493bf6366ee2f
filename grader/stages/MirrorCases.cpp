#include "grader/stages/MirrorCases.h"

#include <glm/gtc/matrix_transform.hpp>

#include "course/FacePolygon.h"
#include "grader/stages/Meshes.h"

namespace radlab::grader {

namespace {

constexpr int width = 40, height = 30;

// Where the mirror of a case lies and which way it looks, and what stands round it.
struct Scene {
    Vec3f point, normal;
    float length = 1.0f;  // that the normal is given with
    Vec3f reflectance{1.0f};
    Vec3f own{0.0f};  // radiance of the mirror's surface itself
    bool behind = false, through = false;
};

Vec3f acrossTo(const Vec3f& normal) {
    const glm::dvec3 n(normal);
    return Vec3f(glm::normalize(glm::cross(axisAcross(n), n)));
}

void add(Random& random, State& state, const Vec3f& center, const Vec3f& normal, float size) {
    const int patch =
        addPatch(state, rectangle(center, normal, size, 0.8f * size, static_cast<float>(random.between(0, 6))));
    state.patches[static_cast<std::size_t>(patch)].color = random.vector(0.1, 1.0);
}

// Patches in front look at the mirror or away from it; the camera stands in front, too, and looks at the mirror's
// middle.
State stateOf(Random& random, const Scene& scene) {
    State state;
    const Vec3f n = scene.normal, right = acrossTo(n), up = glm::cross(n, right);
    const auto place = [&](double distance, double spread) {
        return scene.point + static_cast<float>(distance) * n +
               static_cast<float>(random.between(-spread, spread)) * right +
               static_cast<float>(random.between(-spread, spread)) * up;
    };
    addPatch(state, rectangle(scene.point, n, 4.0f, 3.0f, static_cast<float>(random.between(0, 6))));
    state.patches[0].color = scene.own;
    for (int i = 0; i < 6; ++i) {
        const Vec3f at = place(1.0 + 0.6 * i, 2.5), side = 0.5f * random.direction();
        add(random, state, at, glm::normalize((i % 3 ? -n : n) + side), 1.2f);
    }
    add(random, state, scene.point + 9.0f * n, -n, 14.0f);  // a wall behind the camera
    if (scene.behind)
        for (int i = 0; i < 3; ++i) add(random, state, place(-1.0 - 0.5 * i, 1.5), i % 2 ? n : -n, 2.5f);
    if (scene.through) add(random, state, place(0.0, 1.0), glm::normalize(right + 0.2f * n), 2.5f);
    return state;
}

glm::mat4 cameraAt(Random& random, const Scene& scene) {
    const Vec3f right = acrossTo(scene.normal), up = glm::cross(scene.normal, right);
    const Vec3f eye = scene.point + 6.0f * scene.normal + static_cast<float>(random.between(-3, 3)) * right +
                      static_cast<float>(random.between(-2, 2)) * up;
    return glm::perspective(0.9f, static_cast<float>(width) / height, 0.1f, 100.0f) *
           glm::lookAt(eye, scene.point + 0.2f * right, up);
}

Step seen(Random& random, const Scene& scene) {
    Step step;
    step.function = "mirrorScene";
    step.state = stateOf(random, scene);
    step.view = cameraAt(random, scene);
    step.width = width;
    step.height = height;
    step.inFloats = true;
    step.shooter = 0;
    step.mirror = {scene.point, scene.length * scene.normal, scene.reflectance};
    return step;
}

Case one(Random& random, const std::string& what, const Scene& scene) { return {what, {seen(random, scene)}}; }

const Vec3f zAxis(0.0f, 0.0f, 1.0f);

// Through the origin along an axis, and aslant.
Check plane(Random& random) {
    return {"mirror.plane",
            {one(random, "a mirror through the origin, along an axis", {.point = Vec3f(0.0f), .normal = zAxis}),
             one(random, "a mirror through the origin, aslant", {.point = Vec3f(0.0f), .normal = random.direction()})}};
}

Check offset(Random& random) {
    Check check{"mirror.offset", {}};
    for (const Vec3f& normal : {zAxis, random.direction(), random.direction()})
        check.cases.push_back(one(random, "a mirror anywhere", {.point = random.vector(1, 4), .normal = normal}));
    return check;
}

Check length(Random& random) {
    Check check{"mirror.length", {}};
    for (const float factor : {0.3f, 2.5f})
        check.cases.push_back(one(random, "a normal that is not of length 1",
                                  {.point = random.vector(1, 4), .normal = random.direction(), .length = factor}));
    return check;
}

Check front(Random& random) {
    Check check{"mirror.front", {}};
    for (const bool through : {false, true})
        check.cases.push_back(
            one(random, through ? "a patch through the mirror's plane" : "patches behind the mirror",
                {.point = random.vector(1, 4), .normal = random.direction(), .behind = true, .through = through}));
    return check;
}

Check light(Random& random) {
    Check check{"mirror.light", {}};
    for (int i = 0; i < 2; ++i)
        check.cases.push_back(one(random, "a tinted mirror that is a little matt",
                                  {.point = random.vector(1, 4),
                                   .normal = random.direction(),
                                   .reflectance = random.vector(0.3, 0.9),
                                   .own = random.vector(0.1, 0.3)}));
    return check;
}

}  // namespace

std::vector<Check> mirrorChecks(std::uint64_t seed) {
    Random random(seed);
    return {plane(random), offset(random), length(random), front(random), light(random)};
}

}  // namespace radlab::grader

#include "grader/stages/HemicubeFFScenes.h"

#include <cmath>

#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "course/FacePolygon.h"
#include "grader/stages/ManyPatches.h"

namespace radlab::grader {

namespace {

// Directions round a normal.
class Hemisphere {
public:
    explicit Hemisphere(const Vec3f& around)
        : normal(around),
          right(glm::normalize(glm::cross(normal, axisAcross(normal)))),
          up(glm::cross(normal, right)) {}

    glm::dvec3 direction(double angle, double azimuth) const {
        return std::cos(angle) * normal + std::sin(angle) * (std::cos(azimuth) * right + std::sin(azimuth) * up);
    }

private:
    glm::dvec3 normal, right, up;
};

void addAny(Random& random, State& state, const glm::dvec3& center, const glm::dvec3& normal, double smallest,
            double largest) {
    const auto width = static_cast<float>(random.between(smallest, largest)),
               height = static_cast<float>(random.between(smallest, largest)),
               turn = static_cast<float>(random.between(0, 6));
    addPatch(state, random.index(2) ? rectangle(Vec3f(center), Vec3f(normal), width, height, turn)
                                    : triangle(Vec3f(center), Vec3f(normal), width, height, turn));
}

// Tilted so little that a patch before a shooter is never within 90° of its normal.
glm::dvec3 nearly(Random& random, const glm::dvec3& normal) {
    return glm::normalize(normal + 0.45 * glm::dvec3(random.direction()));
}

// On the two sides of the normal by turns, so that the first two do not hide each other.
void addNear(Random& random, State& state, const glm::dvec3& place, const Hemisphere& hemisphere, bool otherSide) {
    const glm::dvec3 direction = hemisphere.direction(random.between(0.9, 1.0), otherSide ? glm::pi<double>() : 0.0);
    addAny(random, state, place + random.between(0.9, 1.1) * direction, nearly(random, -direction), 0.3, 0.45);
}

void addFar(Random& random, State& state, const glm::dvec3& place, const Hemisphere& hemisphere, Turned turned) {
    const glm::dvec3 direction =
        hemisphere.direction(random.between(0.0, 0.8), random.between(0, glm::two_pi<double>()));
    const glm::dvec3 normal = turned == Turned::toShooter ? nearly(random, -direction) : glm::dvec3(random.direction());
    addAny(random, state, place + random.between(1.6, 3.0) * direction, normal, 0.5, 1.2);
}

}  // namespace

Scene around(Random& random, const Vec3f& normal, int others, Place place, Turned turned) {
    Scene scene;
    const glm::dvec3 position(random.vector(-2, 2));
    const Hemisphere hemisphere(normal);
    scene.shooter = place == Place::first  ? 0
                    : place == Place::last ? others
                                           : 1 + random.index(static_cast<std::size_t>(others - 1));
    for (int i = 0; i <= others; ++i) {
        const int other = i - (i > scene.shooter);
        if (i == scene.shooter) {
            addAny(random, scene.state, position, glm::dvec3(normal), 0.3, 0.6);
            scene.state.patches.back().normal = normal;
        } else if (other == 0 || other == others - 1) {
            addNear(random, scene.state, position, hemisphere, other > 0);
        } else {
            addFar(random, scene.state, position, hemisphere, turned);
        }
    }
    randomLight(random, scene.state);
    return scene;
}

namespace {

Scene moved(Scene scene, const Vec3f& by) {
    for (MyVertex& corner : scene.state.corners) corner.position += by;
    for (MyPolygon& patch : scene.state.patches) patch.center += by;
    return scene;
}

Scene turnedAround(Random& random, Scene scene) {
    const glm::dmat3 turn(glm::rotate(glm::dmat4(1.0), random.between(0.5, 2.5), glm::dvec3(random.direction())));
    for (MyVertex& corner : scene.state.corners) corner.position = Vec3f(turn * glm::dvec3(corner.position));
    for (MyPolygon& patch : scene.state.patches) {
        patch.center = Vec3f(turn * glm::dvec3(patch.center));
        patch.normal = Vec3f(glm::normalize(turn * glm::dvec3(patch.normal)));
    }
    return scene;
}

}  // namespace

Scene apart(Random& random, int others, int& otherShooter) {
    const Vec3f normal = random.direction();
    Scene scene = around(random, normal, others, Place::middle);
    const Scene other = moved(around(random, -normal, others, Place::middle), -20.0f * normal);
    otherShooter = static_cast<int>(scene.state.patches.size()) + other.shooter;
    append(scene.state, other.state);
    return scene;
}

Scene emptyRoom(Random& random) {
    constexpr float wholeWalls = 3.0f;
    Scene scene{room(random, wholeWalls, 0), 0};
    scene.shooter = random.index(scene.state.patches.size());
    return turnedAround(random, std::move(scene));
}

Scene furnishedRoom(Random& random) {
    Scene scene{room(random, 0.5f, 0), 0};
    Vec3f size(0.0f);
    for (const MyVertex& corner : scene.state.corners) size = glm::max(size, corner.position);
    for (const float left : {0.15f, 0.55f}) {
        const Vec3f low = random.vector(0.2, 0.4), high = random.vector(0.5, 0.8);
        for (const std::vector<Vec3f>& side :
             sidesOfBox(size * Vec3f(left, low.y, low.z), size * Vec3f(left + 0.3f, high.y, high.z), false))
            addPatch(scene.state, side);
    }
    shuffle(random, scene.state);
    randomLight(random, scene.state);
    scene.shooter = random.index(scene.state.patches.size());
    return turnedAround(random, std::move(scene));
}

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

Scene coplanar(Random& random) {
    const Vec3f normal = random.direction();
    State state;
    const std::vector<Vec3f> own = rectangle(random.vector(-1, 1), normal, 1.0f, 1.0f);
    const Vec3f right = own[1] - own[0], up = own[3] - own[0];
    const auto beside = [&](const Vec3f& by) {
        std::vector<Vec3f> corners = own;
        for (Vec3f& corner : corners) corner += by;
        return corners;
    };
    addPatch(state, beside(right));
    addPatch(state, own);
    addPatch(state, {own[3], own[2], own[1], own[0]});
    addPatch(state, beside(up));
    addPatch(state, {own[3] + 0.3f * normal, own[2] + 0.3f * normal, own[2] + normal, own[3] + normal});
    addPatch(state, {own[1] + normal, own[0] + normal, own[0] + 0.2f * right + 1.5f * normal});
    randomLight(random, state);
    // Straight behind, for those who look backwards.
    addPatch(state, {own[0] - normal, own[1] - normal, own[2] - normal, own[3] - normal});
    MyPolygon& behind = state.patches.back();
    for (Vec3f MyPolygon::*light : {&MyPolygon::rad, &MyPolygon::unshot_rad, &MyPolygon::diffuse, &MyPolygon::emissive})
        behind.*light = state.patches.front().*light;
    behind.formF = state.patches.front().formF;
    return {std::move(state), 1};
}

namespace {

// The patches 1 to `large` are spread over the list: some to its very end, the first one to its front.
void spread(Random& random, Scene& scene, int large) {
    std::vector<MyPolygon>& patches = scene.state.patches;
    constexpr std::size_t tail = 200;
    const auto count = patches.size(), begin = static_cast<std::size_t>(large) + 1;
    const auto anywhere = [&] { return begin + static_cast<std::size_t>(random.index(count - tail - begin)); };
    for (std::size_t k = 0; k < 6; ++k) std::swap(patches[begin - 1 - k], patches[count - 1 - 31 * k]);
    for (std::size_t k = 2; k < begin - 6; ++k) std::swap(patches[k], patches[anywhere()]);
    const std::size_t place = anywhere();
    std::swap(patches[0], patches[1]);
    std::swap(patches[1], patches[place]);
    scene.shooter = static_cast<int>(place);
}

}  // namespace

Scene among(Random& random, int cells, int large) {
    const Vec3f normal = normalize(Vec3f(0.1f, 0.17f, -1.0f));
    Scene scene = around(random, normal, large, Place::first);
    const Vec3f behind = scene.state.patches[0].center - Vec3f(0.0f, 0.0f, 4.0f);
    append(scene.state, moved(scaled({wall(random, cells), 0}, 4.2f), behind).state);
    randomLight(random, scene.state);
    spread(random, scene, large);
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

}  // namespace radlab::grader

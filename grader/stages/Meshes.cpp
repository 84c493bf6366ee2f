#include "grader/stages/Meshes.h"

#include <cmath>
#include <memory>

#include <glm/gtc/constants.hpp>

#include "course/FacePolygon.h"
#include "course/Mesher.h"

namespace radlab::grader {

double Random::magnitude(double low, double high) { return std::exp(between(std::log(low), std::log(high))); }

Vec3f Random::vector(double low, double high) {
    const auto x = static_cast<float>(between(low, high)), y = static_cast<float>(between(low, high)),
               z = static_cast<float>(between(low, high));
    return {x, y, z};
}

Vec3f Random::direction() {
    const double z = between(-1, 1), turn = between(0, glm::two_pi<double>()), r = std::sqrt(1 - z * z);
    return glm::vec3(glm::normalize(glm::dvec3(r * std::cos(turn), r * std::sin(turn), z)));
}

namespace {

struct Axes {
    glm::dvec3 right, up;
};

Axes axesIn(const Vec3f& normal, float turn) {
    const glm::dvec3 n(normal);
    const glm::dvec3 right = glm::normalize(glm::cross(axisAcross(n), n)), up = glm::cross(n, right);
    const double c = std::cos(static_cast<double>(turn)), s = std::sin(static_cast<double>(turn));
    return {c * right + s * up, c * up - s * right};
}

}  // namespace

std::vector<std::vector<Vec3f>> sidesOfBox(const Vec3f& low, const Vec3f& high, bool inside) {
    std::vector<std::vector<Vec3f>> sides;
    for (int axis = 0; axis < 3; ++axis)
        for (const bool upper : {false, true}) {
            const int a = (axis + 1) % 3, b = (axis + 2) % 3;
            std::vector<Vec3f> corners(4, low);
            for (std::size_t i = 0; i < 4; ++i) {
                corners[i][axis] = upper ? high[axis] : low[axis];
                corners[i][a] = i == 1 || i == 2 ? high[a] : low[a];
                corners[i][b] = i >= 2 ? high[b] : low[b];
            }
            if (upper == inside) std::swap(corners[1], corners[3]);
            sides.push_back(corners);
        }
    return sides;
}

int addPatch(State& state, const std::vector<Vec3f>& corners) {
    MyPolygon patch;
    patch.vertices = static_cast<int>(corners.size());
    for (std::size_t i = 0; i < corners.size(); ++i) {
        patch.vertex[i] = static_cast<int>(state.corners.size());
        state.corners.emplace_back();
        state.corners.back().position = corners[i];
    }
    const Corners places(corners.begin(), corners.end());
    const glm::dvec3 area = areaVector(places), normal = glm::normalize(area);
    patch.area = static_cast<float>(glm::length(area));
    patch.normal = Vec3f(normal);
    patch.center = Vec3f(areaCentroid(places, normal));
    state.patches.push_back(patch);
    return static_cast<int>(state.patches.size()) - 1;
}

std::vector<Vec3f> rectangle(const Vec3f& center, const Vec3f& normal, float width, float height, float turn) {
    const Axes axes = axesIn(normal, turn);
    const glm::dvec3 c(center), r = 0.5 * static_cast<double>(width) * axes.right,
                                u = 0.5 * static_cast<double>(height) * axes.up;
    return {Vec3f(c - r - u), Vec3f(c + r - u), Vec3f(c + r + u), Vec3f(c - r + u)};
}

std::vector<Vec3f> triangle(const Vec3f& center, const Vec3f& normal, float width, float height, float turn) {
    const Axes axes = axesIn(normal, turn);
    const glm::dvec3 r = static_cast<double>(width) * axes.right, u = static_cast<double>(height) * axes.up;
    const glm::dvec3 low = glm::dvec3(center) - (r + u) / 3.0;
    return {Vec3f(low), Vec3f(low + r), Vec3f(low + u)};
}

void randomLight(Random& random, State& state) {
    for (MyPolygon& patch : state.patches) {
        patch.diffuse = random.vector(0.05, 0.95);
        patch.emissive = random.vector(0.0, 1.0);
        patch.unshot_rad = random.vector(0.1, 1.0);
        patch.rad = patch.unshot_rad + random.vector(0.1, 2.0);
        patch.formF = static_cast<float>(random.between(0.001, 0.2));
        patch.color = random.vector(0.0, 5.0);
    }
    for (MyVertex& corner : state.corners) {
        corner.color = random.vector(0.0, 5.0);
        corner.rad = random.vector(0.0, 5.0);
        corner.colorcount = 1 + random.index(7);
    }
}

State scattered(Random& random, int count) {
    State state;
    for (int i = 0; i < count; ++i) {
        const Vec3f center = random.vector(-10, 10), normal = random.direction();
        const auto width = static_cast<float>(random.magnitude(0.2, 2)),
                   height = static_cast<float>(random.magnitude(0.2, 2)),
                   turn = static_cast<float>(random.between(0, 6));
        addPatch(state, random.index(2) ? rectangle(center, normal, width, height, turn)
                                        : triangle(center, normal, width, height, turn));
    }
    randomLight(random, state);
    return state;
}

namespace {

// Faces for the Mesher.
struct Builder {
    std::vector<Vec3f> positions;
    std::vector<Face> faces;
    std::shared_ptr<const Material> material = std::make_shared<const Material>();

    void add(const std::vector<Vec3f>& corners) {
        Face face;
        face.material = material;
        face.where = {"case", 0};
        for (const Vec3f& corner : corners) {
            face.corners.push_back(static_cast<int>(positions.size()));
            positions.push_back(corner);
        }
        faces.push_back(face);
    }

    void addBox(const Vec3f& low, const Vec3f& high, bool inside) {
        for (const std::vector<Vec3f>& side : sidesOfBox(low, high, inside)) add(side);
    }
};

}  // namespace

State room(Random& random, float patchSize, int blocks) {
    Builder builder;
    const Vec3f size = random.vector(1, 2);
    builder.addBox(Vec3f(0.0f), size, true);
    for (int i = 0; i < blocks; ++i) {
        const Vec3f low = size * random.vector(0.15, 0.5), high = low + size * random.vector(0.1, 0.3);
        builder.addBox(low, high, false);
        builder.add(triangle(size * random.vector(0.3, 0.7), random.direction(), 0.3f, 0.4f));
    }
    State state;
    Mesher::mesh(builder.positions, builder.faces, state.corners, state.patches, patchSize, patchSize);
    randomLight(random, state);
    return state;
}

void shuffle(Random& random, State& state) {
    for (std::size_t i = state.patches.size(); i > 1; --i)
        std::swap(state.patches[i - 1], state.patches[static_cast<std::size_t>(random.index(i))]);
}

}  // namespace radlab::grader

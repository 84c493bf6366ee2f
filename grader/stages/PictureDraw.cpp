#include "grader/stages/PictureDraw.h"

#include <algorithm>
#include <array>

#include <glm/gtc/matrix_transform.hpp>

#include "grader/stages/IdRaster.h"

namespace radlab::grader {

namespace {

constexpr int samples = 2;  // per pixel along each edge
constexpr int edge = samples * pictureSize;

IdImage visiblePatches(const State& state, const Camera& camera) {
    RasterStyle fronts;
    fronts.cull = RasterStyle::Cull::back;
    const std::array<IdView, 1> views = {{{clipFromWorld(state, camera), 0, 0, edge, edge}}};
    return rasterIds(state, views, edge, edge, fronts);
}

// Where the ray through a sample's centre meets the plane of a patch.
class Rays {
public:
    Rays(const State& state, const Camera& camera)
        : eye(camera.position), worldFromClip(glm::inverse(clipFromWorld(state, camera))) {}

    glm::dvec3 hit(int x, int y, const MyPolygon& patch) const {
        const glm::dvec4 clip(2.0 * (x + 0.5) / edge - 1.0, 2.0 * (y + 0.5) / edge - 1.0, 0.0, 1.0);
        const glm::dvec4 world = worldFromClip * clip;
        const glm::dvec3 direction = glm::dvec3(world) / world.w - eye, normal(patch.normal);
        return eye + direction * (glm::dot(glm::dvec3(patch.center) - eye, normal) / glm::dot(direction, normal));
    }

private:
    glm::dvec3 eye;
    glm::dmat4 worldFromClip;
};

// The shares of three corners at a point in their plane.
glm::dvec3 barycentric(const glm::dvec3& p, const std::array<glm::dvec3, 3>& corners, const glm::dvec3& normal) {
    const auto side = [&](std::size_t a, std::size_t b) {
        return glm::dot(normal, glm::cross(corners[b] - corners[a], p - corners[a]));
    };
    const glm::dvec3 parts(side(1, 2), side(2, 0), side(0, 1));
    return parts / (parts.x + parts.y + parts.z);
}

glm::vec3 smoothColor(const State& state, const MyPolygon& patch, const glm::dvec3& p,
                      const std::function<glm::vec3(std::size_t)>& color) {
    glm::dvec3 shares(0.0);
    std::array<std::size_t, 3> corners{};
    for (int second = 1; second + 1 < patch.vertices; ++second) {
        corners = {static_cast<std::size_t>(patch.vertex[0]), static_cast<std::size_t>(patch.vertex[second]),
                   static_cast<std::size_t>(patch.vertex[second + 1])};
        const auto at = [&](std::size_t i) { return glm::dvec3(state.corners[corners[i]].position); };
        shares = barycentric(p, {at(0), at(1), at(2)}, glm::dvec3(patch.normal));
        if (shares.y >= 0.0) break;  // on this side of the diagonal
    }
    shares = glm::clamp(shares, 0.0, 1.0);
    return static_cast<float>(shares.x) * color(corners[0]) + static_cast<float>(shares.y) * color(corners[1]) +
           static_cast<float>(shares.z) * color(corners[2]);
}

template <class ColorAt>
Image drawn(const IdImage& ids, const ColorAt& colorAt) {
    Image image(edge, edge);
    for (int y = 0; y < edge; ++y)
        for (int x = 0; x < edge; ++x) {
            const int patch = ids.patch[static_cast<std::size_t>(y) * edge + static_cast<std::size_t>(x)];
            if (patch >= 0) image.at(x, edge - 1 - y) = colorAt(x, y, static_cast<std::size_t>(patch));
        }
    return image.shrunk(samples);
}

}  // namespace

glm::dmat4 clipFromWorld(const State& state, const Camera& camera) {
    const glm::dvec3 eye(camera.position), direction(camera.direction);
    double nearest = 1e30, farthest = 0.0;
    for (const MyVertex& corner : state.corners) {
        const double depth = glm::dot(glm::dvec3(corner.position) - eye, direction);
        nearest = std::min(nearest, depth);
        farthest = std::max(farthest, depth);
    }
    nearest = std::max(0.9 * nearest, 1e-3 * farthest);
    return glm::perspective(static_cast<double>(camera.fieldOfView), 1.0, nearest, 1.1 * farthest) *
           glm::lookAt(eye, eye + direction, glm::dvec3(camera.up));
}

Image drawFlat(const State& state, const Camera& camera, const std::function<glm::vec3(std::size_t)>& color) {
    return drawn(visiblePatches(state, camera), [&](int, int, std::size_t patch) { return color(patch); });
}

Image drawSmooth(const State& state, const Camera& camera, const std::function<glm::vec3(std::size_t)>& color) {
    const Rays rays(state, camera);
    return drawn(visiblePatches(state, camera), [&](int x, int y, std::size_t index) {
        const MyPolygon& patch = state.patches[index];
        return smoothColor(state, patch, rays.hit(x, y, patch), color);
    });
}

}  // namespace radlab::grader

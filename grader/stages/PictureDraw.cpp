#include "grader/stages/PictureDraw.h"

#include <algorithm>
#include <array>
#include <mutex>

#include <glm/gtc/matrix_transform.hpp>

#include "grader/stages/IdRaster.h"
#include "grader/stages/Remembered.h"

namespace radlab::grader {

namespace {

constexpr int samples = 2;  // per pixel along each sampledEdge
constexpr int sampledEdge = samples * pictureSize;

// All pictures are of a few boxes, which many submissions colour.
Fingerprint pictureKey(const State& state, const Camera& camera) {
    Fingerprint key;
    key.addShape(state);
    for (const Vec3f& v : {camera.position, camera.direction, camera.up}) key.add(v);
    key.add(camera.fieldOfView);
    return key;
}

// As Remembered, for several threads.
template <class Value, class Make>
std::shared_ptr<const Value> remembered(const State& state, const Camera& camera, const Make& make) {
    static std::mutex one;
    static Remembered<Value> known;
    const std::scoped_lock lock(one);
    return known.get(pictureKey(state, camera), make);
}

std::shared_ptr<const IdImage> visiblePatches(const State& state, const Camera& camera) {
    return remembered<IdImage>(state, camera, [&] {
        RasterStyle fronts;
        fronts.cull = RasterStyle::Cull::back;
        const std::array<IdView, 1> views = {{{clipFromWorld(state, camera), 0, 0, sampledEdge, sampledEdge}}};
        return rasterIds(state, views, sampledEdge, sampledEdge, fronts);
    });
}

// Where the ray through a sample's centre meets the plane of a patch.
class Rays {
public:
    Rays(const State& state, const Camera& camera)
        : eye(camera.position), worldFromClip(glm::inverse(clipFromWorld(state, camera))) {}

    glm::dvec3 hit(int x, int y, const MyPolygon& patch) const {
        const glm::dvec4 clip(2.0 * (x + 0.5) / sampledEdge - 1.0, 2.0 * (y + 0.5) / sampledEdge - 1.0, 0.0, 1.0);
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

// The three corners whose colours a sample shows, and how much of each.
struct Mix {
    std::array<std::uint32_t, 3> corners{};
    glm::vec3 shares{0.0f};
};

Mix mixAt(const State& state, const MyPolygon& patch, const glm::dvec3& p) {
    Mix mix;
    glm::dvec3 shares(0.0);
    for (int second = 1; second + 1 < patch.vertices; ++second) {
        mix.corners = {static_cast<std::uint32_t>(patch.vertex[0]), static_cast<std::uint32_t>(patch.vertex[second]),
                       static_cast<std::uint32_t>(patch.vertex[second + 1])};
        const auto at = [&](std::size_t i) { return glm::dvec3(state.corners[mix.corners[i]].position); };
        shares = barycentric(p, {at(0), at(1), at(2)}, glm::dvec3(patch.normal));
        if (shares.y >= 0.0) break;  // on this side of the diagonal
    }
    mix.shares = glm::vec3(glm::clamp(shares, 0.0, 1.0));
    return mix;
}

// One a sample; of samples that show no patch, what stands there means nothing.
std::shared_ptr<const std::vector<Mix>> mixes(const State& state, const Camera& camera, const IdImage& ids) {
    return remembered<std::vector<Mix>>(state, camera, [&] {
        const Rays rays(state, camera);
        std::vector<Mix> all(ids.patch.size());
        for (std::size_t i = 0; i < all.size(); ++i) {
            if (ids.patch[i] < 0) continue;
            const MyPolygon& patch = state.patches[static_cast<std::size_t>(ids.patch[i])];
            const int x = static_cast<int>(i) % sampledEdge, y = static_cast<int>(i) / sampledEdge;
            all[i] = mixAt(state, patch, rays.hit(x, y, patch));
        }
        return all;
    });
}

template <class ColorAt>
Image drawn(const IdImage& ids, const ColorAt& colorAt) {
    Image image(sampledEdge, sampledEdge);
    for (int y = 0; y < sampledEdge; ++y)
        for (int x = 0; x < sampledEdge; ++x) {
            const std::size_t sample = static_cast<std::size_t>(y) * sampledEdge + static_cast<std::size_t>(x);
            const int patch = ids.patch[sample];
            if (patch >= 0) image.at(x, sampledEdge - 1 - y) = colorAt(sample, static_cast<std::size_t>(patch));
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
    return drawn(*visiblePatches(state, camera), [&](std::size_t, std::size_t patch) { return color(patch); });
}

Image drawSmooth(const State& state, const Camera& camera, const std::function<glm::vec3(std::size_t)>& color) {
    const std::shared_ptr<const IdImage> ids = visiblePatches(state, camera);
    const std::shared_ptr<const std::vector<Mix>> all = mixes(state, camera, *ids);
    std::vector<glm::vec3> colors(state.corners.size());
    for (std::size_t k = 0; k < colors.size(); ++k) colors[k] = color(k);
    return drawn(*ids, [&](std::size_t sample, std::size_t) {
        const Mix& mix = (*all)[sample];
        return mix.shares.x * colors[mix.corners[0]] + mix.shares.y * colors[mix.corners[1]] +
               mix.shares.z * colors[mix.corners[2]];
    });
}

}  // namespace radlab::grader

#include "grader/stages/HemicubeRow.h"

#include <cmath>
#include <string>

#include <glm/gtc/matrix_transform.hpp>

#include "base/Error.h"
#include "course/ViewDepth.h"

namespace radlab::grader {

namespace {

glm::dvec3 unit(const Vec3f& v, const char* name) {
    const glm::dvec3 exact(v);
    const double length = glm::length(exact);
    if (!std::isfinite(length) || length == 0.0)
        throw Error(std::string("hemicube: ") + name + " vector: expected finite and not zero");
    return exact / length;
}

// One face: where it looks, where it lies in the buffer (in halves of size) and what part of ±1 it shows.
struct Face {
    glm::dvec3 forward, up;
    int x, y, width, height;
    double left, right, bottom, top;
};

std::vector<Face> facesOf(const Vec3f& upVector, const Vec3f& direction) {
    const glm::dvec3 forward = unit(direction, "direction");
    const glm::dvec3 across = glm::cross(forward, unit(upVector, "up"));
    if (glm::length(across) < parallelSine) throw Error("hemicube: up vector: parallel to the direction");
    const glm::dvec3 right = glm::normalize(across), up = glm::cross(right, forward);
    return {{forward, up, 1, 1, 2, 2, -1, 1, -1, 1},
            {right, up, 3, 1, 1, 2, -1, 0, -1, 1},
            {-right, up, 0, 1, 1, 2, 0, 1, -1, 1},
            {up, -forward, 1, 3, 2, 1, -1, 1, -1, 0},
            {-up, forward, 1, 0, 2, 1, -1, 1, 0, 1}};
}

// The state in the form that the course's functions take.
ViewDepth depthOf(const State& state, const glm::dvec3& eye, const glm::dvec3& direction) {
    State copy = state;
    std::vector<MyPolygon*> patches;
    std::vector<MyVertex*> corners;
    for (MyPolygon& patch : copy.patches) patches.push_back(&patch);
    for (MyVertex& corner : copy.corners) corners.push_back(&corner);
    return viewDepth(patches, corners, eye, direction);
}

// How far a sum of n deltas in floats may lie from the exact one. Each addition rounds by up to u = 2^-24 of the sum.
// All together that could be n·u, which is far too much: deltas differ from pixel to pixel, roundings go both ways, and
// their sum grows as the square root. Only where n·u comes near 1, so that a delta is no more than a few units of the
// sum, do neighbours round the same way. In 5,400 sums over rectangles, from size 32 to 1024, row by row, column by
// column and backwards, the worst was 0.6 of this.
double summationError(double sum, std::size_t n) {
    constexpr double u = 0x1p-24;
    const auto count = static_cast<double>(n);
    return sum * (4.0 * u * std::sqrt(count) + 0.2 * (count * u) * (count * u));
}

}  // namespace

std::vector<IdView> hemicubeViews(const State& state, const Vec3f& eye, const Vec3f& up, const Vec3f& direction,
                                  int size) {
    RADLAB_CHECK(size >= 2);
    RADLAB_CHECK(size % 2 == 0);
    const glm::dvec3 from(eye);
    const std::vector<Face> faces = facesOf(up, direction);
    const ViewDepth depth = depthOf(state, from, faces[0].forward);
    const double n = depth.nearest;
    std::vector<IdView> views;
    for (const Face& face : faces) {
        const glm::dmat4 projection =
            glm::frustum(face.left * n, face.right * n, face.bottom * n, face.top * n, n, depth.farthest);
        views.push_back({projection * glm::lookAt(from, from + face.forward, face.up), face.x * size / 2,
                         face.y * size / 2, face.width * size / 2, face.height * size / 2});
    }
    return views;
}

HemicubeBuffer hemicubeBuffer(const State& state, const Vec3f& eye, const Vec3f& up, const Vec3f& direction, int size,
                              const RasterStyle& style) {
    const std::vector<IdView> views = hemicubeViews(state, eye, up, direction, size);
    return {size, rasterIds(state, views, 2 * size, 2 * size, style)};
}

Row hemicubeRow(const HemicubeBuffer& buffer, const std::vector<float>& deltas, std::size_t patchCount) {
    const IdImage& image = buffer.image;
    RADLAB_CHECK(deltas.size() == image.patch.size());
    Row row{std::vector<double>(patchCount), std::vector<double>(patchCount)};
    std::vector<std::size_t> pixels(patchCount);
    for (std::size_t pixel = 0; pixel < deltas.size(); ++pixel) {
        const double delta = deltas[pixel];
        if (const int patch = image.patch[pixel]; patch >= 0) {
            row.values.at(static_cast<std::size_t>(patch)) += delta;
            ++pixels[static_cast<std::size_t>(patch)];
        }
        for (const int patch : image.candidatesOf(pixel))
            if (patch >= 0) row.slack.at(static_cast<std::size_t>(patch)) += delta;
    }
    for (std::size_t i = 0; i < patchCount; ++i)
        row.slack[i] += summationError(row.values[i] + row.slack[i], pixels[i]);
    return row;
}

}  // namespace radlab::grader

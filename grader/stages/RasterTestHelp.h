#pragma once

// Scenes that the tests of the rasteriser draw, and the same drawn with OpenGL.

#include <functional>
#include <random>
#include <vector>

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

#include "course/ProgRef.h"
#include "course/TestMeshes.h"
#include "gl/Context.h"
#include "gl/Framebuffer.h"
#include "gl/IdPass.h"
#include "gl/SavedState.h"
#include "grader/stages/IdRaster.h"

namespace radlab::grader::test {

/// Points the course's globals at a state for as long as it lives.
class Published {
public:
    explicit Published(State& state) {
        polygons.clear();
        vertices.clear();
        for (MyPolygon& patch : state.patches) polygons.push_back(&patch);
        for (MyVertex& corner : state.corners) vertices.push_back(&corner);
    }
    ~Published() {
        polygons.clear();
        vertices.clear();
    }
    Published(const Published&) = delete;
    Published& operator=(const Published&) = delete;
};

inline State stateOf(const radlab::test::Faces& faces, float size) {
    const auto mesh = faces.mesh(size);
    return {mesh->patches, mesh->corners};
}

/// Adds a flat patch; its corners counter-clockwise seen from the front.
inline void addPatch(State& state, const std::vector<Vec3f>& corners) {
    MyPolygon patch;
    patch.vertices = static_cast<int>(corners.size());
    for (int i = 0; i < patch.vertices; ++i) {
        patch.vertex[i] = static_cast<int>(state.corners.size());
        state.corners.emplace_back();
        state.corners.back().position = corners[static_cast<std::size_t>(i)];
        patch.center += corners[static_cast<std::size_t>(i)] / static_cast<float>(patch.vertices);
    }
    const Vec3f across = glm::cross(corners[1] - corners[0], corners.back() - corners[0]);
    patch.area = glm::length(across) * (patch.vertices == 3 ? 0.5f : 1.0f);
    patch.normal = glm::normalize(across);
    state.patches.push_back(patch);
}

/// A room of edge 1, moved, with a few turned blocks that stand on its floor.
inline State furnishedRoom(unsigned seed, float patchSize, const Vec3f& shift = Vec3f(0)) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> share(0.0f, 1.0f);
    radlab::test::Faces faces;
    faces.addRoom(shift, shift + Vec3f(1), radlab::test::material(Vec3f(0.5f)));
    for (int block = 0; block < 4; ++block) {
        const float angle = 6.28f * share(random), half = 0.05f + 0.1f * share(random),
                    top = 0.1f + 0.6f * share(random);
        const Vec3f foot = shift + Vec3f(0.2f + 0.6f * share(random), 0, 0.2f + 0.6f * share(random));
        const auto corner = [&](int i, float height) {
            const float turned = angle + 1.5707963f * static_cast<float>(i);
            return foot + Vec3f(half * std::cos(turned), height, -half * std::sin(turned));
        };
        for (int i = 0; i < 4; ++i) faces.add({corner(i, 0), corner(i + 1, 0), corner(i + 1, top), corner(i, top)});
        faces.add({corner(0, top), corner(1, top), corner(2, top), corner(3, top)});
    }
    return stateOf(faces, patchSize);
}

/// Parallelograms and triangles in random poses in a cube of edge 2 round the middle.
inline State scatteredPatches(unsigned seed, int count, float size, const Vec3f& middle = Vec3f(0)) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> share(-1.0f, 1.0f);
    const auto vector = [&] { return Vec3f(share(random), share(random), share(random)); };
    State state;
    for (int i = 0; i < count; ++i) {
        const Vec3f at = middle + vector(), a = size * vector(), b = size * vector();
        if (glm::length(glm::cross(a, b)) < 0.01f * size * size) continue;
        if (share(random) < 0.0f)
            addPatch(state, {at, at + a, at + b});
        else
            addPatch(state, {at, at + a, at + a + b, at + b});
    }
    return state;
}

/// What OpenGL shows of the published patches: patch indices, or -1, row by row from the bottom.
inline std::vector<int> drawn(const std::vector<IdView>& views, int width, int height,
                              const std::function<void()>& draw) {
    const SavedState saved;
    const Framebuffer framebuffer(width, height, Framebuffer::Color::bytes);
    framebuffer.bind();
    setIdPassState();
    glDisable(GL_SCISSOR_TEST);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    for (const IdView& view : views) {
        glViewport(view.x, view.y, view.width, view.height);
        glMatrixMode(GL_PROJECTION);
        glLoadMatrixd(glm::value_ptr(view.clipFromWorld));
        glMatrixMode(GL_MODELVIEW);
        glLoadIdentity();
        draw();
    }
    std::vector<std::uint8_t> bytes(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
    std::vector<int> indices;
    for (std::size_t i = 0; i < bytes.size(); i += 4)
        indices.push_back((bytes[i] << 16 | bytes[i + 1] << 8 | bytes[i + 2]) - 1);
    return indices;
}

/// How a picture compares with OpenGL's.
struct Comparison {
    int sureAndWrong = 0;     ///< sure pixels that OpenGL shows otherwise
    int notACandidate = 0;    ///< unsure pixels for which OpenGL shows none of the candidates
    double sureShare = 0.0;   ///< of all pixels
    double wrongShare = 0.0;  ///< of the unsure pixels that OpenGL shows otherwise
};

inline Comparison compare(const IdImage& image, const std::vector<int>& found) {
    Comparison result;
    int sure = 0, wrong = 0;
    for (std::size_t i = 0; i < found.size(); ++i) {
        if (image.sure[i]) {
            ++sure;
            result.sureAndWrong += image.patch[i] != found[i];
            continue;
        }
        wrong += image.patch[i] != found[i];
        const auto candidates = image.candidatesOf(i);
        result.notACandidate += std::find(candidates.begin(), candidates.end(), found[i]) == candidates.end();
    }
    const auto pixels = static_cast<double>(found.size());
    result.sureShare = sure / pixels;
    result.wrongShare = wrong / std::max(pixels - sure, 1.0);
    return result;
}

/// A view of the middle from a random place at that distance.
inline IdView viewOf(const Vec3f& middle, double distance, unsigned seed, const IdView& viewport,
                     double nearest = 0.05) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> share(-1.0, 1.0);
    glm::dvec3 aside;
    do aside = {share(random), share(random), share(random)};
    while (glm::length(aside) < 0.1 || std::abs(aside.y) > 0.9 * glm::length(aside));
    const glm::dvec3 centre(middle);
    IdView view = viewport;
    view.clipFromWorld = glm::perspective(1.0, static_cast<double>(view.width) / view.height, nearest, 20.0) *
                         glm::lookAt(centre + distance * glm::normalize(aside), centre, glm::dvec3(0, 1, 0));
    return view;
}

}  // namespace radlab::grader::test

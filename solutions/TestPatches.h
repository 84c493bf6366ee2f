#pragma once

// Patches that the tests of a solution share.

#include <memory>
#include <random>

#include "course/TestMeshes.h"

namespace radlab::test {

/// Patches in random places, of random sizes, turned at random, without corners, each with something unshot; published.
inline std::unique_ptr<PatchMesh> scattered(int count, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> signedShare(-1.0f, 1.0f), share(0.05f, 0.95f);
    const auto vector = [&](auto& of) { return Vec3f(of(random), of(random), of(random)); };
    auto mesh = std::make_unique<PatchMesh>();
    mesh->patches.resize(static_cast<std::size_t>(count));
    for (MyPolygon& patch : mesh->patches) {
        patch.center = 10.0f * vector(signedShare);
        do patch.normal = vector(signedShare);
        while (sqr_length(patch.normal) < 0.01f);
        patch.normal = glm::normalize(patch.normal);
        patch.area = share(random);
        patch.diffuse = vector(share);
        patch.emissive = patch.unshot_rad = vector(share);
        patch.rad = patch.unshot_rad + vector(share);
        patch.formF = share(random);
    }
    mesh->publish();
    return mesh;
}

/// Makes one patch of `polygons` the brightest: nothing is unshot on the others.
inline MyPolygon* onlyShooter(std::size_t index, const Vec3f& unshot = Vec3f(1.0f)) {
    for (MyPolygon* patch : polygons) patch->unshot_rad = Vec3f(0.0f);
    polygons[index]->unshot_rad = unshot;
    return polygons[index];
}

/// A room with a triangle in it, in quadrilateral and triangular patches.
inline std::unique_ptr<PatchMesh> roomWithTriangle() {
    Faces faces;
    faces.addRoom(Vec3f(0), Vec3f(1), material(Vec3f(0.5f)));
    faces.add({{0.3f, 0.6f, 0.4f}, {0.7f, 0.6f, 0.4f}, {0.5f, 0.6f, 0.8f}});
    auto mesh = faces.mesh(0.25f);
    mesh->publish();
    return mesh;
}

}  // namespace radlab::test

#pragma once

// Small scenes that tests share.

#include <memory>
#include <vector>

#include "course/PatchMesh.h"

namespace radlab::test {

inline std::shared_ptr<const Material> material(const Vec3f& diffuse, const Vec3f& emissive = Vec3f(0.0f)) {
    Material made;
    made.diffuse = diffuse;
    made.emissive = emissive;
    return std::make_shared<const Material>(made);
}

/// Faces and their positions, in the form that the Mesher takes.
struct Faces {
    std::vector<Vec3f> positions;
    std::vector<Face> faces;

    void add(const std::vector<Vec3f>& corners, std::shared_ptr<const Material> of = material(Vec3f(0.5f))) {
        Face face;
        face.material = std::move(of);
        face.where = {"test.x3d", static_cast<int>(faces.size()) + 1};
        for (const Vec3f& corner : corners) {
            face.corners.push_back(static_cast<int>(positions.size()));
            positions.push_back(corner);
        }
        faces.push_back(face);
    }

    /// An axis-parallel box, its fronts inside.
    void addRoom(const Vec3f& low, const Vec3f& high, const std::shared_ptr<const Material>& of) {
        const auto corner = [&](int x, int y, int z) {
            return Vec3f(x ? high.x : low.x, y ? high.y : low.y, z ? high.z : low.z);
        };
        add({corner(0, 0, 0), corner(0, 0, 1), corner(1, 0, 1), corner(1, 0, 0)}, of);  // floor
        add({corner(0, 1, 0), corner(1, 1, 0), corner(1, 1, 1), corner(0, 1, 1)}, of);  // ceiling
        add({corner(0, 0, 0), corner(1, 0, 0), corner(1, 1, 0), corner(0, 1, 0)}, of);  // z low
        add({corner(0, 0, 1), corner(0, 1, 1), corner(1, 1, 1), corner(1, 0, 1)}, of);  // z high
        add({corner(0, 0, 0), corner(0, 1, 0), corner(0, 1, 1), corner(0, 0, 1)}, of);  // x low
        add({corner(1, 0, 0), corner(1, 0, 1), corner(1, 1, 1), corner(1, 1, 0)}, of);  // x high
    }

    std::unique_ptr<PatchMesh> mesh(float size) const {
        return std::make_unique<PatchMesh>(positions, faces, size, size);
    }
};

/// A square of edge 1 in the plane z, its front towards +z or -z.
inline std::vector<Vec3f> square(float z, bool up) {
    if (up) return {{0, 0, z}, {1, 0, z}, {1, 1, z}, {0, 1, z}};
    return {{0, 0, z}, {0, 1, z}, {1, 1, z}, {1, 0, z}};
}

}  // namespace radlab::test

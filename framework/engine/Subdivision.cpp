#include "engine/Subdivision.h"

#include <cmath>

#include "base/Error.h"
#include "engine/Scattering.h"

namespace radlab::engine {

namespace {

// The patches of a mesh as the faces of a scene.
Scene sceneOf(const Scene& scene, const PatchMesh& mesh) {
    Scene made;
    made.file = scene.file;
    for (const MyVertex& corner : mesh.corners) made.vertices.push_back(corner.position);
    for (std::size_t i = 0; i < mesh.patches.size(); ++i) {
        const MyPolygon& patch = mesh.patches[i];
        Face face = scene.faces[static_cast<std::size_t>(mesh.faceOf[i])];
        face.corners.assign(patch.vertex, patch.vertex + patch.vertices);
        made.faces.push_back(std::move(face));
    }
    return made;
}

}  // namespace

Subdivision subdivide(const Scene& scene, const PatchMesh& mesh, double patchSize, int times) {
    const Scene patches = sceneOf(scene, mesh);
    const auto size = static_cast<float>(patchSize / times);
    Subdivision fine;
    fine.mesh = std::make_unique<PatchMesh>(patches.vertices, patches.faces, size, size);
    fine.geometry = geometryOf(patches, *fine.mesh);
    fine.geometry.faces = geometryOf(scene).faces;
    fine.surfaces = surfacesOf(*fine.mesh, scatteringsOf(patches));
    fine.coarseOf = fine.geometry.faceOf;
    for (std::size_t& face : fine.geometry.faceOf) face = static_cast<std::size_t>(mesh.faceOf[face]);
    return fine;
}

double relativeError(const std::vector<Point>& found, const Subdivision& fine, const std::vector<Point>& truth) {
    RADLAB_CHECK(truth.size() == fine.coarseOf.size());
    double error = 0.0, all = 0.0;
    for (std::size_t i = 0; i < truth.size(); ++i) {
        const double area = fine.geometry.patches[i].area;
        const Point off = found[fine.coarseOf[i]] - truth[i];
        error += area * glm::dot(off, off);
        all += area * glm::dot(truth[i], truth[i]);
    }
    return all > 0.0 ? std::sqrt(error / all) : 0.0;
}

}  // namespace radlab::engine

#include "engine/Subdivision.h"

#include "engine/RelativeError.h"
#include "engine/Scattering.h"

namespace radlab::engine {

namespace {

constexpr float coplanar = 1e-3f;  // radians: patches of one face share their corners on, those at creases do not

// The patches of a mesh as the faces of a scene.
Scene sceneOf(const Scene& scene, const PatchMesh& mesh) {
    Scene made;
    made.file = scene.file;
    for (const MyVertex& corner : mesh.corners) made.vertices.push_back(corner.position);
    for (std::size_t i = 0; i < mesh.patches.size(); ++i) {
        const MyPolygon& patch = mesh.patches[i];
        Face face = scene.faces[static_cast<std::size_t>(mesh.faceOf[i])];
        face.corners.assign(patch.vertex, patch.vertex + patch.vertices);
        face.creaseAngle = coplanar;
        made.faces.push_back(std::move(face));
    }
    return made;
}

}  // namespace

Subdivision subdivide(const Scene& scene, const PatchMesh& mesh, double patchSize, double splits) {
    const Scene patches = sceneOf(scene, mesh);
    const auto size = static_cast<float>(patchSize / splits);
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
    std::vector<Point> spread;
    for (const std::size_t patch : fine.coarseOf) spread.push_back(found.at(patch));
    return relativeError(areasOf(fine.geometry), spread, truth);
}

}  // namespace radlab::engine

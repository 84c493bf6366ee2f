#include "study/StudyMesh.h"

#include <cmath>

#include "scene/Effects.h"

namespace radlab::study {

namespace {

constexpr float coplanar = 1e-3f;  // radians: patches of one face share their corners on, those at creases do not

std::vector<Vec3f> positionsOf(const PatchMesh& mesh) {
    std::vector<Vec3f> positions;
    for (const MyVertex& corner : mesh.corners) positions.push_back(corner.position);
    return positions;
}

// The patches as faces.
std::vector<Face> facesOf(const StudyMesh& coarse) {
    std::vector<Face> faces;
    for (std::size_t i = 0; i < coarse.mesh.patches.size(); ++i) {
        const MyPolygon& patch = coarse.mesh.patches[i];
        Face face = coarse.scene.faces[coarse.geometry.faceOf[i]];
        face.corners.assign(patch.vertex, patch.vertex + patch.vertices);
        face.creaseAngle = coplanar;
        faces.push_back(std::move(face));
    }
    return faces;
}

// Its faces are the scene's: fewer than patches, so that little has to be looked for between two of them.
engine::Geometry geometryOf(const StudyMesh& coarse, const PatchMesh& fine) {
    Scene patches;
    patches.vertices = positionsOf(coarse.mesh);
    patches.faces = facesOf(coarse);
    engine::Geometry geometry = engine::geometryOf(patches, fine);
    geometry.faces = coarse.geometry.faces;
    for (std::size_t& face : geometry.faceOf) face = coarse.geometry.faceOf[face];
    return geometry;
}

}  // namespace

double patchSizeFor(const Scene& scene, double patches) {
    double area = 0.0;
    for (const engine::Polygon& face : engine::geometryOf(scene).faces) area += face.area;
    return std::sqrt(area / patches);
}

StudyMesh::StudyMesh(const Scene& whole, double size)
    : scene(whole),
      patchSize(size),
      mesh(whole.vertices, whole.faces, static_cast<float>(size), static_cast<float>(size)),
      geometry(engine::geometryOf(whole, mesh)),
      surfaces(engine::surfacesOf(mesh)),
      occlusion(findEffects(whole).has(Effect::occlusion)) {}

engine::TracedScene StudyMesh::traced() const {
    std::vector<engine::Scattering> scatterings(scene.faces.size());
    for (std::size_t i = 0; i < scatterings.size(); ++i) {
        scatterings[i].emission = engine::Point(scene.faces[i].material->emissive);
        scatterings[i].diffuse = engine::Point(scene.faces[i].material->diffuse);
    }
    return {geometry, std::move(scatterings)};
}

FineMesh::FineMesh(const StudyMesh& coarse, double splits)
    : mesh(positionsOf(coarse.mesh), facesOf(coarse), static_cast<float>(coarse.patchSize / splits),
           static_cast<float>(coarse.patchSize / splits)),
      geometry(geometryOf(coarse, mesh)),
      surfaces(engine::surfacesOf(mesh)) {}

}  // namespace radlab::study

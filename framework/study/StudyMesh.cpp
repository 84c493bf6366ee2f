#include "study/StudyMesh.h"

#include "scene/Effects.h"

namespace radlab::study {

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

}  // namespace radlab::study

#include "export/SolvedMesh.h"

#include <map>
#include <numbers>
#include <unordered_map>

#include "base/Error.h"

namespace radlab {

namespace {

class MeshMaker {
public:
    MeshMaker(const Scene& cutScene, const PatchMesh& cutMesh, const engine::PatchShading& chosenShading)
        : scene(cutScene), mesh(cutMesh), shading(chosenShading) {}

    void add(std::size_t patch, const engine::Point& radiosity) {
        const std::size_t index = partOf(scene.faces[static_cast<std::size_t>(mesh.faceOf[patch])]);
        MeshPatch made;
        made.vertices = mesh.patches[patch].vertices;
        made.radiosity = Vec3f(radiosity);
        for (int k = 0; k < made.vertices; ++k)
            made.vertex[static_cast<std::size_t>(k)] = vertexOf(index, patch, static_cast<std::size_t>(k));
        result.parts[index].patches.push_back(made);
    }

    SolvedMesh result;

private:
    using Key = std::pair<const Material*, bool>;

    std::size_t partOf(const Face& face) {
        const auto [found, isNew] = parts.try_emplace(Key(face.material.get(), face.twoSided), result.parts.size());
        if (isNew) {
            result.parts.push_back({face.material, face.twoSided, {}, {}});
            shared.emplace_back();
        }
        return found->second;
    }

    std::uint32_t vertexOf(std::size_t part, std::size_t patch, std::size_t k) {
        const int corner = mesh.patches[patch].vertex[k];
        if (!shading.isSmooth(patch)) return newVertex(part, patch, k);
        const auto found = shared[part].find(corner);
        return found != shared[part].end() ? found->second : shared[part][corner] = newVertex(part, patch, k);
    }

    std::uint32_t newVertex(std::size_t part, std::size_t patch, std::size_t k) {
        std::vector<MeshVertex>& vertices = result.parts[part].vertices;
        const Vec3f radiosity(shading.radiosityAtCorner(patch, k));
        const Vec3f position = mesh.corners[static_cast<std::size_t>(mesh.patches[patch].vertex[k])].position;
        const glm::vec3 shown = result.exposure * radiosity * std::numbers::inv_pi_v<float>;
        vertices.push_back({position, glm::clamp(shown, 0.0f, 1.0f), radiosity});
        return static_cast<std::uint32_t>(vertices.size() - 1);
    }

    const Scene& scene;
    const PatchMesh& mesh;
    const engine::PatchShading& shading;
    std::map<Key, std::size_t> parts;
    std::vector<std::unordered_map<int, std::uint32_t>> shared;  // of each part, by corner of the mesh
};

}  // namespace

SolvedMesh solvedMesh(const Scene& scene, const PatchMesh& mesh, const std::vector<engine::Point>& radiosity,
                      const engine::PatchShading& shading, float exposure) {
    RADLAB_CHECK(radiosity.size() == mesh.patches.size());
    RADLAB_CHECK(exposure > 0.0f);
    MeshMaker maker(scene, mesh, shading);
    maker.result.exposure = exposure;
    maker.result.cameras = scene.cameras;
    if (scene.cameras.empty()) maker.result.cameras.emplace_back();  // from where the picture is seen
    for (std::size_t i = 0; i < mesh.patches.size(); ++i) maker.add(i, radiosity[i]);
    return std::move(maker.result);
}

}  // namespace radlab

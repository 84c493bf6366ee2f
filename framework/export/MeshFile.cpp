#include "export/MeshFile.h"

#include "base/Error.h"

namespace radlab {

bool isMeshFile(const std::filesystem::path& file) {
    const std::string ending = file.extension().string();
    return ending == ".glb" || ending == ".gltf" || ending == ".ply";
}

void writeMesh(const std::filesystem::path& file, const SolvedMesh& mesh) {
    if (!isMeshFile(file))
        throw Error({file.string()}, "unknown kind of mesh: found the ending '" + file.extension().string() +
                                         "', expected .glb, .gltf or .ply");
    if (file.extension() == ".ply") return writePly(file, mesh);
    writeGltf(file, mesh, file.extension() == ".glb");
}

}  // namespace radlab

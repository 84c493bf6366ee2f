#include <ostream>

#include "base/WholeFile.h"
#include "display/ToneMap.h"
#include "export/LittleEndian.h"
#include "export/MeshFile.h"

namespace radlab {

namespace {

std::string header(std::size_t vertices, std::size_t faces) {
    return "ply\nformat binary_little_endian 1.0\ncomment radlab " RADLAB_VERSION
           ": colours are sRGB, radiosities W/m2\nelement vertex " +
           std::to_string(vertices) +
           "\nproperty float x\nproperty float y\nproperty float z\nproperty uchar red\nproperty uchar green\n"
           "property uchar blue\nelement face " +
           std::to_string(faces) +
           "\nproperty list uchar int vertex_indices\nproperty float radiosity_r\nproperty float radiosity_g\n"
           "property float radiosity_b\nend_header\n";
}

std::string bytesOf(const MeshVertex& vertex) {
    std::string bytes;
    appendBytes(bytes, vertex.position);
    for (int c = 0; c < 3; ++c) bytes += static_cast<char>(srgbFromLinear(vertex.color[c]) * 255.0f + 0.5f);
    return bytes;
}

std::string bytesOf(const MeshPatch& patch, std::size_t firstVertex) {
    std::string bytes(1, static_cast<char>(patch.vertices));
    for (std::size_t k = 0; k < static_cast<std::size_t>(patch.vertices); ++k)
        appendBytes(bytes, static_cast<std::uint32_t>(firstVertex + patch.vertex[k]));
    appendBytes(bytes, patch.radiosity);
    return bytes;
}

}  // namespace

void writePly(const std::filesystem::path& file, const SolvedMesh& mesh) {
    std::size_t vertices = 0, faces = 0;
    for (const MeshPart& part : mesh.parts) {
        vertices += part.vertices.size();
        faces += part.patches.size();
    }
    writeFile(file, [&](std::ostream& out) {
        out << header(vertices, faces);
        for (const MeshPart& part : mesh.parts)
            for (const MeshVertex& vertex : part.vertices) out << bytesOf(vertex);
        std::size_t first = 0;
        for (const MeshPart& part : mesh.parts) {
            for (const MeshPatch& patch : part.patches) out << bytesOf(patch, first);
            first += part.vertices.size();
        }
    });
}

}  // namespace radlab

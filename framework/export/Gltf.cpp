#include <cmath>
#include <limits>
#include <ostream>

#include <glm/gtc/quaternion.hpp>

#include "base/Error.h"
#include "base/WholeFile.h"
#include "export/Base64.h"
#include "export/GltfBuffer.h"
#include "export/LittleEndian.h"
#include "export/MeshFile.h"

namespace radlab {

namespace {

using nlohmann::ordered_json;

// White, as glTF multiplies it with the colours of the vertices, which have ρ in them.
ordered_json materialOf(const MeshPart& part, std::size_t index) {
    const Material& material = *part.material;
    const float brightest = std::max({1.0f, material.emissive.r, material.emissive.g, material.emissive.b});
    ordered_json made = {{"name", material.name.empty() ? "material " + std::to_string(index) : material.name},
                         {"pbrMetallicRoughness",
                          {{"baseColorFactor", {1.0, 1.0, 1.0, 1.0f - material.transparency}},
                           {"metallicFactor", 0.0},
                           {"roughnessFactor", 1.0}}},
                         {"emissiveFactor", jsonOf(material.emissive / brightest)},
                         {"doubleSided", part.twoSided},
                         {"extensions", {{"KHR_materials_unlit", ordered_json::object()}}},
                         {"extras",
                          {{"reflectance", jsonOf(material.diffuse)},
                           {"emission_W_per_m2", jsonOf(material.emissive)},
                           {"specular", jsonOf(material.specular)},
                           {"shininess", material.shininess},
                           {"transparency", material.transparency}}}};
    if (material.transparency > 0.0f) made["alphaMode"] = "BLEND";
    return made;
}

ordered_json primitiveOf(const MeshPart& part, std::size_t material, GltfBuffer& buffer) {
    const float opaque = 1.0f - part.material->transparency;
    // Who draws a pane multiplies its colour with this share, which B has in it already.
    const auto colorOf = [&](const MeshVertex& vertex) {
        return opaque > 0.0f ? glm::min(vertex.color / opaque, 1.0f) : vertex.color;
    };
    return {{"attributes",
             {{"POSITION", buffer.addVectors(part.vertices, &MeshVertex::position)},
              {"COLOR_0", buffer.addVectors(part.vertices, colorOf)},
              {"_RADIOSITY", buffer.addVectors(part.vertices, &MeshVertex::radiosity)}}},
            {"indices", buffer.addTriangles(part)},
            {"material", material},
            {"mode", 4}};
}

// The length of the diagonal of the box about all vertices.
float sizeOf(const SolvedMesh& mesh) {
    Vec3f low(std::numeric_limits<float>::max()), high = -low;
    for (const MeshPart& part : mesh.parts)
        for (const MeshVertex& vertex : part.vertices) {
            low = glm::min(low, vertex.position);
            high = glm::max(high, vertex.position);
        }
    return glm::length(high - low);
}

ordered_json cameraOf(const Camera& camera, float near) {
    constexpr float widest = 3.1f;  // glTF wants less than π
    ordered_json made = {
        {"type", "perspective"},
        {"perspective", {{"yfov", std::min(camera.fieldOfView, widest)}, {"znear", near}}},
    };
    if (!camera.name.empty()) made["name"] = camera.name;
    return made;
}

ordered_json nodeOf(const Camera& camera, std::size_t index) {
    const Vec3f right = glm::normalize(glm::cross(camera.direction, camera.up));
    const glm::quat turn = glm::normalize(glm::quat_cast(glm::mat3(right, camera.up, -camera.direction)));
    return {{"name", camera.name.empty() ? "camera " + std::to_string(index) : camera.name},
            {"camera", index},
            {"translation", jsonOf(camera.position)},
            {"rotation", {turn.x, turn.y, turn.z, turn.w}}};
}

ordered_json documentOf(const SolvedMesh& mesh, GltfBuffer& buffer) {
    ordered_json primitives, materials, cameras, nodes, roots;
    nodes.push_back({{"name", "radiosity"}, {"mesh", 0}});
    roots.push_back(0);
    for (std::size_t i = 0; i < mesh.parts.size(); ++i) {
        primitives.push_back(primitiveOf(mesh.parts[i], i, buffer));
        materials.push_back(materialOf(mesh.parts[i], i));
    }
    const float near = std::max(1e-3f * sizeOf(mesh), std::numeric_limits<float>::min());
    for (std::size_t i = 0; i < mesh.cameras.size(); ++i) {
        cameras.push_back(cameraOf(mesh.cameras[i], near));
        roots.push_back(nodes.size());
        nodes.push_back(nodeOf(mesh.cameras[i], i));
    }
    return {{"asset", {{"version", "2.0"}, {"generator", "radlab " RADLAB_VERSION}}},
            {"extensionsUsed", {"KHR_materials_unlit"}},
            {"scene", 0},
            {"scenes", {{{"nodes", roots}, {"extras", {{"exposure", mesh.exposure}}}}}},
            {"nodes", nodes},
            {"cameras", cameras},
            {"materials", materials},
            {"meshes", {{{"name", "radiosity"}, {"primitives", primitives}}}},
            {"accessors", buffer.accessors},
            {"bufferViews", buffer.views},
            {"buffers", {{{"byteLength", buffer.bytes.size()}}}}};
}

std::string textOf(const ordered_json& document) {
    return document.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
}

void writeBinary(const std::filesystem::path& file, std::string json, const std::string& bytes) {
    constexpr std::uint32_t magic = 0x46546C67, version = 2, ofJson = 0x4E4F534A, ofBytes = 0x004E4942;
    constexpr std::size_t headers = 12 + 8 + 8;
    while (json.size() % 4 != 0) json += ' ';
    const std::size_t length = headers + json.size() + bytes.size();
    if (length > std::numeric_limits<std::uint32_t>::max())
        throw Error({file.string()}, "the mesh is too large for .glb: found " + std::to_string(length) +
                                         " bytes, expected less than 4 GiB (larger patches, or .ply)");
    std::string start, middle;
    for (const std::size_t word : {std::size_t{magic}, std::size_t{version}, length, json.size(), std::size_t{ofJson}})
        appendBytes(start, static_cast<std::uint32_t>(word));
    appendBytes(middle, static_cast<std::uint32_t>(bytes.size()));
    appendBytes(middle, ofBytes);
    writeFile(file, [&](std::ostream& out) { out << start << json << middle << bytes; });
}

}  // namespace

void writeGltf(const std::filesystem::path& file, const SolvedMesh& mesh, bool binary) {
    GltfBuffer buffer;
    ordered_json document = documentOf(mesh, buffer);
    if (binary) return writeBinary(file, textOf(document), buffer.bytes);
    document["buffers"][0]["uri"] = "data:application/octet-stream;base64," + base64(buffer.bytes);
    writeFile(file, textOf(document));
}

}  // namespace radlab

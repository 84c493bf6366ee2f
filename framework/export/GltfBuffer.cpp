#include "export/GltfBuffer.h"

#include "export/LittleEndian.h"

namespace radlab {

namespace {

// glTF's own numbers.
constexpr int unsignedShort = 5123, unsignedInt = 5125, floatNumber = 5126;
constexpr int vertexData = 34962, indexData = 34963;
constexpr std::size_t mostForShorts = 65535;  // the greatest index is not allowed

template <class Visit>
void forTriangles(const MeshPart& part, const Visit& visit) {
    for (const MeshPatch& patch : part.patches)
        for (std::size_t k = 1; k + 1 < static_cast<std::size_t>(patch.vertices); ++k)
            for (const std::size_t corner : {std::size_t{0}, k, k + 1}) visit(patch.vertex[corner]);
}

}  // namespace

nlohmann::ordered_json jsonOf(const Vec3f& v) { return {v.x, v.y, v.z}; }

std::size_t GltfBuffer::add(std::size_t from, int target, nlohmann::ordered_json accessor) {
    views.push_back({{"buffer", 0}, {"byteOffset", from}, {"byteLength", bytes.size() - from}, {"target", target}});
    accessor["bufferView"] = views.size() - 1;
    accessors.push_back(std::move(accessor));
    while (bytes.size() % 4 != 0) bytes += '\0';
    return accessors.size() - 1;
}

std::size_t GltfBuffer::addVectors(const std::vector<MeshVertex>& vertices,
                                   const std::function<Vec3f(const MeshVertex&)>& vectorOf) {
    const std::size_t from = bytes.size();
    Vec3f low = vectorOf(vertices.front()), high = low;
    for (const MeshVertex& vertex : vertices) {
        const Vec3f vector = vectorOf(vertex);
        low = glm::min(low, vector);
        high = glm::max(high, vector);
        appendBytes(bytes, vector);
    }
    return add(from, vertexData,
               {{"componentType", floatNumber},
                {"count", vertices.size()},
                {"type", "VEC3"},
                {"min", jsonOf(low)},
                {"max", jsonOf(high)}});
}

std::size_t GltfBuffer::addTriangles(const MeshPart& part) {
    const std::size_t from = bytes.size();
    const bool isShort = part.vertices.size() <= mostForShorts;
    std::size_t count = 0;
    std::uint32_t low = part.patches.front().vertex[0], high = low;
    forTriangles(part, [&](std::uint32_t index) {
        ++count;
        low = std::min(low, index);
        high = std::max(high, index);
        if (isShort)
            appendBytes(bytes, static_cast<std::uint16_t>(index));
        else
            appendBytes(bytes, index);
    });
    return add(from, indexData,
               {{"componentType", isShort ? unsignedShort : unsignedInt},
                {"count", count},
                {"type", "SCALAR"},
                {"min", {low}},
                {"max", {high}}});
}

}  // namespace radlab

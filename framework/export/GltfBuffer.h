#pragma once

#include <functional>
#include <string>

#include <nlohmann/json.hpp>

#include "export/SolvedMesh.h"

namespace radlab {

/// A vector as glTF writes it.
nlohmann::ordered_json jsonOf(const Vec3f& v);

/// The numbers of a glTF file, and the JSON that says where each kind of them lies.
struct GltfBuffer {
    std::string bytes;
    nlohmann::ordered_json views = nlohmann::ordered_json::array(), accessors = views;

    /// Adds a vector of each vertex.
    ///
    /// @return the index of the accessor, which has the least and the greatest value
    std::size_t addVectors(const std::vector<MeshVertex>& vertices,
                           const std::function<Vec3f(const MeshVertex&)>& vectorOf);

    /// Adds the corners of the patches' triangles, in as few bytes as the number of vertices lets them have.
    ///
    /// @return the index of the accessor
    std::size_t addTriangles(const MeshPart& part);

private:
    // Adds an accessor to what was appended since `from`.
    std::size_t add(std::size_t from, int target, nlohmann::ordered_json accessor);
};

}  // namespace radlab

#pragma once

#include <cstddef>
#include <vector>

#include "engine/Polygon.h"

namespace radlab::engine {

/// The edges of faces, and which face goes on beyond each.
class FaceEdges {
public:
    static constexpr std::size_t none = static_cast<std::size_t>(-1);

    struct Edge {
        Point from, to;
        std::size_t beyond = none;  ///< the other face with this edge; none where there is no other, or more than one
        bool turned = false;        ///< whether that face has its front on the other side
    };

    FaceEdges() = default;

    /// @param has  whether a face is looked at: else it has no edges, and is beyond none
    /// @cost n log n for all edges
    FaceEdges(const std::vector<Polygon>& faces, const std::vector<bool>& has);

    const std::vector<Edge>& of(std::size_t face) const { return edges[face]; }

private:
    std::vector<std::vector<Edge>> edges;
};

}  // namespace radlab::engine

#pragma once

#include <cstdint>
#include <vector>

#include "engine/Geometry.h"

namespace radlab::engine {

/// The patches of every face in a binary tree: clusters that can stand for their patches from afar.
///
/// Leaves are the patches, with their numbers; then come the clusters of two nodes each, children before parents.
class PatchTree {
public:
    static constexpr std::uint32_t none = ~0u;

    struct Node {
        std::uint32_t parent = none;
        std::uint32_t first = none, second = none;  ///< children; none for a patch
    };

    /// Splits the patches of each face in halves across their longer side, where a line of the mesh runs.
    ///
    /// @cost n log n for the patches of a face, faces side by side; half a KiB for each patch
    explicit PatchTree(const Geometry& geometry);

    std::size_t leaves() const { return leafCount; }
    std::size_t size() const { return nodes.size(); }
    const Node& node(std::size_t i) const { return nodes[i]; }
    bool isLeaf(std::size_t i) const { return i < leafCount; }
    /// One for each face that has patches with an area.
    const std::vector<std::uint32_t>& roots() const { return faceRoots; }
    /// The area of a node's patches.
    double area(std::size_t i) const { return areas[i]; }
    /// The nodes as patches: a patch's own outline, or the convex hull of a cluster's patches.
    const Geometry& shapes() const { return outlines; }

    /// Gives every cluster the mean of its patches' values, weighted by area.
    ///
    /// @param values of the patches, or of all nodes
    template <class Value>
    void pull(std::vector<Value>& values) const {
        values.resize(size());
        for (std::size_t i = leafCount; i < size(); ++i) {
            const std::uint32_t a = nodes[i].first, b = nodes[i].second;
            values[i] = (areas[a] * values[a] + areas[b] * values[b]) / areas[i];
        }
    }
    /// Adds the value of every cluster to each of its patches.
    void push(std::vector<double>& values) const;

private:
    friend class TreeBuilder;

    std::size_t leafCount = 0;
    std::vector<Node> nodes;
    std::vector<double> areas;
    std::vector<std::uint32_t> faceRoots;
    Geometry outlines;
};

}  // namespace radlab::engine

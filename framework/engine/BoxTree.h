#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "engine/Polygon.h"

namespace radlab::engine {

/// A box along the axes; holds nothing until something is added.
struct Box {
    Point low{std::numeric_limits<double>::infinity()}, high{-std::numeric_limits<double>::infinity()};

    void add(const Point& point) {
        low = glm::min(low, point);
        high = glm::max(high, point);
    }
    void add(const Box& other) {
        low = glm::min(low, other.low);
        high = glm::max(high, other.high);
    }
    /// Whether two boxes meet, or are no farther apart than `slack` along any axis.
    bool meets(const Box& other, double slack = 0.0) const {
        return low.x <= other.high.x + slack && other.low.x <= high.x + slack && low.y <= other.high.y + slack &&
               other.low.y <= high.y + slack && low.z <= other.high.z + slack && other.low.z <= high.z + slack;
    }
};

/// The box around a polygon's corners.
Box boxOf(const Polygon& polygon);

/// Things in boxes, found by the boxes around several of them.
class BoxTree {
public:
    BoxTree() = default;

    /// @param boxes  of the things, which are called by their place here; what has an empty box is never found
    /// @cost n log² n
    explicit BoxTree(const std::vector<Box>& boxes);

    /// Goes through the things, always in the same order.
    ///
    /// @param enters  says of a box whether anything in it is looked for
    /// @param visits  takes a thing whose box, or one around it, was entered; says whether to go on
    template <class Enters, class Visits>
    void visit(const Enters& enters, const Visits& visits) const {
        for (std::size_t i = 0; i < nodes.size();) {
            const Node& node = nodes[i];
            if (!enters(node.box)) {
                i = node.after;
                continue;
            }
            for (std::uint32_t k = node.begin; k < node.end; ++k)
                if (!visits(things[k])) return;
            ++i;
        }
    }

private:
    struct Node {
        Box box;
        std::uint32_t begin = 0, end = 0;  // things of a leaf
        std::uint32_t after = 0;           // the node that follows this one and those below it
    };
    void build(const std::vector<Box>& boxes, std::uint32_t begin, std::uint32_t end);

    std::vector<Node> nodes;  // parents before children
    std::vector<std::uint32_t> things;
};

}  // namespace radlab::engine

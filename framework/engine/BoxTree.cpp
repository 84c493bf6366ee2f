#include "engine/BoxTree.h"

#include <algorithm>

namespace radlab::engine {

namespace {

constexpr std::uint32_t mostInLeaf = 2;

}  // namespace

Box boxOf(const Polygon& polygon) {
    Box box;
    for (const Point& corner : polygon.corners) box.add(corner);
    return box;
}

BoxTree::BoxTree(const std::vector<Box>& boxes) {
    for (std::uint32_t i = 0; i < boxes.size(); ++i)
        if (boxes[i].low.x <= boxes[i].high.x) things.push_back(i);
    if (!things.empty()) build(boxes, 0, static_cast<std::uint32_t>(things.size()));
}

void BoxTree::build(const std::vector<Box>& boxes, std::uint32_t begin, std::uint32_t end) {
    const std::size_t self = nodes.size();
    nodes.emplace_back();
    Box box, centers;
    for (std::uint32_t k = begin; k < end; ++k) {
        const Box& one = boxes[things[k]];
        box.add(one);
        centers.add(one.low + one.high);
    }
    nodes[self].box = box;
    if (end - begin <= mostInLeaf) {
        nodes[self].begin = begin;
        nodes[self].end = end;
    } else {
        const Point extent = centers.high - centers.low;
        const int axis = extent.x >= std::max(extent.y, extent.z) ? 0 : extent.y >= extent.z ? 1 : 2;
        const auto place = [&](std::uint32_t i) { return boxes[i].low[axis] + boxes[i].high[axis]; };
        const std::uint32_t middle = begin + (end - begin) / 2;
        std::nth_element(
            things.begin() + begin, things.begin() + middle, things.begin() + end,
            [&](std::uint32_t i, std::uint32_t j) { return place(i) != place(j) ? place(i) < place(j) : i < j; });
        build(boxes, begin, middle);
        build(boxes, middle, end);
    }
    nodes[self].after = static_cast<std::uint32_t>(nodes.size());
}

}  // namespace radlab::engine

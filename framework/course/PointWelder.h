#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "course/FacePolygon.h"

namespace radlab {

/// Gives points of a plane the same number where they are the same up to rounding.
class PointWelder {
public:
    explicit PointWelder(double tolerance) : cell(tolerance) {}

    int indexOf(const glm::dvec2& point) {
        const std::int64_t x = std::llround(point.x / cell), y = std::llround(point.y / cell);
        for (std::int64_t i = x - 1; i <= x + 1; ++i)
            for (std::int64_t j = y - 1; j <= y + 1; ++j)
                if (const auto found = indices.find(key(i, j)); found != indices.end()) return found->second;
        indices.emplace(key(x, y), static_cast<int>(points.size()));
        points.push_back(point);
        return static_cast<int>(points.size()) - 1;
    }

    /// The polygon with every corner replaced by the first point that was the same, and without repeated corners.
    Polygon2 welded(const Polygon2& polygon) {
        Polygon2 result;
        for (const glm::dvec2& corner : polygon) {
            const glm::dvec2& point = points[static_cast<std::size_t>(indexOf(corner))];
            if (std::find(result.begin(), result.end(), point) == result.end()) result.push_back(point);
        }
        return result;
    }

    std::vector<int> indicesOf(const Polygon2& polygon) {
        std::vector<int> numbers;
        for (const glm::dvec2& corner : polygon) numbers.push_back(indexOf(corner));
        return numbers;
    }

    std::vector<glm::dvec2> points;

private:
    static std::uint64_t key(std::int64_t x, std::int64_t y) {
        return (static_cast<std::uint64_t>(x) << 32) ^ (static_cast<std::uint64_t>(y) & 0xffffffffu);
    }

    double cell;
    std::unordered_map<std::uint64_t, int> indices;
};

}  // namespace radlab

#include "study/ParetoFront.h"

#include <algorithm>
#include <numeric>

namespace radlab::study {

std::vector<std::size_t> paretoFront(const std::vector<glm::dvec2>& points) {
    std::vector<std::size_t> order(points.size()), front;
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return points[a].x != points[b].x ? points[a].x < points[b].x : points[a].y < points[b].y;
    });
    for (const std::size_t i : order)
        if (front.empty() || points[i].y < points[front.back()].y) front.push_back(i);
    return front;
}

std::vector<const Measurement*> bestRows(const std::vector<const Measurement*>& rows, const ErrorKind& error) {
    std::vector<const Measurement*> known, best;
    std::vector<glm::dvec2> points;
    for (const Measurement* row : rows) {
        const auto its = error.of(*row);
        if (!its) continue;
        known.push_back(row);
        points.emplace_back(row->seconds, *its);
    }
    for (const std::size_t i : paretoFront(points)) best.push_back(known[i]);
    return best;
}

const Measurement* quickestFor(const std::vector<const Measurement*>& rows, const ErrorKind& error, double most) {
    for (const Measurement* row : bestRows(rows, error))
        if (*error.of(*row) <= most) return row;
    return nullptr;
}

}  // namespace radlab::study

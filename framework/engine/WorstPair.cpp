#include "engine/WorstPair.h"

#include <algorithm>
#include <cmath>

#include "base/Interrupts.h"
#include "engine/ExchangeArea.h"
#include "engine/PointFormFactor.h"

namespace radlab::engine {

namespace {

constexpr std::size_t mostRows = 256;
constexpr double worthTelling = 0.05;

// The patch that is nearest for its size and faces one; that one itself where there is none.
std::size_t nearestOf(const std::vector<Polygon>& patches, std::size_t from) {
    std::size_t nearest = from;
    double least = INFINITY;
    for (std::size_t j = 0; j < patches.size(); ++j) {
        if (j == from || !(patches[j].area > 0.0)) continue;
        const double distance =
            glm::length(patches[j].center - patches[from].center) / (patches[j].radius + patches[from].radius);
        if (distance >= least || !faceEachOther(patches[from], patches[j])) continue;
        least = distance;
        nearest = j;
    }
    return nearest;
}

}  // namespace

std::optional<WorstPair> worstPair(const Geometry& geometry, Method method) {
    if (method != Method::point && method != Method::polygon && method != Method::hemicube) return std::nullopt;
    const std::vector<Polygon>& patches = geometry.patches;
    const std::size_t step = std::max<std::size_t>(1, patches.size() / mostRows);
    WorstPair worst;
    for (std::size_t i = 0; i < patches.size(); i += step) {
        Interrupts::check();
        const std::size_t j = nearestOf(patches, i);
        if (j == i || !(patches[i].area > 0.0)) continue;
        const double found = method == Method::point ? pointToPoint(patches[i], patches[j])
                                                     : pointToPolygon(patches[i].center, patches[i].normal, patches[j]);
        const double exact = exchangeArea(patches[i], patches[j], 1e-4) / patches[i].area;
        if (std::abs(found - exact) > std::abs(worst.found - worst.exact)) worst = {i, j, found, exact};
    }
    return std::abs(worst.found - worst.exact) < worthTelling ? std::nullopt : std::optional(worst);
}

}  // namespace radlab::engine

#include "engine/Visibility.h"

#include <algorithm>

#include "base/Interrupts.h"
#include "engine/LowDiscrepancy.h"

namespace radlab::engine {

namespace {

constexpr std::size_t fewestRays = 16;
// Pieces of faces that a ray is tested against one by one; for more, a tree is faster.
constexpr std::size_t mostTested = 12;
constexpr std::size_t decidingRays = 16;  // where there are more

double passing(const Blockers& between, const Point& from, const Point& to) {
    double share = 1.0;
    for (const Blocker* blocker : between) {
        if (blocker->meets(from, to)) share *= blocker->through();
        if (share == 0.0) return 0.0;
    }
    return share;
}

}  // namespace

Visibility::Visibility(const Geometry& shapes, std::size_t most, std::uint64_t seed)
    : geometry(shapes), mostRays(std::max(most, fewestRays)), firstKey(seed << 48), shafts(geometry) {
    if (geometry.faces.size() > mostTested) scene = std::make_unique<RayScene>(geometry.faces);
    for (const Polygon& patch : geometry.patches) samplers.emplace_back(patch);
}

double Visibility::visibleShare(std::size_t first, std::size_t second, std::size_t rays) const {
    thread_local Blockers between;
    const Sight found = sight(first, second, between);
    if (found != Sight::partly) return found == Sight::clear ? 1.0 : 0.0;
    return sharePast(between, first, second, rays);
}

Sight Visibility::sight(std::size_t first, std::size_t second) const {
    thread_local Blockers between;
    return sight(first, second, between);
}

Sight Visibility::sight(std::size_t first, std::size_t second, Blockers& between) const {
    return scene ? shafts.sight(first, second, between, mostTested) : shafts.sight(first, second, between);
}

double Visibility::sharePast(const Blockers& between, std::size_t first, std::size_t second, std::size_t rays) const {
    if (!scene || between.size() <= mostTested)
        return shareByRays(first, second, rays, rays,
                           [&](const Point& from, const Point& to) { return passing(between, from, to); });
    const std::size_t faceA = geometry.faceOf[first], faceB = geometry.faceOf[second];
    return shareByRays(first, second, rays, decidingRays, [&](const Point& from, const Point& to) {
        return scene->transmittance(from, to, faceA, faceB, geometry.through);
    });
}

template <class Share>
double Visibility::shareByRays(std::size_t first, std::size_t second, std::size_t most, std::size_t deciding,
                               const Share& share) const {
    const Polygon &a = geometry.patches[first], &b = geometry.patches[second];
    if (!(a.area > 0.0) || !(b.area > 0.0)) return 1.0;
    const LowDiscrepancy points(firstKey + first * geometry.patches.size() + second);
    double all = 0.0, visible = 0.0;
    std::size_t cast = 0;
    for (std::size_t k = 0; k < 4 * most && cast < most; ++k) {
        Interrupts::check();
        const auto at = points.at(k);
        const Point from = samplers[first].at(at[0], at[1]), to = samplers[second].at(at[2], at[3]);
        const Point line = to - from;
        const double distance2 = glm::dot(line, line);
        const double away = glm::dot(a.normal, line), towards = -glm::dot(b.normal, line);
        if (away <= 0.0 || towards <= 0.0) continue;
        const double carried = away * towards / (distance2 * distance2);
        all += carried;
        visible += share(from, to) * carried;
        if (++cast == deciding && (visible == 0.0 || visible == all)) break;
    }
    traced.fetch_add(cast, std::memory_order_relaxed);
    return all > 0.0 ? visible / all : 1.0;
}

}  // namespace radlab::engine

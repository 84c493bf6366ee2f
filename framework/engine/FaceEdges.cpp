#include "engine/FaceEdges.h"

#include <algorithm>
#include <array>

namespace radlab::engine {

namespace {

// An edge of a face, wherever it starts.
struct Place {
    std::array<double, 6> ends;
    std::size_t face, edge;
    bool backwards;
};

Place placeOf(const FaceEdges::Edge& edge, std::size_t face, std::size_t index) {
    const std::array<double, 6> forwards = {edge.from.x, edge.from.y, edge.from.z, edge.to.x, edge.to.y, edge.to.z},
                                reverse = {edge.to.x, edge.to.y, edge.to.z, edge.from.x, edge.from.y, edge.from.z};
    return {std::min(forwards, reverse), face, index, reverse < forwards};
}

}  // namespace

FaceEdges::FaceEdges(const std::vector<Polygon>& faces, const std::vector<bool>& has) : edges(faces.size()) {
    std::vector<Place> places;
    for (std::size_t face = 0; face < faces.size(); ++face) {
        const std::vector<Point>& corners = faces[face].corners;
        for (std::size_t i = 0; has[face] && i < corners.size(); ++i) {
            edges[face].push_back({corners[i], corners[(i + 1) % corners.size()]});
            places.push_back(placeOf(edges[face].back(), face, i));
        }
    }
    const auto before = [](const Place& one, const Place& other) { return one.ends < other.ends; };
    std::sort(places.begin(), places.end(), before);
    for (auto one = places.begin(); one != places.end();) {
        const auto end = std::upper_bound(one, places.end(), *one, before);
        if (end - one == 2) {
            const Place &first = *one, &second = *(one + 1);
            const bool turned = first.backwards == second.backwards;
            for (const auto& [here, there] : {std::pair(first, second), std::pair(second, first)}) {
                edges[here.face][here.edge].beyond = there.face;
                edges[here.face][here.edge].turned = turned;
            }
        }
        one = end;
    }
}

}  // namespace radlab::engine

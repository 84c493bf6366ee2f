#include "course/CreaseAngle.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <unordered_map>

#include "base/Interrupts.h"

namespace radlab {

namespace {

// Places closer than this share of the surface's extent are the same.
constexpr double samePlace = 1e-6;

// A vertex of a curved surface, with what decides whom it may join.
struct Candidate {
    int vertex;
    const Face* face;
    Vec3f normal;
};

std::vector<Candidate> candidates(const std::vector<Face>& faces, const std::vector<int>& faceOf,
                                  const std::vector<MyVertex>& vertices, const std::vector<MyPolygon>& patches) {
    std::vector<bool> seen(vertices.size(), false);
    std::vector<Candidate> found;
    for (std::size_t i = 0; i < patches.size(); ++i) {
        Interrupts::check();
        const Face& face = faces[static_cast<std::size_t>(faceOf[i])];
        if (face.creaseAngle <= 0.0f) continue;
        for (int k = 0; k < patches[i].vertices; ++k) {
            const auto vertex = static_cast<std::size_t>(patches[i].vertex[k]);
            if (!seen[vertex]) found.push_back({patches[i].vertex[k], &face, patches[i].normal});
            seen[vertex] = true;
        }
    }
    return found;
}

bool mayJoin(const Candidate& a, const Candidate& b) {
    const float allowed = std::min(a.face->creaseAngle, b.face->creaseAngle);
    return a.face->material == b.face->material && dot(a.normal, b.normal) >= std::cos(allowed);
}

// Finds earlier candidates at the same place.
class Places {
public:
    explicit Places(double tolerance) : cell(tolerance) {}

    template <class Visit>
    void visitNear(const Vec3f& position, Visit visit) const {
        const auto [x, y, z] = cellOf(position);
        for (std::int64_t i = x - 1; i <= x + 1; ++i)
            for (std::int64_t j = y - 1; j <= y + 1; ++j)
                for (std::int64_t k = z - 1; k <= z + 1; ++k)
                    if (const auto found = members.find(key(i, j, k)); found != members.end())
                        for (const std::size_t member : found->second) visit(member);
    }

    void add(const Vec3f& position, std::size_t candidate) {
        const auto [x, y, z] = cellOf(position);
        members[key(x, y, z)].push_back(candidate);
    }

private:
    struct Cell {
        std::int64_t x, y, z;
    };
    Cell cellOf(const Vec3f& p) const {
        return {std::llround(double(p.x) / cell), std::llround(double(p.y) / cell), std::llround(double(p.z) / cell)};
    }
    static std::uint64_t key(std::int64_t x, std::int64_t y, std::int64_t z) {
        return static_cast<std::uint64_t>(x) * 73856093u ^ static_cast<std::uint64_t>(y) * 19349663u ^
               static_cast<std::uint64_t>(z) * 83492791u;
    }

    double cell;
    std::unordered_map<std::uint64_t, std::vector<std::size_t>> members;
};

double extent(const std::vector<Candidate>& found, const std::vector<MyVertex>& vertices) {
    Vec3f low = vertices[static_cast<std::size_t>(found[0].vertex)].position, high = low;
    for (const Candidate& candidate : found) {
        const Vec3f& position = vertices[static_cast<std::size_t>(candidate.vertex)].position;
        low = glm::min(low, position);
        high = glm::max(high, position);
    }
    return static_cast<double>(glm::distance(low, high));
}

int rootOf(std::vector<int>& parent, int vertex) {
    while (parent[static_cast<std::size_t>(vertex)] != vertex) vertex = parent[static_cast<std::size_t>(vertex)];
    return vertex;
}

// For each vertex the one that takes its place.
std::vector<int> joined(const std::vector<Candidate>& found, const std::vector<MyVertex>& vertices) {
    std::vector<int> parent(vertices.size());
    std::iota(parent.begin(), parent.end(), 0);
    const double tolerance = samePlace * extent(found, vertices);
    Places places(tolerance);
    for (std::size_t i = 0; i < found.size(); ++i) {
        Interrupts::check();
        const Vec3f& position = vertices[static_cast<std::size_t>(found[i].vertex)].position;
        places.visitNear(position, [&](std::size_t earlier) {
            const Vec3f& other = vertices[static_cast<std::size_t>(found[earlier].vertex)].position;
            if (double(glm::distance(position, other)) > tolerance || !mayJoin(found[i], found[earlier])) return;
            const int a = rootOf(parent, found[i].vertex), b = rootOf(parent, found[earlier].vertex);
            parent[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
        });
        places.add(position, i);
    }
    for (int& vertex : parent) vertex = rootOf(parent, vertex);
    return parent;
}

}  // namespace

void shareWithinCreaseAngle(const std::vector<Face>& faces, const std::vector<int>& faceOf,
                            std::vector<MyVertex>& vertices, std::vector<MyPolygon>& patches) {
    const std::vector<Candidate> found = candidates(faces, faceOf, vertices, patches);
    if (found.empty()) return;
    const std::vector<int> place = joined(found, vertices);
    std::vector<int> number(vertices.size(), -1);
    std::vector<MyVertex> kept;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        if (place[i] != static_cast<int>(i)) continue;
        number[i] = static_cast<int>(kept.size());
        kept.push_back(vertices[i]);
    }
    for (MyPolygon& patch : patches)
        for (int k = 0; k < patch.vertices; ++k) {
            int& corner = patch.vertex[k];
            corner = number[static_cast<std::size_t>(place[static_cast<std::size_t>(corner)])];
        }
    vertices = std::move(kept);
}

}  // namespace radlab

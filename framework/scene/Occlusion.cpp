#include "scene/Occlusion.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <vector>

#include <glm/glm.hpp>

#include "base/Interrupts.h"

namespace radlab {

namespace {

constexpr double relativeTolerance = 1e-5;
constexpr std::size_t blockSize = 64;

struct Corner {
    glm::dvec3 position;
    const Face* face;  // one that has it
};

struct Bounds {
    glm::dvec3 low{std::numeric_limits<double>::infinity()};
    glm::dvec3 high{-std::numeric_limits<double>::infinity()};

    void add(const glm::dvec3& p) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }

    glm::dvec3 furthestAlong(const glm::dvec3& n) const {
        return {n.x > 0 ? high.x : low.x, n.y > 0 ? high.y : low.y, n.z > 0 ? high.z : low.z};
    }
};

struct Plane {
    glm::dvec3 normal;
    glm::dvec3 point;

    Plane turned() const { return {-normal, point}; }
};

double height(const Plane& plane, const glm::dvec3& p) { return glm::dot(plane.normal, p - plane.point); }

/// What a look behind a plane found.
struct Look {
    const Corner* behind = nullptr;
    double lowest = std::numeric_limits<double>::infinity();  // no corner is lower, where none is behind
    long long tests = 0;
};

/// The corners that faces use, each once, in blocks with a box around each.
class Corners {
public:
    explicit Corners(const Scene& scene) {
        std::vector<bool> seen(scene.vertices.size(), false);
        for (const Face& face : scene.faces)
            for (int index : face.corners) add(scene, face, static_cast<std::size_t>(index), seen);
    }

    double diagonal() const { return corners.empty() ? 0 : glm::length(whole.high - whole.low); }
    double limit() const { return -relativeTolerance * diagonal(); }

    /// Looks for a corner further behind the plane than the tolerance.
    ///
    /// A block whose box lies above the plane is skipped: in a room that is nearly all of them.
    Look lookBehind(const Plane& plane) const {
        Look look;
        for (std::size_t block = 0; block < boxes.size() && !look.behind; ++block) {
            const double lowest = height(plane, boxes[block].furthestAlong(-plane.normal));
            ++look.tests;
            if (lowest >= limit())
                look.lowest = std::min(look.lowest, lowest);
            else
                lookInBlock(plane, block, look);
        }
        return look;
    }

private:
    void lookInBlock(const Plane& plane, std::size_t block, Look& look) const {
        const std::size_t end = std::min(corners.size(), (block + 1) * blockSize);
        for (std::size_t i = block * blockSize; i < end && !look.behind; ++i) {
            const double above = height(plane, corners[i].position);
            ++look.tests;
            look.lowest = std::min(look.lowest, above);
            if (above < limit()) look.behind = &corners[i];
        }
    }

    void add(const Scene& scene, const Face& face, std::size_t index, std::vector<bool>& seen) {
        if (seen[index]) return;
        seen[index] = true;
        if (corners.size() % blockSize == 0) boxes.emplace_back();
        corners.push_back({glm::dvec3(scene.vertices[index]), &face});
        boxes.back().add(corners.back().position);
        whole.add(corners.back().position);
    }

    std::vector<Corner> corners;
    std::vector<Bounds> boxes;
    Bounds whole;
};

/// The plane of a face through the mean of its corners; nothing for a face without area, which hides nothing.
std::optional<Plane> planeOf(const Scene& scene, const Face& face) {
    const auto at = [&](std::size_t i) {
        return glm::dvec3(scene.vertices[static_cast<std::size_t>(face.corners[i % face.corners.size()])]);
    };
    glm::dvec3 sum(0.0), mean(0.0);
    for (std::size_t i = 0; i < face.corners.size(); ++i) {
        sum += glm::cross(at(i) - at(0), at(i + 1) - at(0));
        mean += at(i) / static_cast<double>(face.corners.size());
    }
    const double length = glm::length(sum);
    if (!(length > 0)) return std::nullopt;
    return Plane{sum / length, mean};
}

/// Shows of one plane after another that no corner lies behind it.
class Prover {
public:
    explicit Prover(const Scene& scene) : corners(scene) {}

    /// A corner that keeps the face from being harmless, or null.
    const Corner* findHidden(const Face& face, const Plane& plane) {
        const Corner* behind = findBehind(plane);
        if (behind && face.twoSided && !findBehind(plane.turned())) return nullptr;
        return behind;
    }

    bool hasGivenUp() const { return tests > mostTests; }

private:
    struct Known {
        Plane plane;
        double lowest;
    };

    const Corner* findBehind(const Plane& plane) {
        const auto follows = [&](const Known& known) { return followsFrom(known, plane); };
        if (std::any_of(recent.begin(), recent.end(), follows)) return nullptr;
        const Look look = corners.lookBehind(plane);
        tests += look.tests;
        if (!look.behind) remember({plane, look.lowest});
        return look.behind;
    }

    /// Whether a plane has nothing behind it since one of nearly the same place and slope has not: the faces
    /// of one wall are settled by its first.
    bool followsFrom(const Known& known, const Plane& plane) const {
        const double shift = glm::dot(known.plane.normal, known.plane.point - plane.point);
        const double slope = glm::length(plane.normal - known.plane.normal) * corners.diagonal();
        return known.lowest + shift - slope >= corners.limit();
    }

    void remember(const Known& known) {
        if (recent.size() < mostRecent)
            recent.push_back(known);
        else
            recent[next++ % mostRecent] = known;
    }

    static constexpr std::size_t mostRecent = 64;
    static constexpr long long mostTests = 500'000'000;  // about a second

    const Corners corners;
    std::vector<Known> recent;
    std::size_t next = 0;
    long long tests = 0;
};

}  // namespace

Occlusion findOcclusion(const Scene& scene) {
    Prover prover(scene);
    for (const Face& face : scene.faces) {
        Interrupts::check();
        const auto plane = planeOf(scene, face);
        const Corner* hidden = plane ? prover.findHidden(face, *plane) : nullptr;
        if (hidden)
            return {true, "the face at " + placeOf(face) + " may hide others, a corner of the face at " +
                              placeOf(*hidden->face) + " lies behind it"};
        if (prover.hasGivenUp())
            return {true, "too many faces to show that none hides another, given up at the face at " + placeOf(face)};
    }
    const std::string all = std::to_string(scene.faces.size());
    return {false, "no corner lies behind any of the " + all + " faces" +
                       (scene.faces.empty()
                            ? ""
                            : ", from " + placeOf(scene.faces.front()) + " to " + placeOf(scene.faces.back()))};
}

}  // namespace radlab

#pragma once

#include <cstdint>
#include <vector>

#include "course/DataFormat.h"

/// Finds what a ray meets first among patches.
///
/// It keeps the patches as they were when it was made: make a new one where they move.
class RayCaster {
public:
    /// @param patches, corners  as the course's globals `polygons` and `vertices`
    /// @cost n log n
    RayCaster(const std::vector<MyPolygon*>& patches, const std::vector<MyVertex*>& corners);

    /// The nearest patch that a ray meets, from either side.
    ///
    /// A ray that starts on a patch meets that patch first, at the distance 0: name it as `from` to leave it out, and
    /// with it whatever else lies in that place, such as the back of the same wall.
    ///
    /// @param direction  of any length above 0
    /// @return nullptr where the ray leaves the scene
    /// @cost   logarithmic in the number of patches where they lie apart
    /// @source [MoellerTrumbore1997]
    MyPolygon* hit(const Vec3f& origin, const Vec3f& direction, const MyPolygon* from = nullptr) const;

private:
    struct Ray;
    struct Triangle {
        glm::dvec3 corner, edge1, edge2;
        MyPolygon* patch;
        glm::dvec3 middle() const { return corner + (edge1 + edge2) / 3.0; }
    };
    // A box round triangles: those from begin to end, or where there are none, those of the next node and of `second`.
    struct Node {
        glm::dvec3 low, high;
        std::uint32_t begin = 0, end = 0, second = 0;
    };

    void add(MyPolygon* patch, const std::vector<MyVertex*>& corners);
    std::uint32_t build(std::uint32_t begin, std::uint32_t end);

    std::vector<Triangle> triangles;
    std::vector<Node> nodes;
    double touching = 0.0;  // distances that count as none
};

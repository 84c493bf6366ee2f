#pragma once

// Rectangles in the room of the closed forms: a floor, a wall and a ceiling.

#include "engine/Geometry.h"

namespace radlab::engine {

inline Polygon parallelogram(const Point& corner, const Point& u, const Point& v) {
    return Polygon({corner, corner + u, corner + u + v, corner + v});
}

/// On the plane z = 0, seen from above.
inline Polygon onFloor(double x, double y, double width, double depth) {
    return parallelogram({x, y, 0}, {width, 0, 0}, {0, depth, 0});
}

/// On the plane x = 0, seen from where x grows.
inline Polygon onWall(double y, double z, double width, double height) {
    return parallelogram({0, y, z}, {0, width, 0}, {0, 0, height});
}

/// At the height z, seen from below.
inline Polygon onCeiling(double x, double y, double z, double width, double depth) {
    return parallelogram({x, y, z}, {0, depth, 0}, {width, 0, 0});
}

/// The six sides of a box, seen from inside: floor, ceiling and four walls.
inline std::vector<Polygon> boxSides(double width, double depth, double height) {
    return {onFloor(0, 0, width, depth),
            onCeiling(0, 0, height, width, depth),
            onWall(0, 0, depth, height),
            parallelogram({width, 0, 0}, {0, 0, height}, {0, depth, 0}),
            parallelogram({0, 0, 0}, {0, 0, height}, {width, 0, 0}),
            parallelogram({0, depth, 0}, {width, 0, 0}, {0, 0, height})};
}

/// Polygons that are their own patches.
inline Geometry geometryOfFaces(std::vector<Polygon> faces) {
    Geometry geometry;
    geometry.faces = geometry.patches = std::move(faces);
    for (std::size_t i = 0; i < geometry.faces.size(); ++i) geometry.faceOf.push_back(i);
    return geometry;
}

}  // namespace radlab::engine

#pragma once

// Rectangles in the room of the closed forms: a floor, a wall and a ceiling; whole, cut, moved or turned.

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

/// Quadrilaterals, each in rows x columns smaller ones whose neighbours share corners to the bit: rows along the
/// first edge, columns along the last.
inline Geometry cut(const std::vector<Polygon>& faces, int rows, int columns) {
    Geometry geometry;
    geometry.faces = faces;
    for (std::size_t face = 0; face < faces.size(); ++face) {
        const std::vector<Point>& c = faces[face].corners;
        const auto corner = [&](int i, int j) {
            return glm::mix(glm::mix(c[0], c[1], double(i) / rows), glm::mix(c[3], c[2], double(i) / rows),
                            double(j) / columns);
        };
        for (int i = 0; i < rows; ++i)
            for (int j = 0; j < columns; ++j) {
                geometry.patches.push_back(
                    Polygon({corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)}));
                geometry.faceOf.push_back(face);
            }
    }
    return geometry;
}

inline Geometry cut(const std::vector<Polygon>& faces, int count) { return cut(faces, count, count); }

/// A polygon scaled about the origin, then shifted along all axes.
inline Polygon moved(const Polygon& polygon, double scale, double offset) {
    std::vector<Point> corners = polygon.corners;
    for (Point& corner : corners) corner = scale * corner + Point(offset);
    return Polygon(std::move(corners));
}

/// A polygon with its back to the front.
inline Polygon turned(const Polygon& polygon) { return Polygon({polygon.corners.rbegin(), polygon.corners.rend()}); }

}  // namespace radlab::engine

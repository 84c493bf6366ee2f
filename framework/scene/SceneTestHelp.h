#pragma once

#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "base/Error.h"
#include "base/Warning.h"
#include "scene/X3dReader.h"

namespace radlab::test {

/// The text of an Error that `run` throws, or empty where it throws none.
template <class Run>
std::string errorOf(Run run) {
    try {
        run();
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

inline bool contains(const std::string& text, const std::string& piece) {
    return text.find(piece) != std::string::npos;
}

/// A file with these nodes in its Scene; they start on line 2.
inline std::string x3d(const std::string& nodes) { return "<X3D><Scene>\n" + nodes + "</Scene></X3D>"; }

inline std::string coordinate(const std::string& points = "0 0 0 1 0 0 0 1 0") {
    return "<Coordinate point='" + points + "'/>";
}

/// A Shape with one triangle in the plane z = 0 that faces +z, and more fields for its geometry.
inline std::string triangle(const std::string& fields = "", const std::string& appearance = "") {
    return "<Shape>" + appearance + "<IndexedFaceSet coordIndex='0 1 2 -1' " + fields + ">" + coordinate() +
           "</IndexedFaceSet></Shape>";
}

inline std::string withMaterial(const std::string& fields) {
    return triangle("", "<Appearance><Material " + fields + "/></Appearance>");
}

inline Scene parse(const std::string& nodes) { return parseX3d(x3d(nodes), "scene.x3d"); }
inline std::string errorIn(const std::string& nodes) {
    return errorOf([&] { parse(nodes); });
}

/// The warnings that reading these nodes gives.
inline std::vector<std::string> warningsIn(const std::string& nodes) {
    WarningCapture capture;
    parse(nodes);
    return capture.texts;
}

/// Where a Transform puts a point.
inline Vec3f movedBy(const std::string& fields, const std::string& point) {
    const Scene scene = parse("<Transform " + fields + "><Shape><IndexedFaceSet coordIndex='0 1 2'>" +
                              coordinate(point + " 5 5 5 6 7 8") + "</IndexedFaceSet></Shape></Transform>");
    return scene.vertices[0];
}

inline void checkClose(const Vec3f& found, const Vec3f& expected) {
    CAPTURE(found.x);
    CAPTURE(found.y);
    CAPTURE(found.z);
    CHECK(glm::length(found - expected) <= 1e-5f * (1 + glm::length(expected)));
}

/// The unit normal of a face, by its first three corners.
inline Vec3f normalOf(const Scene& scene, std::size_t face = 0) {
    const auto at = [&](std::size_t i) {
        return scene.vertices[static_cast<std::size_t>(scene.faces[face].corners[i])];
    };
    return glm::normalize(glm::cross(at(1) - at(0), at(2) - at(0)));
}

}  // namespace radlab::test

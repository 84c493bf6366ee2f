#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "scene/Scene.h"

namespace radlab {

/// How much a file may hold when each USE is written out. A few lines can spell a billion faces.
struct X3dLimits {
    std::size_t faces = 4'000'000;
    std::size_t vertices = 16'000'000;
    std::size_t corners = 16'000'000;
    std::size_t nodes = 2'000'000;
    std::size_t cameras = 256;
};

/// Reads a scene from an X3D file in the XML encoding.
///
/// The polygonal subset that exporters write: Group and Transform, Shape with Appearance and Material,
/// IndexedFaceSet, IndexedTriangleSet and IndexedQuadSet with their Coordinate, Viewpoint, Background, DEF and
/// USE. Everything else is passed over and named in one warning. Positions come out in world coordinates, and
/// corners run counter-clockwise seen from the front, whatever ccw and mirroring Transforms say. A Shape without
/// a Material has X3D's default one. The course's older layout, geometry inside the Appearance, is read too.
///
/// @return a scene of at least one face, every index in range, every number finite
/// @throws Error with the line of the element, for a file that is missing, not XML, wrong, or without any face
/// @cost   one pass over the file, one over the nodes with each USE written out
/// @source [X3D]; ISO/IEC 19776-1, its XML encoding
Scene readX3d(const std::filesystem::path& file);

/// Reads a scene from the text of an X3D file, like readX3d.
///
/// @param fileName the name that messages show
Scene parseX3d(std::string_view text, const std::string& fileName, const X3dLimits& limits = {});

}  // namespace radlab

#pragma once

#include <filesystem>

#include "export/SolvedMesh.h"

namespace radlab {

/// Whether a file's ending is that of a mesh: .glb, .gltf or .ply.
bool isMeshFile(const std::filesystem::path& file);

/// Writes a solved mesh whole or not at all, as its ending says: .glb, .gltf (its buffer embedded) or .ply.
///
/// Errors: another ending, a mesh too large for the form (4 GiB), a file that cannot be written.
void writeMesh(const std::filesystem::path& file, const SolvedMesh& mesh);

/// glTF 2.0, in one file: binary, or as text with its buffer in it.
///
/// A primitive for each part, unlit (KHR_materials_unlit), so that viewers show the vertex colours as they are. COLOR_0 is what
/// is displayed, linear, and for a pane what is displayed once it is blended by the alpha of its material; _RADIOSITY is B in
/// W/m². Materials carry ρ and E in their extras. The scene's viewpoints are cameras.
///
/// @source [Khronos2021, section 3.7.2] meshes; [Khronos2021, section 4.4] the binary form
void writeGltf(const std::filesystem::path& file, const SolvedMesh& mesh, bool binary);

/// PLY, binary: positions, sRGB colours, faces, and of each face its radiosity in W/m².
///
/// @source [Turk1994]
void writePly(const std::filesystem::path& file, const SolvedMesh& mesh);

}  // namespace radlab

#pragma once

#include "grader/stages/Meshes.h"

namespace radlab::grader {

/// A square from -1 to 1 in the plane z = 0, its front to +z, of cells x cells patches that share their corners; every fifth
/// cell or so is two triangles. In order, and without light.
State wall(Random& random, int cells);

/// Adds the patches of another state, behind those that are there.
void append(State& state, const State& more);

}  // namespace radlab::grader

#pragma once

#include <string>

#include "apps/RenderSolution.h"

namespace radlab {

/// Writes a row for each patch: id, face, centre, normal, area, ρ, E, B, and the standard error of B where it has one.
///
/// CSV with one line of comment and one of names.
void writeTable(const std::string& file, const SceneInput& input, const RenderSolution& solution);

}  // namespace radlab

#pragma once

#include <filesystem>

#include "apps/DemoSteps.h"

namespace radlab {

/// Writes the demo into a folder, made where it does not exist: the pictures, the shots, a strip over the shots, a
/// contact sheet, and last the page that shows them.
///
/// @return the page, index.html
/// Errors: a folder that cannot be written.
std::filesystem::path writeDemo(const Demo& demo, const std::filesystem::path& folder);

}  // namespace radlab

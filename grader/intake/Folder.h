#pragma once

#include <string>
#include <vector>

#include "grader/intake/Choice.h"
#include "grader/intake/OpenFile.h"

namespace radlab::grader {

/// What a folder of a submission gave.
struct GatheredFolder {
    Gathered gathered;
    std::vector<std::string> archives;  ///< that lie in it, not in its folders
};

/// Whether a folder holds nothing that students write: ".git" and what macOS adds to archives.
bool isPassedOver(std::string_view folder);

/// Looks through a folder and the folders in it, level by level.
///
/// Where the rules' number of entries is exceeded, the level at which that happens counts as a whole as not looked at,
/// so that the order in which a disk lists entries decides nothing.
///
/// Errors: MachineError; NotTaken where the folder itself may not be read.
GatheredFolder gatherFolder(const OpenFile& folder, const IntakeRules& rules);

}  // namespace radlab::grader

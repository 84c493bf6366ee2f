#pragma once

#include "grader/batch/ClassRun.h"

namespace radlab::grader {

/// What an instructor reads at the end of a run: how many ended in which way, the mean, and the next step.
///
/// @param submissions  the class, also where the run was for some of it
std::string classSummary(const ClassCounts& counts, const std::vector<Submission>& submissions,
                         const StoreReader& store);

}  // namespace radlab::grader

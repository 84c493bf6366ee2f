#pragma once

#include <filesystem>

#include "grader/protocol/Student.h"

namespace radlab::grader {

/// Which reports of a verdict to write, and where; an empty path is none.
struct CheckReports {
    std::filesystem::path json, junit, gradescope, classroom50;
    std::filesystem::path page;  ///< a folder
};

/// Writes the reports asked for, each whole or not at all.
///
/// Where nothing could be judged, there is only Gradescope's, which says why, and Classroom 50's, unless it was the
/// grader that failed.
/// @return the page; empty where none was written
/// Errors: a folder that does not exist or cannot be written.
std::filesystem::path writeReports(const StudentResult& verdict, const CheckReports& reports);

}  // namespace radlab::grader

#pragma once

#include <string>

#include "grader/protocol/Student.h"

namespace radlab::grader {

/// The verdict on a submission as Gradescope's results.json: the score, and a test for each check, "2.1" for the first
/// of stage 2.
///
/// Gradescope shows a failure of its own where the file is missing or has no score. So there is always one: 0 with the
/// reason where nothing could be judged, and where the grader failed, with the plain words that this 0 is no mark.
/// Texts are plain, and cut such that the file stays below a megabyte.
/// @source Gradescope, "Autograder Specifications"
std::string gradescopeJson(const StudentResult& student);

}  // namespace radlab::grader

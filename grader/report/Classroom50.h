#pragma once

#include <string>

#include "grader/protocol/Student.h"

namespace radlab::grader {

/// The verdict on a submission as it stands in Classroom 50's result.json: score, max-score and tests, the first for
/// compiling, then one for each check of the six functions and of all together. Who handed in what, the autograder adds.
///
/// Marks are whole numbers there. Where the manifest has fractions, all marks are counted in tenths, else in hundredths,
/// to which finer ones are rounded; the scores are the sums of the tests' in any case. Extensions are left out, since
/// a test that fails makes the whole submission one that fails.
///
/// @pre    the grader did not fail: there is no form for a submission without a mark
/// @source Classroom 50's wiki, "Advanced Autograding": the result.json contract
std::string classroom50Json(const StudentResult& student);

}  // namespace radlab::grader

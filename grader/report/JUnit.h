#pragma once

#include <string>
#include <vector>

#include "grader/protocol/Result.h"
#include "grader/protocol/Student.h"

namespace radlab::grader {

/// The result as JUnit XML, which CI services read: a test suite for each stage, a test case for each check.
///
/// A wrong check is a failure, a failure of the grader an error; what was not started, blocked or not asked for is
/// skipped. A stage without checks has one test case that bears its status, and so has what does not compile.
///
/// @source the Ant and Maven Surefire form that GitLab, Jenkins and GitHub's actions read; XML 1.0
std::string junitXml(const Result& result);

/// The results of a class in the same form: a test suite for each student, a test case for each check.
///
/// Where nothing could be judged, one test case says why: skipped where nothing was handed in, a failure where it was
/// refused or does not compile, an error where the grader failed. What submissions printed is left out.
std::string classJunitXml(const std::vector<StudentResult>& results);

}  // namespace radlab::grader

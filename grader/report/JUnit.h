#pragma once

#include <string>

#include "grader/protocol/Result.h"

namespace radlab::grader {

/// The result as JUnit XML, which CI services read: a test suite for each stage, a test case for each check.
///
/// A wrong check is a failure, a failure of the grader an error; what was not started, blocked or not asked for is
/// skipped. A stage without checks has one test case that bears its status.
///
/// @source the Ant and Maven Surefire form that GitLab, Jenkins and GitHub's actions read; XML 1.0
std::string junitXml(const Result& result);

}  // namespace radlab::grader

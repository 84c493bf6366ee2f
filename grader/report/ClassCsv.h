#pragma once

#include <string>
#include <vector>

#include "grader/protocol/Student.h"

namespace radlab::grader {

// Tables of a class for any program. UTF-8 with a byte order mark, since Excel takes a file without one for another
// encoding and breaks names; commas; decimal points; lines end in CR LF. Texts are safe for spreadsheets.

/// A row a student: who, how it ended, total and marks a stage (empty where there is no mark), late, when, seed, and
/// the mark before.
std::string marksCsv(const std::vector<StudentResult>& results);

/// A row a student and check of those with a mark: status, marks, and the id of the mistake.
std::string checksCsv(const std::vector<StudentResult>& results);

}  // namespace radlab::grader

#pragma once

#include "grader/report/Gradebook.h"

namespace radlab::grader {

/// Fills the marks of a class into the offline grading worksheet that an instructor downloaded from Moodle.
///
/// Titles are in the language of who downloaded it, so columns are known by what stands in them: participants by a word
/// and a number ("Participant 12345"), marks by the largest mark beside them, the same in every row, or else by the
/// title in seven languages. Students are found by the participant's number, else by another column left of the
/// marks, else by a name that only one row has. Rows that Moodle has locked stay as they are.
///
/// @param worksheet the bytes of the file; all but the filled cells are kept
/// Errors: no worksheet of Moodle; one that is graded by a scale; no column for feedback where it is asked for.
/// @source moodle/moodle, mod/assign/gradingtable.php and mod/assign/feedback/offline/importgradeslib.php
FilledGradebook filledMoodle(const std::string& worksheet, const std::vector<StudentResult>& results,
                             const FillOptions& options);

}  // namespace radlab::grader

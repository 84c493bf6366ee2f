#pragma once

#include "grader/report/Gradebook.h"

namespace radlab::grader {

/// Fills the marks of a class into the gradebook that an instructor exported from Canvas.
///
/// The column is that of the assignment whose number or title is given, or the only one. Students are found by ID, SIS
/// User ID, SIS Login ID or Integration ID, else by a name that only one row has. Full marks are worth what the row
/// "Points Possible" says, which stays as it is, and so do cells with EX (excused) and N/A (not assigned).
///
/// @param gradebook the bytes of the file; all but the filled cells are kept
/// Errors: no gradebook of Canvas, or none or several assignments that fit, which are listed.
/// @source instructure/canvas-lms, lib/gradebook_importer.rb and lib/gradebook_exporter.rb
FilledGradebook filledCanvas(const std::string& gradebook, const std::vector<StudentResult>& results,
                             const FillOptions& options);

}  // namespace radlab::grader

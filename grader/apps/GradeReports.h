#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "grader/batch/StoreReader.h"
#include "grader/intake/Submission.h"

namespace radlab::grader {

/// What is written of a class' grades, and where.
struct ReportFiles {
    std::filesystem::path folder;  ///< of the pages: <out>/grades
    std::string title;             ///< of the class
    std::string version;           ///< of the grader
    std::filesystem::path canvas;  ///< a gradebook to fill in; empty: none
    std::filesystem::path moodle;  ///< a worksheet to fill in; empty: none
    std::string assignment;        ///< which column of theirs
};

/// Reads the gradebooks that are to be filled in, so that what is wrong with one is said before an hour of grading.
///
/// Errors: those of the gradebooks.
void checkGradebooks(const ReportFiles& files);

/// Writes the page of the class and of each student, the tables, JUnit's form, and the filled-in gradebooks.
///
/// Each file appears whole. Pages of students who are no longer in the class are left.
/// @return what the instructor should know: where files are, and who was not matched
/// Errors: those of the store, of the gradebooks, a folder that cannot be written.
/// @cost   memory for one student's pictures at a time
std::vector<std::string> writeClassReports(const std::vector<Submission>& submissions, const StoreReader& store,
                                           const ReportFiles& files);

}  // namespace radlab::grader

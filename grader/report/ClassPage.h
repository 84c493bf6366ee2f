#pragma once

#include <string>
#include <vector>

#include "grader/protocol/Student.h"

namespace radlab::grader {

/// What the page of a class says beside its students.
struct ClassInfo {
    std::string title;                     ///< what the class is called, as a folder is named: any bytes
    std::string graded;                    ///< when the run ended, ISO 8601 in UTC
    std::string version;                   ///< of the grader
    std::vector<std::string> protections;  ///< what kept the submissions in their boxes
    std::vector<std::string> files;        ///< names of files beside the page to link to: "marks.csv"
};

/// The page of a class: figures, how the marks are spread, which mistakes are common, who needs a look, and a table of
/// all students with links to their pages (studentPageFile).
///
/// Nothing comes from elsewhere. The table is whole without a script; the one that sorts, searches and filters is the
/// only one that the page allows, named by its hash. A view is kept in the address: "#q=…&status=…&sort=total&down=1".
/// Errors: a build without libsodium.
/// @cost a thousand students give a page of about one megabyte
std::string classPage(const ClassInfo& info, const std::vector<StudentResult>& results);

}  // namespace radlab::grader

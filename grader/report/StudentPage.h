#pragma once

#include <string>
#include <vector>

#include "grader/protocol/Graded.h"
#include "grader/protocol/Student.h"

namespace radlab::grader {

/// How a student's page is written.
struct PageOptions {
    std::string classPage = "../index.html";  ///< what it links back to; empty: no link, for a page that is handed on
};

/// The page of a student of a class, whole in one file: marks, checks, pictures, what the compiler said, what was not
/// taken, earlier marks.
///
/// The page needs no script and nothing from elsewhere. What comes from the submission stands on it as plain text. Of a
/// check that passed, only the submission's own picture is shown, since it is the reference.
/// The fault of a grader that failed is left to the class page, as it may tell of the machine.
///
/// @param pictures of the checks of the result; those of others are passed over
/// Errors: a build without libsodium, where there are pictures.
std::string studentPage(const StudentResult& student, const std::vector<CheckPicture>& pictures,
                        const PageOptions& options = {});

/// Where the page of a student lies in the folder of the class page: "students/student-07.html".
std::string studentPageFile(const Student& student);

}  // namespace radlab::grader

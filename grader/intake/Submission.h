#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "grader/protocol/Student.h"

namespace radlab::grader {

/// What is taken of a submission, and how much of it.
struct IntakeRules {
    std::vector<std::string> files = {"ProgRef.cpp"};  ///< names that are taken, the first is the one to compile
    std::size_t mostBytes = std::size_t{1} << 20;      ///< of one file
    std::size_t mostArchive = std::size_t{64} << 20;   ///< bytes of an archive, packed
    std::size_t mostEntries = 10000;                   ///< of a folder or an archive that are looked at
    std::size_t deepest = 8;                           ///< folders inside one another
    std::size_t mostRemarks = 20;                      ///< the rest is counted in one
    std::filesystem::path unpack;                      ///< the program that reads archives
};

/// A student, and where in the class' folder the submission lies.
struct Submission {
    Student student;
    std::vector<std::filesystem::path> places;  ///< a folder, an archive, or files, newest last
};

/// What was taken of a submission.
struct Taken {
    Outcome outcome = Outcome::nothing;        ///< graded: there is something to grade; never error
    std::map<std::string, std::string> files;  ///< contents by name, names of the rules alone
    std::vector<std::string> remarks;          ///< what was not taken, and why: any bytes
    std::string hash;                          ///< SHA-256 over names and contents, in hexadecimal; empty without files
};

/// The students of a class, sorted by id, as the download of Canvas, Moodle or GitHub Classroom lays them out, or as
/// a folder or archive a student.
///
/// Nothing is opened but the folder itself, and no link is followed.
/// Errors: no such folder, one that cannot be read, one without any submission.
std::vector<Submission> findSubmissions(const std::filesystem::path& folder);

/// Reads what the rules name out of a submission: regular files only, and nothing through a link.
///
/// Archives are read by a program of their own, in a box.
/// Errors: MachineError, where the disk or that program fails.
Taken take(const Submission& submission, const IntakeRules& rules);

}  // namespace radlab::grader

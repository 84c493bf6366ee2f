#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "grader/protocol/Student.h"
#include "grader/sandbox/Sandbox.h"

namespace radlab::grader {

/// What is taken of a submission, and how much of it.
struct IntakeRules {
    std::vector<std::string> files = {"ProgRef.cpp"};     ///< names that are taken, the first is the one to compile
    std::size_t mostBytes = std::size_t{1} << 20;         ///< of one file
    std::size_t mostArchive = std::size_t{64} << 20;      ///< bytes of an archive, packed
    std::size_t mostUnpacked = std::size_t{512} << 20;    ///< bytes of all that an archive holds
    std::size_t mostRatio = 200;                          ///< bytes unpacked for each byte packed, in larger archives
    std::size_t ratioCountsFrom = std::size_t{16} << 20;  ///< bytes unpacked: source text and zeros pack well
    std::size_t mostEntries = 10000;                      ///< of a folder or an archive that are looked at
    std::size_t deepest = 8;                              ///< folders inside one another
    std::size_t mostRemarks = 20;                         ///< the rest is counted in one
    std::filesystem::path unpack;                         ///< the program that reads archives
    std::optional<Sandbox> sandbox;                       ///< that it runs in; nothing: this machine's
};

/// A student, and where in the class' folder the submission lies.
///
/// student.name is the person's as far as the layout tells it, else what the entry is called, without the ending of an
/// archive or a file. student.submitted is when the newest of places was changed, which is when it was packed, unpacked
/// or cloned where the download does not keep times. student.remarks says what of the class' folder was refused.
struct Submission {
    Student student;
    std::vector<std::filesystem::path> places;  ///< a folder, or archives and files, newest last
};

/// What was taken of a submission.
struct Taken {
    Outcome outcome = Outcome::nothing;        ///< graded: there is something to grade; never error
    std::map<std::string, std::string> files;  ///< contents by name, names of the rules alone
    std::vector<std::string> remarks;          ///< what was not taken, and why: one line each, fit to be seen
    std::string hash;                          ///< SHA-256 over names and contents, in hexadecimal; empty without files
};

/// The students of a class, sorted by id, as the download of Canvas, Moodle, Classroom 50 or the former GitHub Classroom
/// lays them out, or as a folder, archive or file a student.
///
/// The layout is the one by which more than half of the entries are named; each other entry is a student, too. Nothing
/// is opened but the folder itself (and the folder of repositories that gh makes in it) and what repositories say of
/// themselves (see aroundLogin), and no link is followed.
/// Hidden entries, and what operating systems leave behind, are passed over. An id depends on the names alone, never on
/// their order; where two are alike but for upper and lower case, both get a hash of their names.
/// Errors: no such folder, one that cannot be read, one without any submission.
std::vector<Submission> findSubmissions(const std::filesystem::path& folder);

/// Reads what the rules name out of a submission: regular files only, and nothing through a link.
///
/// In a folder or an archive, `exercises/NAME` comes first, then the NAME in the fewest folders; of several places, the
/// newest that has one. Names that differ in case, or by the "-1" that Canvas appends, are taken where there is no
/// other. Archives are read by a program of their own. May be called by several threads at once.
/// Errors: MachineError, where the disk or that program fails.
Taken take(const Submission& submission, const IntakeRules& rules);

}  // namespace radlab::grader

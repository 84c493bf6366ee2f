#pragma once

#include <string>
#include <vector>

#include "grader/protocol/Result.h"

namespace radlab::grader {

/// Who handed something in, as the folder of submissions tells.
struct Student {
    std::string id;         ///< unique in the class; letters, digits, '.', '_', '-': names the student's page
    std::string name;       ///< as the download tells it, else as the folder or file is called: any bytes
    std::string account;    ///< Canvas' user ID, Moodle's participant number, GitHub's login; else the folder's name
    std::string submitted;  ///< when, ISO 8601 in UTC ("2026-11-23T08:15:00Z"); empty where nothing tells
    bool late = false;
    std::vector<std::string> remarks;  ///< what was not taken of what was handed in, and why: any bytes
};

/// How the grading of a student's submission ended.
enum class Outcome {
    graded,   ///< there is a mark, 0 for what does not compile included
    nothing,  ///< nothing was handed in, or an empty file
    refused,  ///< something was, but none of it could be taken; the remarks say why
    error,    ///< the grader or the machine failed, three times: no mark
};

/// A mark that was given before.
struct EarlierMark {
    double score = 0.0, maxScore = 0.0;
    std::string graded;     ///< when, ISO 8601 in UTC
    std::string submitted;  ///< when what was graded then was handed in; empty where nothing tells
    std::string version;    ///< of the grader
    std::uint64_t seed = 0;
};

/// A student of the class with the verdict: what every report of a class reads.
struct StudentResult {
    Student student;
    Outcome outcome = Outcome::nothing;
    Result result;                     ///< where graded
    std::string graded;                ///< when, ISO 8601 in UTC; where graded
    std::string fault;                 ///< of the grader or machine; where error
    std::vector<EarlierMark> earlier;  ///< newest first
};

/// "graded", "nothing", "refused" or "error".
std::string outcomeText(Outcome outcome);

}  // namespace radlab::grader

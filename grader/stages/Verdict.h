#pragma once

#include <string>
#include <vector>

#include "grader/stages/Stage.h"

namespace radlab::grader {

/// What came back from the process of one check.
struct CheckRun {
    std::vector<StepAnswer> answers;  ///< of the steps of all its cases, as far as it got
    std::string cause;  ///< why it ended before the last answer: "stopped by signal 11 in calcFF"; else empty
};

/// What the judge makes of a check.
struct CheckVerdict {
    Status status = Status::pass;  ///< pass, fail, notStarted, or error where the worker failed
    std::string message;           ///< what was found, what was expected, and within which tolerance
};

/// What the judge makes of a stage.
struct StageVerdict {
    std::vector<CheckVerdict> checks;
    std::optional<Diagnosis> diagnosis;
    std::string example;  ///< where there is no diagnosis: the smallest failing case, as C++ for a test
};

/// Compares what a submission left in all cases of a stage with what is right, and with what is wrong in a known way.
///
/// A check passes where all its cases agree with one right way, the same for all checks. Where some do not, the catalogue's first
/// mistake that agrees with every case is named; where none does, what the stage's fit finds.
/// @pre   runs are those of the checks, in their order
/// @cost  one computation of all cases for each right way, and where something fails, at most one for each mistake
StageVerdict judge(const Stage& stage, const std::vector<const Check*>& checks,
                   const std::vector<const CheckRun*>& runs);

/// Whether two numbers are the same up to slack; those that are not finite only if both are the same.
bool agrees(double found, double expected, double slack);

/// Why a function did not return, in words.
std::string stopText(const std::string& function, const Stop& stop);

}  // namespace radlab::grader

#pragma once

#include <string>
#include <vector>

#include "grader/protocol/Result.h"
#include "grader/protocol/Student.h"

namespace radlab::grader {

// The words and figures that every report uses.

/// Marks as a person writes them: "8", "7.5", "6.67".
std::string marksText(double marks);

/// "right", "wrong", "not started", "blocked", "grader failed" or "not judged".
std::string statusWord(Status status);

/// Whether a stage is that of all functions together, which has no function to edit and no marks.
bool isTogether(const StageResult& stage);
bool isTogether(const std::string& stage);

/// Whether a stage is an extension, which counts for no marks.
bool isExtension(const StageResult& stage);

/// "stage 2" or "extension".
std::string placeText(const StageResult& stage);

/// "calcFF", or "all together"; on one line, and safe to show.
std::string stageName(const StageResult& stage);
std::string stageName(const std::string& stage);

/// Whether the grader or the machine failed anywhere: in a stage, or in one of its checks.
bool hasError(const StageResult& stage);
bool hasError(const Result& result);

/// Whether extensions alone were judged, so that there are no marks.
bool isOfExtensions(const Result& result);

/// What the report is about: the stages, or where extensions alone were judged, those.
const std::vector<StageResult>& judgedStages(const Result& result);

/// How much of the extensions is right: "8/10, beside the marks".
std::string extensionsText(const Result& result);

/// The status of a stage, or error where the grader failed in one of its checks.
Status shownStatus(const StageResult& stage);

/// Whether nothing has been written yet.
bool nothingStarted(const Result& result);

/// Whether all six functions were judged and are right, and all of them together.
bool allRight(const Result& result);

/// What became of it as a whole, in one sentence.
std::string verdictText(const Result& result);

/// The first check of a stage with a status, or nullptr.
const CheckResult* firstCheck(const StageResult& stage, Status status);

/// What a check claims, or its id where it says nothing; on one line, and safe to show.
std::string claimText(const CheckResult& check);

/// The hint of a check: its diagnosis' own, or else its own.
std::string hintOf(const CheckResult& check);

/// What to do next, the same said in ever fewer words; safe to show, one line each.
///
/// hintsShown tells whether the hints stand above it already.
std::vector<std::string> nextStep(const Result& result, bool hintsShown);

/// Whether there is a mark, which there is not where the grader failed anywhere.
bool hasMark(const StudentResult& student);

/// "graded", "does not compile", "nothing handed in", "refused" or "grader failed".
std::string outcomeWord(const StudentResult& student);

/// What a student is called: the name, or else the id; on one line, and safe to show.
std::string shownName(const Student& student);

/// Texts in a row, each on one line and safe to show: "seccomp, limits".
std::string listText(const std::vector<std::string>& texts, const std::string& between = ", ");

/// "2026-11-23 08:15 UTC" of a time in ISO 8601; another text as it is, on one line, and safe to show.
std::string timeText(const std::string& time);

}  // namespace radlab::grader

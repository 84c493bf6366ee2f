#pragma once

#include <string>

#include "grader/protocol/Result.h"

namespace radlab::grader {

struct ReportOptions {
    bool color = false;    ///< colours and bold type by ANSI escapes
    bool hints = false;    ///< says where to look
    bool details = false;  ///< explains all stages that fail, and at length, not the first alone
};

/// What a student reads: a line for each stage, what is wrong with the first one that fails, the score, the next step.
///
/// Nothing that a submission printed reaches the terminal as it came, and none of its lines can pass for one of
/// the report. Stages that nobody asked for are not shown.
///
/// @return lines of at most 100 columns, at most 25 without details; the last but one is the score, the last begins
///         with "next: "
std::string terminalReport(const Result& result, const ReportOptions& options = {});

}  // namespace radlab::grader

#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "base/Image.h"

namespace radlab::grader {

/// How a check or a stage ended.
enum class Status {
    pass,
    fail,        ///< the submission is wrong
    error,       ///< the grader or the machine failed: never the student's mark
    notStarted,  ///< the stub is still there
    blocked,     ///< cannot be judged before something else passes
    skipped,     ///< nobody asked for it
};

/// The mistake that explains what was found.
struct Diagnosis {
    std::string id;    ///< of the catalogue in grader/stages, "missing-inverse-pi"
    std::string text;  ///< what is believed, and why it is wrong
    std::string hint;  ///< leads on, without the code
};

/// A picture that a stage made, beside the one that it should be. All ready for display, of one size.
struct Picture {
    std::string caption;
    Image reference;
    Image found;
    Image difference;
    double rms = 0.0;        ///< root mean square difference over all pixels and channels, 0 to 1
    double tolerance = 0.0;  ///< the largest rms that passes
};

/// One claim about one stage.
struct CheckResult {
    std::string id;    ///< "ff.facing"
    std::string name;  ///< the claim: "two facing patches match the formula"
    Status status = Status::skipped;
    double score = 0.0;
    double maxScore = 0.0;
    std::string message;  ///< what was found, what was expected, and within which tolerance; empty where it passed
    std::optional<Diagnosis> diagnosis;
    std::string example;             ///< the smallest failing case, as C++ for a test; may be empty
    std::string output;              ///< what the submission printed, as it came: any bytes
    std::string hint;                ///< where to look
    std::optional<Picture> picture;  ///< not in the result file
    double seconds = 0.0;
};

/// The checks of one of the six functions, of all together, or of an extension.
struct StageResult {
    int number = 0;     ///< 1 to 6 in the order of the exercise; 7 for all together; from 8 on the extensions
    std::string stage;  ///< the function's name, "calcFF"; "together"
    std::string title;
    Status status = Status::skipped;
    double score = 0.0;
    double maxScore = 0.0;
    std::vector<CheckResult> checks;
};

/// The verdict on a submission: what everything that shows a mark reads.
struct Result {
    std::string submission;  ///< the file that was judged
    double score = 0.0;
    double maxScore = 0.0;
    std::uint64_t seed = 0;
    std::vector<std::string> protections;  ///< what kept the submission in its box
    std::string compiler;                  ///< what the compiler said: any bytes
    bool compiled = true;                  ///< false: no stage could be judged, and there are no marks
    std::vector<StageResult> stages;
    std::vector<StageResult> extensions;  ///< those that were asked for; their scores are no part of the score above
    double seconds = 0.0;
};

/// "pass", "fail", "error", "not_started", "blocked" or "skipped".
std::string statusText(Status status);

/// The result file, schema "radlab/result/1"; pictures are left out, and bytes of output that are not UTF-8 replaced.
nlohmann::json resultToJson(const Result& result);

/// Reads a result file.
///
/// Errors: another schema, a field that is missing or of the wrong kind.
Result resultFromJson(const nlohmann::json& json);

}  // namespace radlab::grader

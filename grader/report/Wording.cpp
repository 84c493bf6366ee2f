#include "grader/report/Wording.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "grader/report/TextLines.h"

namespace radlab::grader {

namespace {

constexpr std::size_t functionCount = 6;
constexpr const char* checkCommand = "./radlab check";

const StageResult* firstStage(const Result& result, Status status) {
    for (const StageResult& stage : judgedStages(result))
        if (stage.status == status) return &stage;
    return nullptr;
}

std::string commandFor(const StageResult& stage) { return std::string(checkCommand) + " " + oneLine(stage.stage); }

// " in exercises/ProgRef.cpp", then with the file's name alone, then nothing.
std::vector<std::string> placesToEdit(const Result& result) {
    const std::string file = oneLine(result.submission);
    if (file.empty()) return {""};
    const std::size_t slash = file.find_last_of("/\\");
    if (slash == std::string::npos) return {" in " + file, ""};
    return {" in " + file, " in …" + file.substr(slash), ""};
}

std::vector<std::string> write(const Result& result, const StageResult& stage) {
    std::vector<std::string> steps;
    for (const std::string& place : placesToEdit(result))
        steps.push_back("write " + stageName(stage) + " (" + placeText(stage) + ")" + place + ", then " +
                        (isExtension(stage) ? commandFor(stage) : checkCommand));
    return steps;
}

std::vector<std::string> mend(const Result& result, const StageResult& stage, bool hintsShown) {
    const CheckResult* check = firstCheck(stage, Status::fail);
    const bool moreToSay = check && !hintsShown && !hintOf(*check).empty();
    const std::string command = commandFor(stage);
    const std::string what = isTogether(stage) ? "find why the functions fail together"
                                               : "mend " + stageName(stage) + " (" + placeText(stage) + ")";
    std::vector<std::string> steps;
    for (const std::string& place : placesToEdit(result))
        steps.push_back(what + place + (moreToSay ? "; " + command + " --hint says more" : ", then " + command));
    return steps;
}

}  // namespace

std::string marksText(double marks) {
    char text[64];
    std::snprintf(text, sizeof text, std::abs(marks) < 1e7 ? "%.2f" : "%g", marks);
    std::string shown = text;
    if (!(std::abs(marks) < 1e7)) return shown;
    shown.erase(shown.find_last_not_of('0') + 1);
    if (shown.back() == '.') shown.pop_back();
    return shown == "-0" ? "0" : shown;
}

std::string statusWord(Status status) {
    switch (status) {
        case Status::pass: return "right";
        case Status::fail: return "wrong";
        case Status::error: return "grader failed";
        case Status::notStarted: return "not started";
        case Status::blocked: return "blocked";
        case Status::skipped: break;
    }
    return "not judged";
}

bool isExtension(const StageResult& stage) { return stage.number > static_cast<int>(functionCount) + 1; }

std::string placeText(const StageResult& stage) {
    return isExtension(stage) ? "extension" : "stage " + std::to_string(stage.number);
}

bool isTogether(const StageResult& stage) { return isTogether(stage.stage); }

bool isTogether(const std::string& stage) { return stage == "together"; }

std::string stageName(const StageResult& stage) { return stageName(stage.stage); }

std::string stageName(const std::string& stage) { return isTogether(stage) ? "all together" : oneLine(stage); }

bool hasError(const StageResult& stage) {
    return stage.status == Status::error || firstCheck(stage, Status::error) != nullptr;
}

bool isOfExtensions(const Result& result) { return result.stages.empty() && !result.extensions.empty(); }

const std::vector<StageResult>& judgedStages(const Result& result) {
    return isOfExtensions(result) ? result.extensions : result.stages;
}

bool hasError(const Result& result) {
    const std::vector<StageResult>& stages = judgedStages(result);
    return std::any_of(stages.begin(), stages.end(), [](const StageResult& stage) { return hasError(stage); });
}

std::string extensionsText(const Result& result) {
    double score = 0.0, most = 0.0;
    for (const StageResult& extension : result.extensions) score += extension.score, most += extension.maxScore;
    return marksText(score) + "/" + marksText(most) + ", beside the marks";
}

Status shownStatus(const StageResult& stage) { return hasError(stage) ? Status::error : stage.status; }

bool nothingStarted(const Result& result) {
    const auto untouched = [](const StageResult& stage) {
        return stage.status == Status::notStarted || stage.status == Status::blocked || stage.status == Status::skipped;
    };
    return firstStage(result, Status::notStarted) && !hasError(result) &&
           std::all_of(judgedStages(result).begin(), judgedStages(result).end(), untouched);
}

bool allRight(const Result& result) {
    std::size_t functions = 0;
    for (const StageResult& stage : result.stages) {
        if (stage.status != Status::pass) return false;
        if (!isTogether(stage)) ++functions;
    }
    return functions >= functionCount;
}

std::string verdictText(const Result& result) {
    if (hasError(result)) return "The grader or the machine failed. It takes no marks for that.";
    if (!result.compiled) return "It does not compile.";
    if (nothingStarted(result)) return "Nothing is written yet, so nothing is wrong.";
    if (allRight(result)) return "All functions are right.";
    std::size_t functions = 0, right = 0;
    for (const StageResult& stage : judgedStages(result)) {
        if (isTogether(stage) || stage.status == Status::skipped) continue;
        ++functions;
        if (stage.status == Status::pass) ++right;
    }
    return std::to_string(right) + " of " + std::to_string(functions) +
           (functions == 1 ? " function is right." : " functions are right.");
}

const CheckResult* firstCheck(const StageResult& stage, Status status) {
    for (const CheckResult& check : stage.checks)
        if (check.status == status) return &check;
    return nullptr;
}

std::string claimText(const CheckResult& check) { return oneLine(check.name.empty() ? check.id : check.name); }

std::string hintOf(const CheckResult& check) {
    return check.diagnosis && !check.diagnosis->hint.empty() ? check.diagnosis->hint : check.hint;
}

std::vector<std::string> nextStep(const Result& result, bool hintsShown) {
    if (hasError(result))
        return {std::string("run ") + checkCommand + " again; if it fails again, send this report to your instructor"};
    if (!result.compiled) return {std::string("correct the compiler's first error, then ") + checkCommand};
    if (const StageResult* stage = firstStage(result, Status::fail)) return mend(result, *stage, hintsShown);
    if (const StageResult* stage = firstStage(result, Status::notStarted)) return write(result, *stage);
    if (allRight(result))
        return {"nothing is left to do: all six are right; ./radlab demo --exercise shows what they draw"};
    if (isOfExtensions(result)) return {"nothing is left to do here: what was judged is right"};
    if (firstStage(result, Status::blocked))
        return {std::string(checkCommand) + " judges all six functions, and says which one comes first"};
    return {std::string(checkCommand) + " judges all six functions"};
}

bool hasMark(const StudentResult& student) { return student.outcome == Outcome::graded && !hasError(student.result); }

std::string outcomeWord(const StudentResult& student) {
    switch (student.outcome) {
        case Outcome::nothing: return "nothing handed in";
        case Outcome::refused: return "refused";
        case Outcome::error: return "grader failed";
        case Outcome::graded: break;
    }
    if (hasError(student.result)) return "grader failed";
    return student.result.compiled ? "graded" : "does not compile";
}

std::string shownName(const Student& student) { return oneLine(student.name.empty() ? student.id : student.name); }

std::string listText(const std::vector<std::string>& texts, const std::string& between) {
    std::string list;
    for (const std::string& text : texts) list += (&text == &texts.front() ? "" : between) + oneLine(text);
    return list;
}

std::string timeText(const std::string& time) {
    const bool iso = time.size() == 20 && time[10] == 'T' && time[19] == 'Z' &&
                     time.find_first_not_of("0123456789-:TZ") == std::string::npos;
    return iso ? time.substr(0, 10) + " " + time.substr(11, 5) + " UTC" : oneLine(time);
}

}  // namespace radlab::grader

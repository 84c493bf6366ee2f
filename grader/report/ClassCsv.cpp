#include "grader/report/ClassCsv.h"

#include <algorithm>
#include <map>

#include "grader/report/CsvFile.h"
#include "grader/report/Wording.h"

namespace radlab::grader {

namespace {

// The functions' names in the order of the exercise.
std::vector<std::string> stagesOf(const std::vector<StudentResult>& results) {
    std::map<int, std::string> names;
    for (const StudentResult& student : results)
        for (const StageResult& stage : student.result.stages)
            if (!isTogether(stage)) names.emplace(stage.number, stage.stage);
    std::vector<std::string> inOrder;
    for (const auto& [number, name] : names) inOrder.push_back(name);
    return inOrder;
}

std::string marksIn(const Result& result, const std::string& name) {
    const auto stage = std::find_if(result.stages.begin(), result.stages.end(),
                                    [&](const StageResult& other) { return other.stage == name; });
    return stage == result.stages.end() || stage->status == Status::skipped ? "" : marksText(stage->score);
}

void appendMark(std::vector<std::string>& row, const StudentResult& student, const std::vector<std::string>& stages) {
    const bool marked = hasMark(student);
    row.push_back(marked ? marksText(student.result.score) : "");
    row.push_back(marked ? marksText(student.result.maxScore) : "");
    for (const std::string& stage : stages) row.push_back(marked ? marksIn(student.result, stage) : "");
    row.push_back(marked ? std::to_string(student.result.seed) : "");
}

void appendEarlier(std::vector<std::string>& row, const StudentResult& student) {
    if (student.earlier.empty()) {
        row.insert(row.end(), 3, "");
        return;
    }
    const EarlierMark& last = student.earlier.front();
    for (const std::string& value : {marksText(last.score), spreadsheetText(last.graded), std::to_string(last.seed)})
        row.push_back(value);
}

std::string titles(const std::vector<std::string>& stages) {
    std::vector<std::string> row = {"id",        "name",   "account", "outcome",  "late",
                                    "submitted", "graded", "total",   "max_total"};
    for (const std::string& stage : stages) row.push_back(spreadsheetText(stage));
    row.insert(row.end(), {"seed", "earlier_total", "earlier_graded", "earlier_seed"});
    return csvRow(row);
}

}  // namespace

std::string marksCsv(const std::vector<StudentResult>& results) {
    const std::vector<std::string> stages = stagesOf(results);
    std::string text = std::string(byteOrderMark) + titles(stages);
    for (const StudentResult& student : results) {
        const Student& who = student.student;
        std::vector<std::string> row = {spreadsheetText(who.id),        spreadsheetText(who.name),
                                        spreadsheetText(who.account),   outcomeWord(student),
                                        who.late ? "late" : "",         spreadsheetText(who.submitted),
                                        spreadsheetText(student.graded)};
        appendMark(row, student, stages);
        appendEarlier(row, student);
        text += csvRow(row);
    }
    return text;
}

std::string checksCsv(const std::vector<StudentResult>& results) {
    std::string text =
        std::string(byteOrderMark) + csvRow({"id", "stage", "check", "status", "marks", "max_marks", "mistake"});
    for (const StudentResult& student : results) {
        if (!hasMark(student)) continue;
        for (const StageResult& stage : student.result.stages)
            for (const CheckResult& check : stage.checks)
                text +=
                    csvRow({spreadsheetText(student.student.id), spreadsheetText(stage.stage),
                            spreadsheetText(check.id), statusText(check.status), marksText(check.score),
                            marksText(check.maxScore), check.diagnosis ? spreadsheetText(check.diagnosis->id) : ""});
    }
    return text;
}

}  // namespace radlab::grader

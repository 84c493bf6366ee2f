#include "grader/report/ClassPage.h"

#include <algorithm>
#include <set>

#include "grader/report/ClassOverview.h"
#include "grader/report/Digest.h"
#include "grader/report/Page.h"
#include "grader/report/StudentPage.h"
#include "grader/report/TextLines.h"
#include "grader/report/Wording.h"

namespace radlab::grader {

namespace {

using kainjow::mustache::data;

// What a status is called in the address and the style sheet.
std::string statusKey(const StudentResult& student) {
    if (student.outcome == Outcome::graded && hasError(student.result)) return outcomeText(Outcome::error);
    if (student.outcome == Outcome::graded && !student.result.compiled) return "uncompiled";
    return outcomeText(student.outcome);
}

std::string reasonOf(const StudentResult& student) {
    if (statusKey(student) == "refused") return listText(student.student.remarks, "; ");
    return student.fault.empty() ? "the grader failed in one of the checks" : student.fault;
}

void setTroubles(data& values, const std::vector<StudentResult>& results) {
    data troubles{data::type::list};
    for (const StudentResult& student : results) {
        const std::string key = statusKey(student);
        if (key != "error" && key != "refused") continue;
        data entry = linkTo(student.student);
        entry.set("status_key", key);
        entry.set("status_word", outcomeWord(student));
        entry.set("reason", oneLine(shown(reasonOf(student))));
        troubles << entry;
    }
    if (troubles.is_empty_list()) return;
    data section;
    section.set("entries", troubles);
    values.set("troubles", section);
}

std::string mistakesOf(const StudentResult& student) {
    std::set<std::string> ids;
    for (const StageResult& stage : student.result.stages)
        for (const CheckResult& check : stage.checks)
            if (check.status == Status::fail && check.diagnosis) ids.insert(oneLine(check.diagnosis->id));
    std::string text;
    for (const std::string& id : ids) text += " " + id;
    return text;
}

data stageCell(const StudentResult& student, const StageFigures& column) {
    data cell;
    cell.set("score", "");
    cell.set("kind", "none");
    if (!hasMark(student)) return cell;
    for (const StageResult& stage : student.result.stages) {
        if (stage.stage != column.stage || stage.status == Status::skipped) continue;
        const bool full = stage.status == Status::pass, none = stage.score <= 0.0;
        cell.set("score", marksText(stage.score));
        cell.set("kind", full ? "full" : none ? "zero" : "part");
    }
    return cell;
}

data rowData(const StudentResult& student, const ClassFigures& figures) {
    data row = linkTo(student.student);
    const std::string key = statusKey(student), id = oneLine(student.student.id);
    setUnlessEmpty(row, "id", id == shownName(student.student) ? "" : id);
    row.set("status_key", key);
    row.set("status_word", outcomeWord(student));
    row.set("total", hasMark(student) ? marksText(student.result.score) : "");
    row.set("late", student.student.late);
    row.set("found", oneLine(student.student.account) + mistakesOf(student));
    data cells{data::type::list};
    for (const StageFigures& stage : figures.stages)
        if (stage.maxScore > 0.0) cells << stageCell(student, stage);
    row.set("cells", cells);
    return row;
}

void setTable(data& values, const ClassFigures& figures, const std::vector<StudentResult>& results) {
    data columns{data::type::list}, rows{data::type::list};
    for (const StageFigures& stage : figures.stages) {
        if (stage.maxScore <= 0.0) continue;
        data column;
        column.set("stage_name", oneLine(stage.stage));
        column.set("stage_number", std::to_string(stage.number));
        column.set("most", marksText(stage.maxScore));
        columns << column;
    }
    for (const StudentResult& student : results) rows << rowData(student, figures);
    values.set("columns", columns);
    values.set("rows", rows);
}

void setInfo(data& values, const ClassInfo& info) {
    values.set("class_title", oneLine(info.title));
    setUnlessEmpty(values, "graded", timeText(info.graded));
    setUnlessEmpty(values, "version", oneLine(info.version));
    data files{data::type::list};
    for (const std::string& file : info.files) files << data("file", oneLine(file));
    values.set("files", files);
    setUnlessEmpty(values, "protections", listText(info.protections));
}

}  // namespace

std::string classPage(const ClassInfo& info, const std::vector<StudentResult>& results) {
    const ClassFigures figures = figuresOf(results);
    const std::string script = pageResource("class.js");
    data values;
    values.set("script", script);
    values.set("script_hash", sha256Base64(script));
    setInfo(values, info);
    setOverview(values, figures, results);
    setTroubles(values, results);
    setTable(values, figures, results);
    return renderPage("class.mustache", values);
}

}  // namespace radlab::grader

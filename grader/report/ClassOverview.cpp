#include "grader/report/ClassOverview.h"

#include <cmath>

#include "grader/report/Histogram.h"
#include "grader/report/Page.h"
#include "grader/report/StudentPage.h"
#include "grader/report/TextLines.h"
#include "grader/report/Wording.h"

namespace radlab::grader {

namespace {

using kainjow::mustache::data;

constexpr std::size_t shownMisconceptions = 8;       // the rest is folded up
constexpr int classHeight = 170, stageHeight = 112;  // of histograms, in pixels

std::string shareText(std::size_t part, std::size_t whole) {
    const double share = whole > 0 ? static_cast<double>(part) / static_cast<double>(whole) : 0.0;
    return std::to_string(std::lround(100.0 * share));
}

std::string oneDecimal(double value) { return marksText(std::round(10.0 * value) / 10.0); }

void addFigure(data& list, const std::string& value, const std::string& word, const std::string& view) {
    data figure;
    figure.set("value", value);
    figure.set("word", word);
    setUnlessEmpty(figure, "view", view);
    list << figure;
}

void setFigures(data& values, const ClassFigures& figures) {
    data list{data::type::list};
    const auto count = [&](const char* word, const char* view) {
        const auto found = figures.outcomes.find(word);
        if (found != figures.outcomes.end()) addFigure(list, std::to_string(found->second), word, view);
    };
    addFigure(list, std::to_string(figures.students), figures.students == 1 ? "student" : "students", "all");
    count("graded", "status=graded");
    count("does not compile", "status=uncompiled");
    count("nothing handed in", "status=nothing");
    count("refused", "status=refused");
    count("grader failed", "status=error");
    if (figures.late > 0) addFigure(list, std::to_string(figures.late), "late", "status=late");
    if (!figures.scores.empty()) {
        addFigure(list, oneDecimal(figures.mean), "mean of " + marksText(figures.maxScore), "");
        addFigure(list, oneDecimal(figures.median), "median", "");
    }
    values.set("figures", list);
}

data checkFigures(const CheckFigures& check) {
    data entry;
    entry.set("check_name", oneLine(check.name.empty() ? check.id : check.name));
    entry.set("passed", std::to_string(check.passed));
    entry.set("judged", std::to_string(check.judged));
    entry.set("share", shareText(check.passed, check.judged));
    return entry;
}

data stageFigures(const StageFigures& stage) {
    data entry;
    entry.set("stage_name", stageName(stage.stage));
    if (!isTogether(stage.stage)) entry.set("stage_number", std::to_string(stage.number));
    entry.set("right", std::to_string(stage.passed));
    entry.set("judged_students", std::to_string(stage.scores.size()));
    setUnlessEmpty(entry, "not_started", stage.notStarted > 0 ? std::to_string(stage.notStarted) : "");
    if (stage.maxScore > 0.0) {
        entry.set("histogram",
                  histogramSvg(stage.scores, stage.maxScore, stageHeight, "Marks in " + stageName(stage.stage)));
        entry.set("mean", oneDecimal(meanOf(stage.scores)) + " of " + marksText(stage.maxScore));
    }
    data checks{data::type::list};
    for (const CheckFigures& check : stage.checks) checks << checkFigures(check);
    if (!stage.checks.empty()) entry.set("has_checks", true);
    entry.set("checks", checks);
    return entry;
}

void setStages(data& values, const ClassFigures& figures) {
    if (figures.scores.empty() || figures.maxScore <= 0.0) return;
    values.set("all_marks", histogramSvg(figures.scores, figures.maxScore, classHeight, "Marks of the class"));
    data stages{data::type::list};
    for (const StageFigures& stage : figures.stages) stages << stageFigures(stage);
    values.set("stages", stages);
}

data misconceptionData(const Misconception& misconception, const std::vector<StudentResult>& results,
                       std::size_t marked) {
    data entry;
    const std::size_t count = misconception.students.size();
    entry.set("count", std::to_string(count));
    entry.set("of_students", count == 1 ? "student" : "students");
    entry.set("share", shareText(count, marked));
    entry.set("id", oneLine(misconception.diagnosis.id));
    entry.set("stage_name", stageName(misconception.stage));
    entry.set("text", shown(misconception.diagnosis.text));
    data who{data::type::list};
    for (const std::size_t number : misconception.students) who << linkTo(results[number].student);
    entry.set("who", who);
    return entry;
}

void setMisconceptions(data& values, const ClassFigures& figures, const std::vector<StudentResult>& results) {
    if (figures.misconceptions.empty()) return;
    data common{data::type::list}, rare{data::type::list};
    for (std::size_t i = 0; i < figures.misconceptions.size(); ++i)
        (i < shownMisconceptions ? common : rare)
            << misconceptionData(figures.misconceptions[i], results, figures.scores.size());
    data both;
    both.set("common", common);
    both.set("rare", rare);
    if (figures.misconceptions.size() > shownMisconceptions)
        both.set("rare_count", std::to_string(figures.misconceptions.size() - shownMisconceptions));
    values.set("misconceptions", both);
    values.set("mistake", pageResource("mistake.mustache"));
}

}  // namespace

void setOverview(data& values, const ClassFigures& figures, const std::vector<StudentResult>& results) {
    setFigures(values, figures);
    setStages(values, figures);
    setMisconceptions(values, figures, results);
}

data linkTo(const Student& student) {
    data link;
    link.set("address", studentPageFile(student));
    link.set("student_name", shownName(student));
    return link;
}

}  // namespace radlab::grader

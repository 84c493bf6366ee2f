#include "grader/report/StudentPage.h"

#include <algorithm>

#include "base/Error.h"
#include "grader/report/Digest.h"
#include "grader/report/Page.h"
#include "grader/report/ResultData.h"
#include "grader/report/TextLines.h"
#include "grader/report/Wording.h"

namespace radlab::grader {

namespace {

using kainjow::mustache::data;

constexpr const char* idLetters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789._-";

std::optional<ShownPicture> embedded(const std::vector<CheckPicture>& pictures, const StageResult& stage,
                                     const CheckResult& check) {
    const auto found = std::find_if(pictures.begin(), pictures.end(), [&](const CheckPicture& picture) {
        return picture.stage == stage.stage && picture.check == check.id;
    });
    if (found == pictures.end()) return std::nullopt;
    ShownPicture shown{found->caption, found->rms, found->tolerance, {}};
    for (const PngImage& image : found->images)
        if (check.status != Status::pass || image.title == "yours")
            shown.images.push_back(
                {"data:image/png;base64," + base64(image.png), image.title, image.width, image.height});
    return shown;
}

std::string factsOf(const StudentResult& student) {
    std::string facts;
    const auto add = [&](const std::string& fact) { facts += (facts.empty() ? "" : " · ") + fact; };
    const std::string id = oneLine(student.student.id);
    if (id != shownName(student.student)) add(id);
    if (!student.student.submitted.empty()) add("handed in " + timeText(student.student.submitted));
    if (hasMark(student) && !student.graded.empty()) add("graded " + timeText(student.graded));
    return facts;
}

void setStudent(data& values, const StudentResult& student, const PageOptions& options) {
    data entry;
    entry.set("student_name", shownName(student.student));
    entry.set("facts", factsOf(student));
    if (student.student.late) entry.set("late", true);
    setUnlessEmpty(entry, "class_page", options.classPage);
    values.set("student", entry);
}

void setRemarks(data& values, const StudentResult& student) {
    if (student.student.remarks.empty()) return;
    data lines{data::type::list};
    for (const std::string& remark : student.student.remarks) {
        data line;
        line.set("line", oneLine(remark));
        lines << line;
    }
    data remarks;
    remarks.set("remarks_title", student.outcome == Outcome::refused ? "Why nothing was taken" : "What was not taken");
    remarks.set("lines", lines);
    values.set("remarks", remarks);
}

data givenMark(double score, double maxScore, const std::string& graded, const std::string& submitted) {
    data entry;
    entry.set("given_mark", marksText(score) + "/" + marksText(maxScore));
    entry.set("given_when", timeText(graded));
    entry.set("given_for", timeText(submitted));
    return entry;
}

void setEarlier(data& values, const StudentResult& student) {
    if (student.earlier.empty()) return;
    data given{data::type::list};
    if (hasMark(student)) {
        data now = givenMark(student.result.score, student.result.maxScore, student.graded, student.student.submitted);
        now.set("is_new", true);
        given << now;
    }
    for (const EarlierMark& mark : student.earlier)
        given << givenMark(mark.score, mark.maxScore, mark.graded, mark.submitted);
    data earlier;
    earlier.set("given", given);
    values.set("earlier", earlier);
}

// Where there is nothing to show but why.
void setOutcome(data& values, Outcome outcome) {
    const auto say = [&](const char* verdict, const char* explanation) {
        values.set("verdict", verdict);
        values.set("explanation", explanation);
    };
    if (outcome == Outcome::nothing)
        say("Nothing was handed in.", "There was no file to grade, or an empty one.");
    else if (outcome == Outcome::refused)
        say("What was handed in was refused.", "None of it could be taken, so nothing was graded.");
    else
        say("The grader or the machine failed.",
            "That is no fault of the submission, and there is no mark for it. It has to be graded again.");
}

}  // namespace

std::string studentPage(const StudentResult& student, const std::vector<CheckPicture>& pictures,
                        const PageOptions& options) {
    data values;
    values.set("images_from", "data:");
    setStudent(values, student, options);
    setRemarks(values, student);
    setEarlier(values, student);
    if (student.outcome == Outcome::graded)
        setResult(values, student.result,
                  [&](const StageResult& stage, const CheckResult& check) { return embedded(pictures, stage, check); });
    else
        setOutcome(values, student.outcome);
    return renderPage("report.mustache", values);
}

std::string studentPageFile(const Student& student) {
    RADLAB_CHECK(student.id.find_first_not_of(idLetters) == std::string::npos);
    return "students/" + student.id + ".html";
}

}  // namespace radlab::grader

#include "grader/report/JUnit.h"

#include <cstdio>

#include <tinyxml2.h>

#include "grader/protocol/PlainText.h"
#include "grader/report/TextLines.h"
#include "grader/report/Wording.h"

namespace radlab::grader {

namespace {

constexpr std::size_t longestInXml = 65536;     // bytes of one text
constexpr std::size_t longestAttribute = 1024;  // bytes; the text of the element says it in full

struct Counts {
    int tests = 0, failures = 0, errors = 0, skipped = 0;
    double seconds = 0.0;

    void add(const CheckResult& check) {
        ++tests;
        seconds += check.seconds;
        if (check.status == Status::fail)
            ++failures;
        else if (check.status == Status::error)
            ++errors;
        else if (check.status != Status::pass)
            ++skipped;
    }

    void add(const Counts& more) {
        tests += more.tests;
        failures += more.failures;
        errors += more.errors;
        skipped += more.skipped;
        seconds += more.seconds;
    }
};

// Checks that stand for their stage where it has none, so that its status is not lost.
std::vector<CheckResult> checksOf(const StageResult& stage) {
    if (!stage.checks.empty()) return stage.checks;
    CheckResult whole;
    whole.name = stageName(stage);
    whole.status = stage.status;
    whole.score = stage.score;
    whole.maxScore = stage.maxScore;
    return {whole};
}

Counts countsOf(const std::vector<StageResult>& stages) {
    Counts counts;
    for (const StageResult& stage : stages)
        for (const CheckResult& check : checksOf(stage)) counts.add(check);
    return counts;
}

// Where checks come from, and how much of them is told.
struct Source {
    std::string file, classes = "radlab.";
    bool output = true;  // what the submission printed, too
};

// What stands for a submission of which no stage could be judged.
StageResult insteadOfStages(Status status, const std::string& claim, const std::string& why) {
    CheckResult check;
    check.name = claim;
    check.status = status;
    check.message = why;
    StageResult stage;
    stage.stage = "submission";
    stage.status = status;
    stage.checks = {check};
    return stage;
}

std::vector<StageResult> stagesOf(const Result& result) {
    if (result.compiled) {
        std::vector<StageResult> all = result.stages;
        all.insert(all.end(), result.extensions.begin(), result.extensions.end());
        return all;
    }
    return {insteadOfStages(Status::fail, "the submission compiles", result.compiler)};
}

std::vector<StageResult> stagesOf(const StudentResult& student) {
    const std::string remarks = listText(student.student.remarks, "\n");
    switch (student.outcome) {
        case Outcome::nothing: return {insteadOfStages(Status::skipped, "something is handed in", "nothing handed in")};
        case Outcome::refused: return {insteadOfStages(Status::fail, "what is handed in can be taken", remarks)};
        case Outcome::error: return {insteadOfStages(Status::error, "the grader works", student.fault)};
        case Outcome::graded: break;
    }
    return stagesOf(student.result);
}

// tinyxml2 escapes, and takes the bytes of a text as they are.
class Writer {
public:
    Writer() { printer.PushHeader(false, true); }

    void open(const char* element) { printer.OpenElement(element); }
    void close() { printer.CloseElement(); }
    void attribute(const char* name, const std::string& bytes) {
        // A reader turns newlines in attributes into spaces, so they are written as such.
        printer.PushAttribute(name, oneLine(xmlText(startOf(bytes, longestAttribute))).c_str());
    }
    void attribute(const char* name, int number) { printer.PushAttribute(name, number); }
    void seconds(double value) {
        char text[32];
        std::snprintf(text, sizeof text, "%.3f", value);
        printer.PushAttribute("time", text);
    }
    void text(const std::string& bytes) { printer.PushText(xmlText(startOf(bytes, longestInXml)).c_str()); }
    void counts(const Counts& counts) {
        attribute("tests", counts.tests);
        attribute("failures", counts.failures);
        attribute("errors", counts.errors);
        attribute("skipped", counts.skipped);
        seconds(counts.seconds);
    }
    void property(const char* name, const std::string& value) {
        open("property");
        attribute("name", name);
        attribute("value", value);
        close();
    }
    std::string result() const { return printer.CStr(); }

private:
    tinyxml2::XMLPrinter printer;
};

void writeProperties(Writer& out, const Result& result, const StageResult& stage) {
    out.open("properties");
    out.property("score", marksText(stage.score));
    out.property("max_score", marksText(stage.maxScore));
    out.property("seed", std::to_string(result.seed));
    for (const std::string& protection : result.protections) out.property("protection", protection);
    out.close();
}

std::string explanation(const CheckResult& check) {
    std::string text = check.message;
    const auto add = [&text](const char* heading, const std::string& more) {
        if (!more.empty()) text += (text.empty() ? "" : "\n\n") + std::string(heading) + more;
    };
    if (check.diagnosis) add("What is wrong: ", check.diagnosis->text);
    add("A case that fails, as C++:\n", check.example);
    return text;
}

void writeOutcome(Writer& out, const CheckResult& check) {
    if (check.status == Status::pass) return;
    const bool wrong = check.status == Status::fail, error = check.status == Status::error;
    out.open(wrong ? "failure" : error ? "error" : "skipped");
    out.attribute("message", check.message.empty() ? statusWord(check.status) : check.message);
    if (wrong) out.attribute("type", check.diagnosis ? check.diagnosis->id : "wrong");
    if (error) out.attribute("type", "grader");
    if (wrong || error) out.text(explanation(check));
    out.close();
}

void writeCheck(Writer& out, const Source& source, const StageResult& stage, const CheckResult& check) {
    out.open("testcase");
    out.attribute("name", check.name.empty() ? check.id : check.name);
    out.attribute("classname", source.classes + stage.stage);
    out.seconds(check.seconds);
    if (!source.file.empty()) out.attribute("file", source.file);
    writeOutcome(out, check);
    if (source.output && !check.output.empty()) {
        out.open("system-out");
        out.text(check.output);
        out.close();
    }
    out.close();
}

void writeStage(Writer& out, const Result& result, const StageResult& stage) {
    const Source source{result.submission};
    out.open("testsuite");
    out.attribute("name", stage.stage);
    out.counts(countsOf({stage}));
    out.attribute("file", result.submission);
    writeProperties(out, result, stage);
    for (const CheckResult& check : checksOf(stage)) writeCheck(out, source, stage, check);
    out.close();
}

void writeStudent(Writer& out, const StudentResult& student, const std::vector<StageResult>& stages) {
    const Source source{"", student.student.id + ".", false};
    out.open("testsuite");
    out.attribute("name", student.student.id);
    out.counts(countsOf(stages));
    if (!student.graded.empty()) out.attribute("timestamp", student.graded);
    out.open("properties");
    out.property("student", student.student.name);
    out.property("outcome", outcomeWord(student));
    if (hasMark(student)) {
        out.property("score", marksText(student.result.score));
        out.property("max_score", marksText(student.result.maxScore));
        out.property("seed", std::to_string(student.result.seed));
    }
    if (student.student.late) out.property("late", "true");
    out.close();
    for (const StageResult& stage : stages)
        for (const CheckResult& check : checksOf(stage)) writeCheck(out, source, stage, check);
    out.close();
}

}  // namespace

std::string junitXml(const Result& result) {
    const std::vector<StageResult> stages = stagesOf(result);
    Counts all = countsOf(stages);
    all.seconds = result.seconds;
    Writer out;
    out.open("testsuites");
    out.attribute("name", "radlab");
    out.counts(all);
    for (const StageResult& stage : stages) writeStage(out, result, stage);
    out.close();
    return out.result();
}

std::string classJunitXml(const std::vector<StudentResult>& results) {
    Counts all;
    for (const StudentResult& student : results) all.add(countsOf(stagesOf(student)));
    Writer out;
    out.open("testsuites");
    out.attribute("name", "radlab");
    out.counts(all);
    for (const StudentResult& student : results) writeStudent(out, student, stagesOf(student));
    out.close();
    return out.result();
}

}  // namespace radlab::grader

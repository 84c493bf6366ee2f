#include "grader/report/JUnit.h"

#include <cstdio>

#include <tinyxml2.h>

#include "grader/protocol/PlainText.h"
#include "grader/report/TextLines.h"
#include "grader/report/Wording.h"

namespace radlab::grader {

namespace {

constexpr std::size_t longestText = 65536;      // bytes of one text
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

Counts countsOf(const StageResult& stage) {
    Counts counts;
    for (const CheckResult& check : checksOf(stage)) counts.add(check);
    return counts;
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
    void text(const std::string& bytes) { printer.PushText(xmlText(startOf(bytes, longestText)).c_str()); }
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

void writeCheck(Writer& out, const Result& result, const StageResult& stage, const CheckResult& check) {
    out.open("testcase");
    out.attribute("name", check.name.empty() ? check.id : check.name);
    out.attribute("classname", "radlab." + stage.stage);
    out.seconds(check.seconds);
    out.attribute("file", result.submission);
    writeOutcome(out, check);
    if (!check.output.empty()) {
        out.open("system-out");
        out.text(check.output);
        out.close();
    }
    out.close();
}

void writeStage(Writer& out, const Result& result, const StageResult& stage) {
    out.open("testsuite");
    out.attribute("name", stage.stage);
    out.counts(countsOf(stage));
    out.attribute("file", result.submission);
    writeProperties(out, result, stage);
    for (const CheckResult& check : checksOf(stage)) writeCheck(out, result, stage, check);
    out.close();
}

Counts countsOf(const Result& result) {
    Counts all;
    for (const StageResult& stage : result.stages)
        for (const CheckResult& check : checksOf(stage)) all.add(check);
    all.seconds = result.seconds;
    return all;
}

}  // namespace

std::string junitXml(const Result& result) {
    Writer out;
    out.open("testsuites");
    out.attribute("name", "radlab");
    out.counts(countsOf(result));
    for (const StageResult& stage : result.stages) writeStage(out, result, stage);
    out.close();
    return out.result();
}

}  // namespace radlab::grader

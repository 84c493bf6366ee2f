#include "grader/report/Terminal.h"

#include <sstream>
#include <vector>

#include <doctest/doctest.h>

#include "grader/protocol/PlainText.h"
#include "grader/report/PageTestHelp.h"
#include "grader/report/SampleResult.h"
#include "grader/report/TextLines.h"

using namespace radlab::grader;
using namespace radlab::grader::test;

namespace {

std::vector<std::string> linesOf(const std::string& report) {
    std::vector<std::string> lines;
    std::istringstream in(report);
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
}

std::vector<std::string> reportLines(const Result& result, const ReportOptions& options = {}) {
    return linesOf(terminalReport(result, options));
}

std::string lastLine(const Result& result, const ReportOptions& options = {}) {
    return reportLines(result, options).back();
}

void checkSize(const Result& result, const ReportOptions& options, std::size_t most) {
    const std::vector<std::string> lines = reportLines(result, options);
    CHECK(lines.size() <= most);
    for (const std::string& line : lines) {
        CAPTURE(line);
        CHECK(columnsOf(line) <= 100);
    }
}

const std::string manyWords = [] {
    std::string text;
    for (int i = 0; i < 3000; ++i) text += i % 9 ? "word " : "line\n";
    return text;
}();

}  // namespace

TEST_CASE("terminal: one line a stage, then the first that fails, the score, the next step") {
    CHECK(terminalReport(oneWrong()) ==
          R"(  1  maxenergy_patch      10/10  right
  2  calcAnalyticalFF      8/20  wrong
  3  distributeEnergy     20/20  right
  4  colorReconstruction  15/15  right
  5  renderPatchIDs       15/15  right
  6  calcFF                0/20  not started
     all together: blocked

calcAnalyticalFF (stage 2): 3 of 5 checks fail
  -4  two facing patches match the formula
      F(0 -> 1) is 0.250000, expected 0.0795775 within 1e-5: unit squares that face each other at
      distance 2.
      what is wrong: Every form factor is π times too large: the factor 1/π of the formula is
      missing. Without it a patch would send out more power than it has.
      it printed:
      | debug: cos = 1.000000
      | debug: F = 0.25
  -4  the form factors of a closed box sum to 1
  -4  a scene made larger has the same form factors

score: 68/100
next: mend calcAnalyticalFF (stage 2); ./radlab check calcAnalyticalFF --hint says more
)");
}

TEST_CASE("terminal: the hint is shown when asked for, and announced otherwise") {
    const std::string with = terminalReport(oneWrong(), {.hints = true}), without = terminalReport(oneWrong());
    CHECK(contains(with, "look at: The sum of all form factors in a closed room is 1."));
    CHECK_FALSE(contains(with, "--hint"));
    CHECK_FALSE(contains(without, "look at"));
    CHECK(contains(without, "--hint says more"));
    CHECK(lastLine(oneWrong(), {.hints = true}) ==
          "next: mend calcAnalyticalFF (stage 2) in exercises/ProgRef.cpp, then ./radlab check calcAnalyticalFF");
}

TEST_CASE("terminal: where no hint is known, none is announced") {
    Result result = oneWrong();
    result.stages[1].checks[1].diagnosis.reset();
    CHECK_FALSE(contains(terminalReport(result), "--hint"));
    result.stages[1].checks[1].hint = "of the check itself";
    CHECK(contains(terminalReport(result), "--hint"));
    CHECK(contains(terminalReport(result, {.hints = true}), "look at: of the check itself"));
}

TEST_CASE("terminal: without a diagnosis the smallest case that fails is shown as C++") {
    Result result = oneWrong();
    CHECK_FALSE(contains(terminalReport(result), "as C++"));
    result.stages[1].checks[1].diagnosis.reset();
    CHECK(contains(terminalReport(result),
                   "\n      a case that fails, as C++ (whole with --html or --json):\n"
                   "          Scene room = facingSquares(2.0f);\n"
                   "          publish(room);\n"));
}

TEST_CASE("terminal: with one stage that fails there are at most 25 lines of 100 columns, however long the texts") {
    for (const std::string& text : {std::string(100000, 'x'), manyWords, std::string(5000, '\n') + "end",
                                    std::string(3000, '\t'), std::string(9000, '\x1b'), hostileText()}) {
        CAPTURE(text.substr(0, 20));
        for (const bool hints : {false, true})
            for (const bool diagnosed : {false, true}) {
                Result result = withTexts(oneWrong(), text);
                if (!diagnosed) result.stages[1].checks[1].diagnosis.reset();
                result.stages[1].checks.resize(40, result.stages[1].checks[1]);
                result.submission = "home/" + std::string(300, 'y') + "/" + text;
                checkSize(result, {.hints = hints}, 25);
                result.stages[2].status = Status::error;
                result.stages[2].checks = {check("x", text, Status::error, 1)};
                result.stages[2].checks[0].message = text;
                checkSize(result, {.hints = hints}, 25);
            }
    }
}

TEST_CASE("terminal: of many long texts each part still gets its lines") {
    Result result = withTexts(oneWrong(), manyWords);
    result.stages[1].checks.resize(40, result.stages[1].checks[1]);
    const std::string report = terminalReport(result, {.hints = true});
    CHECK(contains(report, "what is wrong: "));
    CHECK(contains(report, "look at: "));
    CHECK(contains(report, "it printed:"));
    CHECK(contains(report, "  and 36 more"));
    CHECK(linesOf(report).size() == 25);
}

TEST_CASE("terminal: details explain every stage that fails, at length") {
    Result result = oneWrong();
    result.stages[4] = result.stages[1];
    result.stages[4].stage = "renderPatchIDs";
    result.stages[4].number = 5;
    result.stages[4].checks.resize(12, tellingCheck());
    CHECK_FALSE(contains(terminalReport(result), "renderPatchIDs (stage 5): "));
    const std::string report = terminalReport(result, {.details = true});
    CHECK(contains(report, "calcAnalyticalFF (stage 2): 3 of 5 checks fail"));
    CHECK(contains(report, "renderPatchIDs (stage 5): 10 of 12 checks fail"));
    CHECK_FALSE(contains(report, "more\n\n"));
    checkSize(withTexts(result, manyWords), {.details = true}, 200);
}

TEST_CASE("terminal: what a submission prints can neither steer the terminal nor pass for a line of the report") {
    const Result result = withTexts(oneWrong(), hostileText());
    for (const ReportOptions options : {ReportOptions{}, ReportOptions{.hints = true, .details = true}}) {
        const std::string report = terminalReport(result, options);
        CHECK_FALSE(contains(report, "\x1b"));
        CHECK_FALSE(contains(report, "\u009b"));
        CHECK_FALSE(contains(report, "\u202E"));
        CHECK(contains(report, "\\x1b[2J"));
        CHECK(validUtf8(report) == report);
        int scores = 0;
        for (const std::string& line : linesOf(report)) scores += line.rfind("score:", 0) == 0;
        CHECK(scores == 1);
    }
}

TEST_CASE("terminal: colours only where they are asked for, and nothing else changes") {
    const std::string plain = terminalReport(oneWrong());
    std::string colored = terminalReport(oneWrong(), {.color = true});
    CHECK(contains(colored, "\x1b[32mright\x1b[0m"));
    CHECK(contains(colored, "\x1b[31mwrong\x1b[0m"));
    CHECK(contains(terminalReport(resultWith(Status::error), {.color = true}), "\x1b[33mgrader failed"));
    for (const char* code : {"\x1b[0m", "\x1b[1m", "\x1b[31m", "\x1b[32m"})
        for (std::size_t at = 0; (at = colored.find(code)) != std::string::npos;)
            colored.erase(at, std::string(code).size());
    CHECK(colored == plain);
}

TEST_CASE("terminal: when nothing is written yet the report is short and names the first function") {
    for (const Status last : {Status::notStarted, Status::blocked}) {
        Result result = resultWith(Status::notStarted);
        result.stages[6].status = last;
        CHECK(terminalReport(result) ==
              R"(Nothing is written yet, so nothing is wrong. To be written, in this order: maxenergy_patch,
calcAnalyticalFF, distributeEnergy, colorReconstruction, renderPatchIDs, calcFF.

score: 0/100
next: write maxenergy_patch (stage 1) in exercises/ProgRef.cpp, then ./radlab check
)");
    }
}

TEST_CASE("terminal: the next step is the first function that is not written, where none is wrong") {
    Result result = resultWith(Status::pass);
    result.stages[1] = stage(2, "calcAnalyticalFF", Status::notStarted, 20);
    result.stages[5] = stage(6, "calcFF", Status::notStarted, 20);
    CHECK(lastLine(result) == "next: write calcAnalyticalFF (stage 2) in exercises/ProgRef.cpp, then ./radlab check");
    result.submission = "/" + std::string(80, 'd') + "/ProgRef.cpp";
    CHECK(lastLine(result) == "next: write calcAnalyticalFF (stage 2) in …/ProgRef.cpp, then ./radlab check");
    result.submission = "";
    CHECK(lastLine(result) == "next: write calcAnalyticalFF (stage 2), then ./radlab check");
}

TEST_CASE("terminal: when all is right nothing is left to do") {
    const std::vector<std::string> lines = reportLines(resultWith(Status::pass));
    CHECK(lines[6] == "     all together: right");
    CHECK(lines[lines.size() - 2] == "score: 100/100");
    CHECK(lines.back() ==
          "next: nothing is left to do: all six are right; ./radlab demo --exercise shows what they draw");
}

TEST_CASE("terminal: when only the functions together fail, that is explained like a stage") {
    Result result = resultWith(Status::pass);
    result.stages[6].status = Status::fail;
    result.stages[6].checks = {check("all.room", "a room is lit as by the reference", Status::fail, 0)};
    CHECK(contains(terminalReport(result), "the functions together: 1 of 1 checks fails\n   -  a room is lit"));
    CHECK(lastLine(result) ==
          "next: find why the functions fail together in exercises/ProgRef.cpp, then ./radlab check together");
}

TEST_CASE("terminal: a failure of the grader is not the student's, and asks for another run") {
    Result result = oneWrong();
    result.stages[3].status = Status::error;
    result.stages[3].checks = {check("x", "y", Status::error, 5)};
    result.stages[3].checks[0].message = "the worker did not start: no memory";
    const std::string report = terminalReport(result);
    CHECK(contains(report, "colorReconstruction  15/15  grader failed, no marks taken\n"));
    CHECK(contains(
        report, "failed at colorReconstruction, and takes no marks for that: the worker did\nnot start: no memory\n"));
    CHECK(contains(report, "\nscore: 68/100, not final\nnext: run ./radlab check again; if it fails again, "));
    CHECK(contains(report, "look at: --hint shows more"));
}

TEST_CASE("terminal: one check in which the grader failed makes its stage one in which it failed") {
    Result result = resultWith(Status::pass);
    result.stages[3].checks = {check("x", "y", Status::error, 5)};
    CHECK(contains(terminalReport(result), "grader failed"));
}

TEST_CASE("terminal: a stage that could not be judged says why") {
    Result result = oneWrong();
    result.stages[6].checks = {check("x", "y", Status::blocked, 0)};
    result.stages[6].checks[0].message = "needs calcFF";
    CHECK(contains(terminalReport(result), "all together: blocked: needs calcFF\n"));
}

TEST_CASE("terminal: stages that nobody asked for are not shown") {
    Result result = resultWith(Status::skipped);
    result.stages[0].status = Status::pass;
    result.stages[0].score = result.score = 10;
    result.maxScore = 10;
    CHECK(terminalReport(result) ==
          "  1  maxenergy_patch  10/10  right\n\nscore: 10/10\nnext: ./radlab check judges all six functions\n");
    result.stages = {result.stages[0]};
    CHECK(reportLines(result).size() == 4);
    result.stages[0].status = Status::blocked;
    CHECK(contains(lastLine(result), "says which one comes first"));
    result.stages.clear();
    CHECK(terminalReport(result) == "score: 10/10\nnext: ./radlab check judges all six functions\n");
}

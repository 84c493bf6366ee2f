#pragma once

// Invented results for the tests of the reports.

#include <string>
#include <utility>
#include <vector>

#include "grader/protocol/Result.h"

namespace radlab::grader::test {

inline CheckResult check(std::string id, std::string name, Status status, double maxScore) {
    CheckResult check;
    check.id = std::move(id);
    check.name = std::move(name);
    check.status = status;
    check.score = status == Status::pass ? maxScore : 0.0;
    check.maxScore = maxScore;
    return check;
}

inline StageResult stage(int number, std::string function, Status status, double maxScore) {
    StageResult stage;
    stage.number = number;
    stage.stage = std::move(function);
    stage.status = status;
    stage.score = status == Status::pass ? maxScore : 0.0;
    stage.maxScore = maxScore;
    return stage;
}

/// All six functions and all together, each with one status, without checks.
inline Result resultWith(Status status) {
    const std::vector<std::pair<std::string, double>> functions = {
        {"maxenergy_patch", 10},     {"calcAnalyticalFF", 20}, {"distributeEnergy", 20},
        {"colorReconstruction", 15}, {"renderPatchIDs", 15},   {"calcFF", 20}};
    Result result;
    result.submission = "exercises/ProgRef.cpp";
    result.seed = 42;
    result.maxScore = 100;
    for (const auto& [function, marks] : functions) {
        result.stages.push_back(stage(static_cast<int>(result.stages.size()) + 1, function, status, marks));
        result.score += result.stages.back().score;
    }
    result.stages.push_back(stage(7, "together", status, 0));
    return result;
}

/// A check that fails in the way that says most: with a message, a diagnosis, an example, output and a hint.
inline CheckResult tellingCheck() {
    CheckResult telling = check("ff.facing", "two facing patches match the formula", Status::fail, 4);
    telling.message =
        "F(0 -> 1) is 0.250000, expected 0.0795775 within 1e-5: unit squares that face each other at distance 2.";
    telling.diagnosis = {"missing-inverse-pi",
                         "Every form factor is π times too large: the factor 1/π of the formula is missing. Without "
                         "it a patch would send out more power than it has.",
                         "The sum of all form factors in a closed room is 1. Which factor makes the integral of the "
                         "cosine over the hemisphere 1?"};
    telling.example =
        "Scene room = facingSquares(2.0f);\npublish(room);\npolygons[0]->unshot_rad = Vec3f(1);\n"
        "MyPolygon* shooter = calcAnalyticalFF();\nCHECK(shooter == polygons[0]);\n"
        "CHECK(polygons[1]->formF == Approx(0.0795775));\n";
    telling.output = "debug: cos = 1.000000\ndebug: F = 0.25\n";
    return telling;
}

/// One stage that is wrong, one that is not started, the rest right.
inline Result oneWrong() {
    Result result = resultWith(Status::pass);
    StageResult& wrong = result.stages[1];
    wrong = stage(2, "calcAnalyticalFF", Status::fail, 20);
    wrong.title = "Form factors by formula";
    wrong.score = 8;
    wrong.checks = {check("ff.shooter", "the brightest patch is returned", Status::pass, 4), tellingCheck(),
                    check("ff.closed", "the form factors of a closed box sum to 1", Status::fail, 4),
                    check("ff.back", "patches that turn their backs get nothing", Status::pass, 4),
                    check("ff.scale", "a scene made larger has the same form factors", Status::fail, 4)};
    result.stages[5] = stage(6, "calcFF", Status::notStarted, 20);
    result.stages[6] = stage(7, "together", Status::blocked, 0);
    result.score = 68;
    return result;
}

/// All texts replaced by another one, as long or hostile as a test likes.
inline Result withTexts(Result result, const std::string& text) {
    for (StageResult& stage : result.stages) {
        stage.title = text;
        for (CheckResult& check : stage.checks) {
            check.name = check.message = check.example = check.output = check.hint = text;
            if (check.diagnosis) check.diagnosis = {text, text, text};
        }
    }
    result.protections = {text, text};
    return result;
}

/// Bytes that a submission might print to break a report: escapes of a terminal, markup, templates, broken UTF-8.
inline std::string hostileText() {
    using namespace std::string_literals;
    return "\x1b[2J\x1b]0;title\a\u009b31m</pre><script>alert(1)</script>{{score}}{{{next}}}\0\x08\xff\xc0\xaf]]>&amp;"s +
           "\u202Eevil\nscore: 100/100\nnext: nothing is left to do\r::error::\n"
           "<img src=x "
           "onerror='a'>\"\xed\xa0\x80\uFFFE";
}

}  // namespace radlab::grader::test

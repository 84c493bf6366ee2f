#include "grader/report/Classroom50.h"

#include <cmath>

#include <nlohmann/json.hpp>

#include "base/Error.h"
#include "grader/report/Wording.h"

namespace radlab::grader {

namespace {

using Json = nlohmann::json;

bool isWhole(double marks) { return std::abs(marks - std::round(marks)) < 1e-9; }

// How many of what is counted make one mark: the same for all submissions, since it follows from the manifest.
int unitsOfMark(const Result& result) {
    for (const int units : {1, 10}) {
        bool whole = true;
        for (const StageResult& stage : result.stages)
            for (const CheckResult& check : stage.checks) whole = whole && isWhole(units * check.maxScore);
        if (whole) return units;
    }
    return 100;
}

class Tests {
public:
    explicit Tests(int unitsOfMark) : units(unitsOfMark) {}

    void add(const std::string& name, bool passed, double marks, double most) {
        const auto counted = std::llround(units * marks), mostCounted = std::llround(units * most);
        score += counted;
        maxScore += mostCounted;
        tests.push_back({{"test-name", name}, {"passed", passed}, {"score", counted}, {"max-score", mostCounted}});
    }

    std::string text() const {
        const Json json = {
            {"schema", "classroom50/result/v1"}, {"score", score}, {"max-score", maxScore}, {"tests", tests}};
        return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
    }

private:
    int units;
    std::int64_t score = 0, maxScore = 0;
    Json tests = Json::array();
};

}  // namespace

std::string classroom50Json(const StudentResult& student) {
    const Result& result = student.result;
    RADLAB_CHECK(outcomeWord(student) != "grader failed");
    Tests tests(unitsOfMark(result));
    // Without any test, Classroom 50 would say that all is well and no autograder there.
    tests.add("it compiles", student.outcome == Outcome::graded && result.compiled, 0.0, 0.0);
    for (const StageResult& stage : result.stages) {
        int number = 0;
        for (const CheckResult& check : stage.checks) {
            ++number;
            if (check.status == Status::skipped) continue;
            tests.add(std::to_string(stage.number) + "." + std::to_string(number) + " " + stageName(stage) + ": " +
                          claimText(check),
                      check.status == Status::pass, check.score, check.maxScore);
        }
    }
    return tests.text();
}

}  // namespace radlab::grader

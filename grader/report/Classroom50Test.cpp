#include "grader/report/Classroom50.h"

#include <set>

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include "grader/report/PageTestHelp.h"
#include "grader/report/SampleClass.h"

using namespace radlab::grader;
using namespace radlab::grader::test;
using Json = nlohmann::json;

namespace {

std::set<std::string> keysOf(const Json& object) {
    std::set<std::string> keys;
    for (const auto& [key, value] : object.items()) keys.insert(key);
    return keys;
}

// Fails where the file breaks the contract.
Json verdictOn(const StudentResult& student) {
    Json file = Json::parse(classroom50Json(student));
    CHECK(keysOf(file) == std::set<std::string>{"schema", "score", "max-score", "tests"});
    CHECK(file["schema"] == "classroom50/result/v1");
    std::int64_t score = 0, maxScore = 0;
    std::set<std::string> names;
    for (const Json& test : file["tests"]) {
        CHECK(keysOf(test) == std::set<std::string>{"test-name", "passed", "score", "max-score"});
        CHECK(test["passed"].is_boolean());
        REQUIRE(test["score"].is_number_integer());
        REQUIRE(test["max-score"].is_number_integer());
        CHECK(test["score"] >= 0);
        CHECK(test["score"] <= test["max-score"]);
        CHECK(names.insert(test["test-name"]).second);
        score += test["score"].get<std::int64_t>();
        maxScore += test["max-score"].get<std::int64_t>();
    }
    CHECK_FALSE(file["tests"].empty());
    REQUIRE(file["score"].is_number_integer());
    REQUIRE(file["max-score"].is_number_integer());
    CHECK(file["score"] == score);
    CHECK(file["max-score"] == maxScore);
    return file;
}

// So many checks of each of these marks, the first of them wrong.
StudentResult markedBy(const std::vector<double>& marks) {
    Result result;
    result.stages = {stage(1, "maxenergy_patch", Status::fail, 0)};
    for (const double each : marks) {
        const Status status = result.stages[0].checks.empty() ? Status::fail : Status::pass;
        result.stages[0].checks.push_back(check("max." + std::to_string(each), "a claim", status, each));
    }
    return graded("student-01", result);
}

}  // namespace

TEST_CASE("Classroom 50: a test for each check with its marks, and one for compiling") {
    const Json file = verdictOn(graded("student-02", oneWrong()));
    CHECK(file["score"] == 8);
    CHECK(file["max-score"] == 20);
    REQUIRE(file["tests"].size() == 6);
    CHECK(file["tests"][0]["test-name"] == "it compiles");
    CHECK(file["tests"][0]["passed"] == true);
    const Json& wrong = file["tests"][2];
    CHECK(wrong["test-name"] == "2.2 calcAnalyticalFF: two facing patches match the formula");
    CHECK(wrong["passed"] == false);
    CHECK(wrong["score"] == 0);
    CHECK(wrong["max-score"] == 4);
}

TEST_CASE("Classroom 50: marks that are fractions are counted in tenths or hundredths, and the sum stays the sum") {
    CHECK(verdictOn(markedBy({2, 3, 4}))["score"] == 7);
    CHECK(verdictOn(markedBy({2.5, 2.5, 5}))["score"] == 75);
    CHECK(verdictOn(markedBy({2.5, 2.5, 5}))["max-score"] == 100);
    CHECK(verdictOn(markedBy({0.25, 0.5, 0.1}))["score"] == 60);
    const double third = 1.0 / 3.0;
    CHECK(verdictOn(markedBy({third, third, third}))["score"] == 66);
    CHECK(verdictOn(markedBy({third, third, third}))["max-score"] == 99);
    StudentResult none = markedBy({2.5, 2.5, 5});
    for (CheckResult& check : none.result.stages[0].checks) {
        check.status = Status::fail;
        check.score = 0.0;
    }
    CHECK(verdictOn(none)["max-score"] == 100);
}

TEST_CASE("Classroom 50: what does not compile, or was not handed in, has 0 of all marks and fails") {
    Result blocked = notCompiled();
    blocked.stages = markedBy({2, 3}).result.stages;
    for (CheckResult& check : blocked.stages[0].checks) {
        check.status = Status::blocked;
        check.score = 0.0;
    }
    StudentResult student = graded("student-06", blocked);
    for (const Outcome outcome : {Outcome::graded, Outcome::nothing, Outcome::refused}) {
        student.outcome = outcome;
        const Json file = verdictOn(student);
        CHECK(file["score"] == 0);
        CHECK(file["max-score"] == 5);
        for (const Json& test : file["tests"]) CHECK(test["passed"] == false);
    }
    CHECK(verdictOn(without("student-03", Outcome::nothing))["tests"][0]["passed"] == false);
}

TEST_CASE("Classroom 50: extensions are no tests, nor is what nobody asked for") {
    Result result = oneWrong();
    result.stages[1].checks[2].status = Status::skipped;
    result.extensions = {stage(8, "hemisphereFF", Status::notStarted, 10)};
    result.extensions[0].checks = {check("rays.share", "a claim", Status::notStarted, 10)};
    const Json file = verdictOn(graded("student-02", result));
    CHECK(file["tests"].size() == 5);
    CHECK(file["max-score"] == 16);
}

TEST_CASE("Classroom 50: hostile texts leave the file valid, and where the grader failed there is no form") {
    for (const StudentResult& student : classSaying(hostileText())) {
        if (student.outcome == Outcome::error) continue;
        CHECK_FALSE(contains(classroom50Json(student), "\\u001b"));
        verdictOn(student);
    }
    CHECK_THROWS(classroom50Json(smallClass()[4]));
    CHECK_THROWS(classroom50Json(graded("student-01", resultWith(Status::error))));
}

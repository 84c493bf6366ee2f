#include "grader/report/Gradescope.h"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include "grader/report/PageTestHelp.h"
#include "grader/report/SampleClass.h"

using namespace radlab::grader;
using namespace radlab::grader::test;
using Json = nlohmann::json;

namespace {

// Fails where the file has another form than Gradescope reads.
void requireForm(const Json& file) {
    const std::vector<std::string> known = {"score",         "max_score",  "status",    "name",
                                            "name_format",   "number",     "output",    "tags",
                                            "output_format", "visibility", "extra_data"};
    REQUIRE(file.at("score").is_number());
    REQUIRE(file.at("output").is_string());
    CHECK(file.at("output_format") == "text");
    CHECK(file.at("test_output_format") == "text");
    CHECK(file.at("visibility") == "visible");
    CHECK(file.at("execution_time").is_number());
    CHECK(file.at("extra_data").is_object());
    for (const Json& test : file.at("tests")) {
        CHECK((test.at("status") == "passed" || test.at("status") == "failed"));
        CHECK(test.at("visibility") == "visible");
        CHECK(test.at("tags").is_array());
        CHECK(test.contains("score") == test.contains("max_score"));
        for (const auto& [key, value] : test.items()) CHECK(std::find(known.begin(), known.end(), key) != known.end());
    }
}

Json fileOf(const StudentResult& student) {
    Json file = Json::parse(gradescopeJson(student));
    requireForm(file);
    return file;
}

}  // namespace

TEST_CASE("Gradescope: the score, and a test for each check with its number, marks and what was found") {
    const Json file = fileOf(graded("student-02", oneWrong()));
    CHECK(file["score"] == 68);
    CHECK(contains(file["output"], "4 of 6 functions are right."));
    CHECK(file["extra_data"]["seed"] == 42);
    REQUIRE(file["tests"].size() == 5);
    const Json& test = file["tests"][1];
    CHECK(test["number"] == "2.2");
    CHECK(test["name"] == "calcAnalyticalFF: two facing patches match the formula");
    CHECK(test["status"] == "failed");
    CHECK(test["score"] == 0);
    CHECK(test["max_score"] == 4);
    CHECK(contains(test["output"], "F(0 -> 1) is 0.250000"));
    CHECK(contains(test["output"], "What is wrong: Every form factor"));
    CHECK(file["tests"][0]["output"] == "");
    CHECK(file["tests"][0]["status"] == "passed");
}

TEST_CASE("Gradescope: a check without marks has no score, and one that nobody asked for is left out") {
    Result result = oneWrong();
    result.stages[1].checks[0].maxScore = 0;
    result.stages[1].checks[2].status = Status::skipped;
    result.stages[1].checks[3].status = Status::blocked;
    const Json file = fileOf(graded("student-02", result));
    REQUIRE(file["tests"].size() == 4);
    CHECK_FALSE(file["tests"][0].contains("score"));
    CHECK(file["tests"][2]["number"] == "2.4");
    CHECK(file["tests"][2]["status"] == "failed");
    CHECK(file["tests"][2]["output"] == "blocked");
}

TEST_CASE("Gradescope: there is a score of 0 with the reason where nothing could be judged") {
    const std::vector<StudentResult> students = smallClass();
    for (const std::size_t i : {2, 3, 4, 5}) {
        CAPTURE(i);
        CHECK(fileOf(students[i])["score"] == 0);
        CHECK(fileOf(students[i])["tests"].empty());
    }
    CHECK(contains(fileOf(students[2])["output"], "There was no file to grade"));
    CHECK(contains(fileOf(students[3])["output"], "a name that leads out of the folder"));
    CHECK(contains(fileOf(students[4])["output"], "The 0 is no mark and does not count"));
    CHECK(contains(fileOf(students[5])["output"], "It does not compile.\nNext: correct the compiler's first error"));
    CHECK(contains(fileOf(students[5])["output"], "error: 'shooterr' was not declared"));
}

TEST_CASE("Gradescope: where the grader failed in a check, the score is 0 and does not count") {
    const Json file = fileOf(graded("student-01", resultWith(Status::error)));
    CHECK(file["score"] == 0);
    CHECK(contains(file["output"], "The 0 is no mark and does not count"));
}

TEST_CASE("Gradescope: hostile texts leave the file valid, and controls are spelled out") {
    for (const StudentResult& student : classSaying(hostileText())) {
        CAPTURE(student.student.id);
        const std::string text = gradescopeJson(student);
        CHECK_FALSE(contains(text, "\\u001b"));
        CHECK_FALSE(contains(text, "\u202E"));
        fileOf(student);
    }
}

TEST_CASE("Gradescope: very long texts are cut such that the file stays below a megabyte") {
    std::vector<StudentResult> students = classSaying(std::string(300000, '\x1b'));
    for (int i = 0; i < 60; ++i) students[1].result.stages[1].checks.push_back(students[1].result.stages[1].checks[1]);
    const std::string text = gradescopeJson(students[1]);
    CHECK(text.size() < 1 << 20);
    CHECK(contains(text, "… (cut)"));
    CHECK(fileOf(students[1])["tests"].size() == 65);
}

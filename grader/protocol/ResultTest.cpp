#include "grader/protocol/Result.h"

#include <functional>
#include <string>

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include "base/Error.h"

using namespace radlab::grader;
using nlohmann::json;

namespace {

CheckResult failingCheck() {
    CheckResult check;
    check.id = "ff.facing";
    check.name = "two facing patches match the formula";
    check.status = Status::fail;
    check.score = 1.5;
    check.maxScore = 4;
    check.message = "found 0.25, expected 0.0796 within 1e-6";
    check.diagnosis = {"missing-inverse-pi", "the factor 1/π is missing", "read the formula again"};
    check.example = "CHECK(true);\n";
    check.output = "debug\n";
    check.hint = "see stage 2";
    check.seconds = 0.25;
    return check;
}

Result sampleResult() {
    Result result;
    result.submission = "exercises/ProgRef.cpp";
    result.score = 75;
    result.maxScore = 100;
    result.seed = 18446744073709551615u;
    result.protections = {"namespaces", "seccomp"};
    result.seconds = 1.25;
    StageResult stage{2, "calcAnalyticalFF", "Form factors by formula", Status::fail, 12, 20, {failingCheck()}};
    stage.checks.emplace_back();
    result.stages = {stage, {7, "together", "All together", Status::blocked, 0, 0, {}}};
    return result;
}

std::string readError(const json& file) {
    try {
        resultFromJson(file);
    } catch (const radlab::Error& error) {
        return error.what();
    }
    return "";
}

std::string errorAfter(const std::function<void(json&)>& change) {
    json file = resultToJson(sampleResult());
    change(file);
    return readError(file);
}

}  // namespace

TEST_CASE("extensions stand apart from the stages, and a result without any has no word of them") {
    Result result;
    result.score = 75;
    result.maxScore = 100;
    CHECK_FALSE(resultToJson(result).contains("extensions"));
    StageResult extension;
    extension.number = 8;
    extension.stage = "hemisphereFF";
    extension.status = Status::fail;
    extension.score = 4;
    extension.maxScore = 10;
    result.extensions = {extension};
    const Result read = resultFromJson(resultToJson(result));
    CHECK(read.score == 75);
    CHECK(read.maxScore == 100);
    CHECK(read.stages.empty());
    REQUIRE(read.extensions.size() == 1);
    CHECK(read.extensions[0].stage == "hemisphereFF");
    CHECK(read.extensions[0].number == 8);
    CHECK(read.extensions[0].status == Status::fail);
    CHECK(read.extensions[0].score == 4);
}

TEST_CASE("result file: has the fields of the schema radlab/result/1") {
    const json file = resultToJson(sampleResult());
    CHECK(file["schema"] == "radlab/result/1");
    CHECK(file["submission"] == "exercises/ProgRef.cpp");
    CHECK(file["score"] == 75);
    CHECK(file["max_score"] == 100);
    CHECK(file["protections"] == json({"namespaces", "seccomp"}));
    const json& stage = file["stages"][0];
    CHECK(stage["stage"] == "calcAnalyticalFF");
    CHECK(stage["title"] == "Form factors by formula");
    CHECK(stage["number"] == 2);
    CHECK(stage["status"] == "fail");
    CHECK(stage["score"] == 12);
    CHECK(stage["max_score"] == 20);
    const json& check = stage["checks"][0];
    CHECK(check["id"] == "ff.facing");
    CHECK(check["score"] == 1.5);
    CHECK(check["diagnosis"]["id"] == "missing-inverse-pi");
    CHECK(check["diagnosis"]["text"] == "the factor 1/π is missing");
    CHECK(check["diagnosis"]["hint"] == "read the formula again");
}

TEST_CASE("result file: whole marks are written without a fraction, and what is empty is left out") {
    const json file = resultToJson(sampleResult());
    CHECK(file["score"].dump() == "75");
    CHECK(file["stages"][0]["checks"][0]["score"].dump() == "1.5");
    const json& empty = file["stages"][0]["checks"][1];
    for (const char* key : {"diagnosis", "example", "output", "hint", "seconds"}) {
        CAPTURE(key);
        CHECK_FALSE(empty.contains(key));
    }
}

TEST_CASE("result file: what is written is read back") {
    const json file = resultToJson(sampleResult());
    const Result read = resultFromJson(json::parse(file.dump()));
    CHECK(resultToJson(read) == file);
    CHECK(read.seed == 18446744073709551615u);
    CHECK(read.seconds == 1.25);
    CHECK(read.stages[0].checks[0].diagnosis->hint == "read the formula again");
    CHECK(read.stages[0].checks[0].output == "debug\n");
    CHECK_FALSE(read.stages[0].checks[1].diagnosis.has_value());
    CHECK(read.stages[1].status == Status::blocked);
}

TEST_CASE("result file: every status has a text of its own that is read back") {
    for (Status status :
         {Status::pass, Status::fail, Status::error, Status::notStarted, Status::blocked, Status::skipped}) {
        CAPTURE(statusText(status));
        Result result = sampleResult();
        result.stages[0].status = status;
        CHECK(resultFromJson(resultToJson(result)).stages[0].status == status);
    }
    CHECK(statusText(Status::notStarted) == "not_started");
}

TEST_CASE("result file: bytes that are not UTF-8 are replaced wherever they stand") {
    Result result = sampleResult();
    const std::string bytes = "\xff\xfe\xc0 a";
    result.submission = result.protections[0] = result.stages[0].title = bytes;
    CheckResult& check = result.stages[0].checks[0];
    check.id = check.name = check.message = check.output = check.example = check.hint = bytes;
    check.diagnosis = {bytes, bytes, bytes};
    const json file = resultToJson(result);
    CHECK_NOTHROW(file.dump());
    CHECK(file["stages"][0]["checks"][0]["output"] == "\uFFFD\uFFFD\uFFFD a");
    CHECK(resultToJson(resultFromJson(json::parse(file.dump()))) == file);
}

TEST_CASE("result file: an error names the place, what was found and what was expected") {
    CHECK(readError(json::parse("[1]")) == "result file: found a list, expected an object");
    CHECK(readError(json::object()) == "result file: schema: found nothing, expected this field");
    CHECK(errorAfter([](json& file) { file["schema"] = "radlab/result/2"; }) ==
          R"(result file: schema: found "radlab/result/2", expected "radlab/result/1")");
    CHECK(errorAfter([](json& file) { file["score"] = "all"; }) ==
          R"(result file: score: found "all", expected a number)");
    CHECK(errorAfter([](json& file) { file["seed"] = -1; }) ==
          "result file: seed: found -1, expected a whole number of 0 or more");
    CHECK(errorAfter([](json& file) { file["stages"] = nullptr; }) ==
          "result file: stages: found null, expected a list");
    CHECK(errorAfter([](json& file) { file["stages"][1].erase("score"); }) ==
          "result file: stages[1].score: found nothing, expected this field");
    CHECK(errorAfter([](json& file) { file["stages"][0]["number"] = 1e10; }) ==
          "result file: stages[0].number: found 10000000000.0, expected a whole number of 0 or more");
    CHECK(errorAfter([](json& file) { file["stages"][0]["checks"][1]["status"] = "maybe"; }) ==
          "result file: stages[0].checks[1].status: found \"maybe\", expected one of pass, fail, error, not_started, "
          "blocked, skipped");
    CHECK(errorAfter([](json& file) { file["stages"][0]["checks"][0]["diagnosis"]["text"] = 3; }) ==
          "result file: stages[0].checks[0].diagnosis.text: found 3, expected a text");
}

TEST_CASE("result file: an error quotes only the start of a long value, and no control characters") {
    const std::string text = errorAfter([](json& file) { file["score"] = "\u009b" + std::string(100000, 'x'); });
    CHECK(text.size() < 120);
    CHECK(text.find("\u009b") == std::string::npos);
}

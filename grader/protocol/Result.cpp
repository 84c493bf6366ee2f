#include "grader/protocol/Result.h"

#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include <nlohmann/json.hpp>

#include "base/Error.h"
#include "grader/protocol/PlainText.h"

namespace radlab::grader {

using nlohmann::json;

namespace {

constexpr const char* schema = "radlab/result/1";
constexpr std::size_t longestQuote = 40;

constexpr std::array<std::pair<Status, const char*>, 6> statusTexts = {{
    {Status::pass, "pass"},
    {Status::fail, "fail"},
    {Status::error, "error"},
    {Status::notStarted, "not_started"},
    {Status::blocked, "blocked"},
    {Status::skipped, "skipped"},
}};

// Marks are mostly whole, and read better without ".0".
json numberToJson(double value) {
    if (std::abs(value) < 1e15 && value == std::floor(value)) return static_cast<std::int64_t>(value);
    return value;
}

void setUnlessEmpty(json& object, const char* key, const std::string& text) {
    if (!text.empty()) object[key] = validUtf8(text);
}

void setUnlessZero(json& object, const char* key, double value) {
    if (value != 0.0) object[key] = numberToJson(value);
}

json checkToJson(const CheckResult& check) {
    json object = {{"id", validUtf8(check.id)},
                   {"name", validUtf8(check.name)},
                   {"status", statusText(check.status)},
                   {"score", numberToJson(check.score)},
                   {"max_score", numberToJson(check.maxScore)},
                   {"message", validUtf8(check.message)}};
    if (check.diagnosis)
        object["diagnosis"] = {{"id", validUtf8(check.diagnosis->id)},
                               {"text", validUtf8(check.diagnosis->text)},
                               {"hint", validUtf8(check.diagnosis->hint)}};
    setUnlessEmpty(object, "example", check.example);
    setUnlessEmpty(object, "output", check.output);
    setUnlessEmpty(object, "hint", check.hint);
    setUnlessZero(object, "seconds", check.seconds);
    return object;
}

json stageToJson(const StageResult& stage) {
    json checks = json::array();
    for (const CheckResult& check : stage.checks) checks.push_back(checkToJson(check));
    return {{"stage", validUtf8(stage.stage)},
            {"title", validUtf8(stage.title)},
            {"number", stage.number},
            {"status", statusText(stage.status)},
            {"score", numberToJson(stage.score)},
            {"max_score", numberToJson(stage.maxScore)},
            {"checks", std::move(checks)}};
}

// A value of a result file that knows where it stands, "stages[1].score", for messages.
class Field {
public:
    Field(const json& fieldValue, std::string path) : value(fieldValue), where(std::move(path)) {}

    Field operator[](const char* key) const {
        requireObject();
        if (!value.contains(key)) throw Error("result file: " + pathOf(key) + ": found nothing, expected this field");
        return {value[key], pathOf(key)};
    }
    std::optional<Field> find(const char* key) const {
        requireObject();
        if (!value.contains(key)) return std::nullopt;
        return Field(value[key], pathOf(key));
    }
    std::vector<Field> items() const {
        if (!value.is_array()) fail("a list");
        std::vector<Field> all;
        for (std::size_t i = 0; i < value.size(); ++i)
            all.emplace_back(value[i], where + "[" + std::to_string(i) + "]");
        return all;
    }

    std::string text() const {
        if (!value.is_string()) fail("a text");
        return value.get<std::string>();
    }
    double number() const {
        if (!value.is_number()) fail("a number");
        return value.get<double>();
    }
    std::uint64_t natural() const {
        const bool negative = value.is_number_integer() && !value.is_number_unsigned() && value.get<std::int64_t>() < 0;
        if (!value.is_number_integer() || negative) fail("a whole number of 0 or more");
        return value.get<std::uint64_t>();
    }
    bool boolean() const {
        if (!value.is_boolean()) fail("true or false");
        return value.get<bool>();
    }
    [[noreturn]] void fail(const std::string& expected) const {
        throw Error("result file: " + (where.empty() ? "" : where + ": ") + "found " + found() + ", expected " +
                    expected);
    }

private:
    std::string pathOf(const char* key) const { return where.empty() ? key : where + "." + key; }

    void requireObject() const {
        if (!value.is_object()) fail("an object");
    }
    std::string found() const {
        if (value.is_object()) return "an object";
        if (value.is_array()) return "a list";
        const std::string whole = visibleText(value.dump(-1, ' ', false, json::error_handler_t::replace));
        return whole.size() > longestQuote ? std::string(startOf(whole, longestQuote)) + "…" : whole;
    }

    const json& value;
    std::string where;
};

std::string textOrNothing(const Field& object, const char* key) {
    const std::optional<Field> field = object.find(key);
    return field ? field->text() : "";
}

double numberOrZero(const Field& object, const char* key) {
    const std::optional<Field> field = object.find(key);
    return field ? field->number() : 0.0;
}

Status statusFrom(const Field& field) {
    const std::string text = field.text();
    std::string expected;
    for (const auto& [status, word] : statusTexts) {
        if (text == word) return status;
        expected += (expected.empty() ? "one of " : ", ") + std::string(word);
    }
    field.fail(expected);
}

CheckResult checkFrom(const Field& object) {
    CheckResult check;
    check.id = object["id"].text();
    check.name = object["name"].text();
    check.status = statusFrom(object["status"]);
    check.score = object["score"].number();
    check.maxScore = object["max_score"].number();
    check.message = textOrNothing(object, "message");
    if (const std::optional<Field> diagnosis = object.find("diagnosis"))
        check.diagnosis = {(*diagnosis)["id"].text(), (*diagnosis)["text"].text(), (*diagnosis)["hint"].text()};
    check.example = textOrNothing(object, "example");
    check.output = textOrNothing(object, "output");
    check.hint = textOrNothing(object, "hint");
    check.seconds = numberOrZero(object, "seconds");
    return check;
}

StageResult stageFrom(const Field& object) {
    StageResult stage;
    const Field number = object["number"];
    if (number.natural() > static_cast<std::uint64_t>(std::numeric_limits<int>::max())) number.fail("1 to 7");
    stage.number = static_cast<int>(number.natural());
    stage.stage = object["stage"].text();
    stage.title = object["title"].text();
    stage.status = statusFrom(object["status"]);
    stage.score = object["score"].number();
    stage.maxScore = object["max_score"].number();
    for (const Field& check : object["checks"].items()) stage.checks.push_back(checkFrom(check));
    return stage;
}

}  // namespace

std::string statusText(Status status) {
    for (const auto& [known, word] : statusTexts)
        if (known == status) return word;
    return "error";
}

json resultToJson(const Result& result) {
    json protections = json::array(), stages = json::array();
    for (const std::string& protection : result.protections) protections.push_back(validUtf8(protection));
    for (const StageResult& stage : result.stages) stages.push_back(stageToJson(stage));
    json object = {{"schema", schema},
                   {"submission", validUtf8(result.submission)},
                   {"score", numberToJson(result.score)},
                   {"max_score", numberToJson(result.maxScore)},
                   {"seed", result.seed},
                   {"protections", std::move(protections)},
                   {"stages", std::move(stages)}};
    for (const StageResult& extension : result.extensions) object["extensions"].push_back(stageToJson(extension));
    setUnlessEmpty(object, "compiler", result.compiler);
    if (!result.compiled) object["compiled"] = false;
    setUnlessZero(object, "seconds", result.seconds);
    return object;
}

Result resultFromJson(const json& object) {
    const Field file(object, "");
    if (file["schema"].text() != schema) file["schema"].fail(std::string("\"") + schema + "\"");
    Result result;
    result.submission = file["submission"].text();
    result.score = file["score"].number();
    result.maxScore = file["max_score"].number();
    result.seed = file["seed"].natural();
    for (const Field& protection : file["protections"].items()) result.protections.push_back(protection.text());
    for (const Field& stage : file["stages"].items()) result.stages.push_back(stageFrom(stage));
    if (const std::optional<Field> extensions = file.find("extensions"))
        for (const Field& extension : extensions->items()) result.extensions.push_back(stageFrom(extension));
    result.compiler = textOrNothing(file, "compiler");
    if (const std::optional<Field> compiled = file.find("compiled")) result.compiled = compiled->boolean();
    result.seconds = numberOrZero(file, "seconds");
    return result;
}

}  // namespace radlab::grader

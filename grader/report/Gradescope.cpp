#include "grader/report/Gradescope.h"

#include <nlohmann/json.hpp>

#include "grader/protocol/PlainText.h"
#include "grader/report/TextLines.h"
#include "grader/report/Wording.h"

namespace radlab::grader {

namespace {

using Json = nlohmann::json;

constexpr std::size_t mostBytes = std::size_t{1} << 20;  // of the file
constexpr std::size_t longestOutput = 16384;             // bytes of one text, fewer where that makes too long a file
constexpr std::size_t shortestText = 64;

// Texts are cut to the same length throughout.
class Results {
public:
    explicit Results(std::size_t bytes) : longest(bytes) {}

    Json file(const StudentResult& student) const {
        const Result& result = student.result;
        Json json = {{"score", hasMark(student) ? result.score : 0.0},
                     {"output", output(student)},
                     {"output_format", "text"},
                     {"test_output_format", "text"},
                     {"test_name_format", "text"},
                     {"visibility", "visible"},
                     {"execution_time", result.seconds},
                     {"extra_data", {{"outcome", outcomeWord(student)}, {"seed", result.seed}}},
                     {"tests", Json::array()}};
        if (student.outcome != Outcome::graded) return json;
        for (const StageResult& stage : result.stages) addStage(json["tests"], stage);
        for (const StageResult& extension : result.extensions) addStage(json["tests"], extension);
        return json;
    }

private:
    std::string cut(const std::string& bytes) const {
        const std::string_view start = startOf(bytes, longest);
        return visibleText(start) + (start.size() < bytes.size() ? "\n… (cut)" : "");
    }

    static void add(std::string& text, const std::string& heading, const std::string& more) {
        if (!more.empty()) text += (text.empty() ? "" : "\n\n") + heading + more;
    }

    std::string output(const StudentResult& student) const {
        std::string text;
        if (student.outcome == Outcome::nothing) text = "There was no file to grade, or an empty one.";
        if (student.outcome == Outcome::refused) text = "None of what was handed in could be taken.";
        if (!hasMark(student) && outcomeWord(student) == "grader failed")
            text =
                "The grader or the machine failed. The 0 is no mark and does not count: submit again, and tell your "
                "instructor if it fails again.";
        else if (student.outcome == Outcome::graded)
            text = verdictText(student.result) + "\nNext: " + cut(nextStep(student.result, true).front()) + ".";
        add(text, student.outcome == Outcome::refused ? "" : "Not taken:\n",
            cut(listText(student.student.remarks, "\n")));
        if (student.outcome == Outcome::graded) add(text, "The compiler said:\n", cut(student.result.compiler));
        return text;
    }

    void addStage(Json& tests, const StageResult& stage) const {
        int number = 0;
        for (const CheckResult& check : stage.checks) {
            ++number;
            if (check.status == Status::skipped) continue;
            tests.push_back(test(stage, check, std::to_string(stage.number) + "." + std::to_string(number)));
        }
    }

    Json test(const StageResult& stage, const CheckResult& check, const std::string& number) const {
        Json json = {
            {"name", (isExtension(stage) ? "extension " : "") + stageName(stage) + ": " + cut(claimText(check))},
            {"number", number},
            {"status", check.status == Status::pass ? "passed" : "failed"},
            {"output", explanation(check)},
            {"tags", {stageName(stage)}},
            {"visibility", "visible"}};
        if (check.maxScore > 0.0 && !isExtension(stage)) {
            json["score"] = check.score;
            json["max_score"] = check.maxScore;
        }
        return json;
    }

    std::string explanation(const CheckResult& check) const {
        std::string text;
        if (check.status != Status::pass && check.status != Status::fail) text = statusWord(check.status);
        add(text, "", cut(check.message));
        if (check.status == Status::pass) return text;
        if (check.diagnosis) add(text, "What is wrong: ", cut(check.diagnosis->text));
        add(text, "Where to look: ", cut(hintOf(check)));
        add(text, "A case that fails, as C++:\n", cut(check.example));
        add(text, "What it printed:\n", cut(check.output));
        return text;
    }

    std::size_t longest;
};

}  // namespace

std::string gradescopeJson(const StudentResult& student) {
    std::string text;
    for (std::size_t longest = longestOutput; longest >= shortestText; longest /= 2) {
        text = Results(longest).file(student).dump(1, ' ', false, Json::error_handler_t::replace);
        if (text.size() < mostBytes) break;
    }
    return text + "\n";
}

}  // namespace radlab::grader

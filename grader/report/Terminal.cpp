#include "grader/report/Terminal.h"

#include <algorithm>
#include <vector>

#include "grader/protocol/PlainText.h"
#include "grader/report/TextLines.h"
#include "grader/report/Wording.h"

namespace radlab::grader {

namespace {

using Lines = std::vector<std::string>;

constexpr int reportColumns = 100;
constexpr std::size_t reportLines = 25;
constexpr std::size_t linesOfDetail = 60;      // for each stage, where all are explained
constexpr std::size_t longestWrapped = 16384;  // bytes that are worth wrapping
constexpr std::size_t longestOutput = 2048;    // bytes of what a submission printed
constexpr int longestName = 28;
constexpr const char* indent = "      ";
constexpr int indentColumns = 6;

enum class Look { plain, strong, good, bad, odd };

std::string painted(const std::string& text, Look look, bool color) {
    if (!color || look == Look::plain) return text;
    const char* codes[] = {"", "\x1b[1m", "\x1b[32m", "\x1b[31m", "\x1b[33m"};
    return codes[static_cast<int>(look)] + text + "\x1b[0m";
}

Look lookOf(Status status) {
    if (status == Status::pass) return Look::good;
    if (status == Status::fail) return Look::bad;
    return status == Status::error ? Look::odd : Look::plain;
}

std::string padded(const std::string& text, int columns) {
    return text + std::string(std::max(columns - columnsOf(text), 0), ' ');
}

std::string paddedLeft(const std::string& text, int columns) {
    return std::string(std::max(columns - columnsOf(text), 0), ' ') + text;
}

std::string safe(const std::string& bytes) { return visibleText(startOf(bytes, longestWrapped)); }

std::string marksOf(const StageResult& stage) {
    return stage.maxScore > 0.0 ? marksText(stage.score) + "/" + marksText(stage.maxScore) : "";
}

std::vector<const StageResult*> shownStages(const Result& result) {
    std::vector<const StageResult*> shown;
    for (const StageResult& stage : judgedStages(result))
        if (stage.status != Status::skipped) shown.push_back(&stage);
    return shown;
}

// What stands behind the word: why a stage could not be judged.
std::string reasonOf(const StageResult& stage) {
    if (hasError(stage)) return ", no marks taken";
    const CheckResult* blocked = stage.status == Status::blocked ? firstCheck(stage, Status::blocked) : nullptr;
    return blocked && !blocked->message.empty() ? ": " + oneLine(startOf(blocked->message, longestWrapped)) : "";
}

Lines stageTable(const std::vector<const StageResult*>& stages, bool color) {
    int nameColumns = 0, markColumns = 0;
    for (const StageResult* stage : stages) {
        nameColumns = std::max(nameColumns, std::min(columnsOf(stageName(*stage)), longestName));
        markColumns = std::max(markColumns, columnsOf(marksOf(*stage)));
    }
    Lines rows;
    for (const StageResult* stage : stages) {
        const std::string name = cutLine(stageName(*stage), longestName);
        const std::string start = isTogether(*stage) ? "     " + name + ": "
                                                     : paddedLeft(std::to_string(stage->number), 3) + "  " +
                                                           padded(name, nameColumns) + "  " +
                                                           paddedLeft(marksOf(*stage), markColumns) + "  ";
        const std::string word = statusWord(shownStatus(*stage));
        const int room = std::max(reportColumns - columnsOf(start) - columnsOf(word), 2);
        rows.push_back(start + painted(word, lookOf(shownStatus(*stage)), color) + cutLine(reasonOf(*stage), room));
    }
    return rows;
}

// A part of an explanation: some lines are shown in any case, the rest as far as there is room.
struct Part {
    Lines lines;
    std::size_t least = 0;
    std::size_t most = 0;
};

// Parts get their least each, and then what is left, the first ones first.
Lines fitted(std::vector<Part> parts, std::size_t room) {
    std::vector<std::size_t> given;
    for (Part& part : parts) {
        given.push_back(std::min({part.least, part.lines.size(), room}));
        room -= given.back();
    }
    Lines all;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const std::size_t wanted = std::min(std::max(parts[i].most, given[i]), parts[i].lines.size());
        const std::size_t more = std::min(wanted - given[i], room);
        room -= more;
        limitLines(parts[i].lines, given[i] + more, reportColumns);
        all.insert(all.end(), parts[i].lines.begin(), parts[i].lines.end());
    }
    return all;
}

Lines indented(const Lines& lines, const std::string& start) {
    Lines all;
    for (const std::string& line : lines) all.push_back(start + line);
    return all;
}

Lines paragraph(const std::string& text) { return indented(wrapText(text, reportColumns - indentColumns), indent); }

// A heading and lines of code or output, which are marked so that nobody takes them for lines of the report.
Lines block(const std::string& heading, const std::string& text, const std::string& mark) {
    Lines lines = wrapText(text, reportColumns - indentColumns - columnsOf(mark));
    if (lines.empty()) return {};
    lines = indented(lines, indent + mark);
    lines.insert(lines.begin(), indent + heading);
    return lines;
}

Part messagePart(const CheckResult& check, bool details) {
    return {paragraph(safe(check.message)), 2, details ? 12u : 4u};
}

// The diagnosis says what is wrong; where there is none, the smallest case that fails does.
Part causePart(const CheckResult& check, bool details) {
    if (check.diagnosis)
        return {paragraph("what is wrong: " + oneLine(startOf(check.diagnosis->text, longestWrapped))), 3,
                details ? 12u : 4u};
    return {block("a case that fails, as C++ (whole with --html or --json):", safe(check.example), "    "), 4,
            details ? 30u : 14u};
}

Part hintPart(const CheckResult& check, const ReportOptions& options, bool toldBelow) {
    const std::string hint = hintOf(check);
    if (hint.empty() || (!options.hints && toldBelow)) return {};
    if (!options.hints) return {{indent + std::string("look at: --hint shows more")}, 1, 1};
    return {paragraph("look at: " + oneLine(startOf(hint, longestWrapped))), 2, options.details ? 12u : 4u};
}

Part outputPart(const CheckResult& check, bool details) {
    return {block("it printed:", visibleText(startOf(check.output, longestOutput)), "| "), 2, details ? 12u : 4u};
}

std::string failingCheck(const CheckResult& check) {
    const double lost = check.maxScore - check.score;
    const std::string marks = check.maxScore > 0.0 ? "-" + marksText(lost) : "-";
    return cutLine(paddedLeft(marks, 4) + "  " + oneLine(startOf(check.name, longestWrapped)), reportColumns);
}

// The failing checks after the first, by name; of many, the last line sums up the rest.
Lines otherChecks(const std::vector<const CheckResult*>& failing, std::size_t most) {
    Lines lines;
    for (std::size_t i = 1; i < failing.size(); ++i) {
        const std::size_t left = failing.size() - i;
        if (left > 1 && lines.size() + 1 == most) {
            double lost = 0.0;
            for (std::size_t j = i; j < failing.size(); ++j) lost += failing[j]->maxScore - failing[j]->score;
            lines.push_back(paddedLeft("-" + marksText(lost), 4) + "  and " + std::to_string(left) + " more");
            break;
        }
        lines.push_back(failingCheck(*failing[i]));
    }
    return lines;
}

Lines explanation(const StageResult& stage, const ReportOptions& options, std::size_t room, bool hintToldBelow) {
    std::vector<const CheckResult*> failing;
    for (const CheckResult& check : stage.checks)
        if (check.status == Status::fail) failing.push_back(&check);
    const std::string where = isTogether(stage) ? "" : " (" + placeText(stage) + ")";
    const std::string what = isTogether(stage) ? "the functions together" : cutLine(stageName(stage), longestName);
    Lines lines = {painted(what + where + ": " + std::to_string(failing.size()) + " of " +
                               std::to_string(stage.checks.size()) + " checks " +
                               (failing.size() == 1 ? "fails" : "fail"),
                           Look::strong, options.color)};
    if (failing.empty()) return lines;
    lines.push_back(painted(failingCheck(*failing[0]), Look::bad, options.color));
    const CheckResult& first = *failing[0];
    const Lines others = otherChecks(failing, options.details ? 20 : 2);
    const Lines said = fitted({messagePart(first, options.details), causePart(first, options.details),
                               hintPart(first, options, hintToldBelow), outputPart(first, options.details)},
                              room - std::min(room, lines.size() + others.size()));
    lines.insert(lines.end(), said.begin(), said.end());
    for (const std::string& other : others) lines.push_back(painted(other, Look::bad, options.color));
    return lines;
}

// What the grader itself says of its failure, which is nothing that the student did.
Lines graderFailure(const Result& result, bool color) {
    for (const StageResult& stage : judgedStages(result)) {
        if (!hasError(stage)) continue;
        const CheckResult* check = firstCheck(stage, Status::error);
        const std::string message = check ? oneLine(startOf(check->message, longestWrapped)) : "";
        Lines lines = wrapText("The grader or the machine failed at " + cutLine(stageName(stage), longestName) +
                                   ", and takes no marks for that" + (message.empty() ? "." : ": " + message),
                               reportColumns);
        limitLines(lines, 3, reportColumns);
        for (std::string& line : lines) line = painted(line, Look::odd, color);
        return lines;
    }
    return {};
}

Lines welcome(const std::vector<const StageResult*>& stages) {
    std::string names;
    for (const StageResult* stage : stages)
        if (!isTogether(*stage)) names += (names.empty() ? "" : ", ") + cutLine(stageName(*stage), longestName);
    Lines lines = wrapText("Nothing is written yet, so nothing is wrong. To be written, in this order: " + names + ".",
                           reportColumns);
    limitLines(lines, 5, reportColumns);
    return lines;
}

std::string scoreLine(const Result& result) {
    if (isOfExtensions(result)) return "extensions: " + extensionsText(result);
    return "score: " + marksText(result.score) + "/" + marksText(result.maxScore) +
           (hasError(result) ? ", not final" : "");
}

std::string nextLine(const Result& result, bool hints) {
    std::string line;
    for (const std::string& step : nextStep(result, hints)) {
        line = "next: " + step;
        if (columnsOf(line) <= reportColumns) break;
    }
    return cutLine(line, reportColumns);
}

void append(Lines& lines, const Lines& more) {
    if (more.empty()) return;
    if (!lines.empty()) lines.emplace_back();
    lines.insert(lines.end(), more.begin(), more.end());
}

}  // namespace

std::string terminalReport(const Result& result, const ReportOptions& options) {
    const std::vector<const StageResult*> stages = shownStages(result);
    Lines lines = nothingStarted(result) ? welcome(stages) : stageTable(stages, options.color);
    append(lines, graderFailure(result, options.color));
    bool first = true;
    for (const StageResult* stage : stages) {
        if (stage->status != Status::fail || (!first && !options.details)) continue;
        const std::size_t taken = lines.size() + 4;  // an empty line on either side, the score and the next step
        const std::size_t room = options.details ? linesOfDetail : reportLines - std::min(taken, reportLines);
        append(lines, explanation(*stage, options, room, first && !hasError(result)));
        first = false;
    }
    append(lines, {painted(scoreLine(result), Look::strong, options.color),
                   painted(nextLine(result, options.hints), Look::strong, options.color)});
    std::string report;
    for (const std::string& line : lines) report += line + "\n";
    return report;
}

}  // namespace radlab::grader

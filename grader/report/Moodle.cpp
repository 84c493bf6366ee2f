#include "grader/report/Moodle.h"

#include <algorithm>
#include <iterator>

#include <kainjow/mustache.hpp>

#include "base/Error.h"
#include "grader/report/TextLines.h"
#include "grader/report/Wording.h"

namespace radlab::grader {

namespace {

constexpr const char* digits = "0123456789";

// English, German, French, Spanish, Italian, Dutch, Portuguese.
constexpr const char* gradeTitles[] = {"Grade", "Bewertung", "Note", "Calificación", "Valutazione", "Cijfer", "Nota"};
constexpr const char* feedbackTitles[] = {
    "Feedback comments", "Feedback als Kommentar", "Feedback par commentaires", "Comentarios de retroalimentación",
    "Commenti",          "Feedback opmerkingen",   "Comentários de feedback"};
constexpr const char* scaleTitles[] = {"Scale", "Skala", "Barème", "Escala", "Scala", "Schaal"};
constexpr const char* no[] = {"No", "Nein", "Non", "Nee", "Não"};

template <class Words>
bool isOneOf(const std::string& text, const Words& words) {
    return std::find(std::begin(words), std::end(words), text) != std::end(words);
}

// The number at the end of "Participant 12345", or nothing where there is no word or no number.
std::string participantOf(const std::string& cell) {
    const std::size_t last = cell.find_last_not_of(digits);
    return last == std::string::npos || last + 1 == cell.size() ? "" : cell.substr(last + 1);
}

std::string escaped(const std::string& text) { return kainjow::mustache::html_escape(oneLine(text)); }

// What a student reads in Moodle, which takes it for HTML.
std::string feedbackOf(const Result& result) {
    std::string text = "<p>" + escaped(verdictText(result)) + " " + marksText(result.score) + " of " +
                       marksText(result.maxScore) + " marks.</p>";
    std::string items;
    for (const StageResult& stage : result.stages)
        if (!isTogether(stage) && stage.status != Status::skipped)
            items += "<li>" + escaped(stageName(stage)) + ": " + marksText(stage.score) + "/" +
                     marksText(stage.maxScore) + ", " + statusWord(shownStatus(stage)) + "</li>";
    return items.empty() ? text : text + "<ul>" + items + "</ul>";
}

class Worksheet {
public:
    Worksheet(const std::string& text, const std::string& name) : file(text, name) {
        for (std::size_t row = 1; row < file.rows(); ++row)
            if (!isBlank(row)) rows.push_back(row);
        participants = findParticipants();
        findGrades();
    }

    FilledGradebook fill(const std::vector<StudentResult>& results, const FillOptions& options) {
        MarkColumn where;
        where.column = grades;
        where.rows = rows;
        where.keys = keys();
        where.labels = column(participants);
        where.points = most > 0 ? file.cell(rows.front(), most) : "";
        where.numbers = column(grades);
        if (most > 0) where.numbers.push_back(where.points);
        where.kept = [this](std::size_t row) {
            return isLocked(row) ? std::string("Moodle has the grade locked") : std::string();
        };
        if (options.feedback) writeFeedback(results, where);
        return fillMarks(file, where, results, options);
    }

private:
    std::vector<std::string> column(std::size_t place) const {
        std::vector<std::string> cells;
        for (const std::size_t row : rows) cells.push_back(file.cell(row, place));
        return cells;
    }

    bool isBlank(std::size_t row) const {
        for (std::size_t place = 0; place < file.columns(row); ++place)
            if (!file.cell(row, place).empty()) return false;
        return true;
    }

    std::string titles() const {
        std::string list;
        for (std::size_t place = 0; place < file.columns(0); ++place)
            list += (place == 0 ? "'" : ", '") + oneLine(file.cell(0, place)) + "'";
        return list;
    }

    [[noreturn]] void refuse(const std::string& what, const std::string& expected) const {
        throw Error(file.where(0), what + ": found the titles " + titles() + ", expected " + expected);
    }

    std::size_t findParticipants() const {
        for (std::size_t place = 0; place < file.columns(0); ++place) {
            const std::vector<std::string> cells = column(place);
            if (!cells.empty() && std::none_of(cells.begin(), cells.end(),
                                               [](const std::string& cell) { return participantOf(cell).empty(); }))
                return place;
        }
        refuse("is no grading worksheet of Moodle", "a column of participants, like 'Participant 12345'");
    }

    // Whether a column says what full marks are worth: one number, the same in every row.
    bool saysMost(std::size_t place) const {
        if (place >= file.columns(0)) return false;
        const std::vector<std::string> cells = column(place);
        const bool alike = std::count(cells.begin(), cells.end(), cells.front()) == std::ptrdiff_t(cells.size());
        return alike && numberOf(cells.front()).value_or(0.0) > 0.0;
    }

    bool holdsMarks(std::size_t place) const {
        const std::vector<std::string> cells = column(place);
        return std::all_of(cells.begin(), cells.end(),
                           [](const std::string& cell) { return cell.empty() || numberOf(cell); });
    }

    void findGrades() {
        std::vector<std::size_t> found;
        for (std::size_t place = participants + 1; place < file.columns(0); ++place)
            if (isOneOf(file.cell(0, place), gradeTitles)) found.push_back(place);
        for (std::size_t place = participants + 1; place < file.columns(0) && found.empty(); ++place)
            if (holdsMarks(place) && saysMost(place + 1)) found.push_back(place);
        if (found.size() != 1)
            refuse("the column of the marks is not clear", "one titled 'Grade', or in your language");
        grades = found.front();
        if (saysMost(grades + 1)) most = grades + 1;
        if (isOneOf(file.cell(0, grades + 1), scaleTitles) || !holdsMarks(grades))
            refuse("this assignment is graded by a scale", "one that is graded by points");
    }

    // Moodle puts the column of yes and no behind the largest mark, or behind the state of the workflow.
    bool isLocked(std::size_t row) const {
        return most > 0 && (isOneOf(file.cell(row, most + 1), no) || isOneOf(file.cell(row, most + 2), no));
    }

    RosterKeys keys() const {
        RosterKeys all;
        std::vector<std::string> numbers;
        for (const std::string& cell : column(participants)) numbers.push_back(participantOf(cell));
        all.accounts.push_back(numbers);
        for (std::size_t place = participants + 1; place < grades; ++place) {
            all.accounts.push_back(column(place));
        }
        all.names.push_back(column(participants + 1));
        return all;
    }

    std::size_t feedbackColumn() const {
        for (std::size_t place = grades + 1; place < file.columns(0); ++place)
            if (isOneOf(file.cell(0, place), feedbackTitles)) return place;
        refuse("there is no column for feedback", "'Feedback comments': choose that type of feedback in Moodle");
    }

    // Only where nobody has written anything yet.
    void writeFeedback(const std::vector<StudentResult>& results, const MarkColumn& where) {
        const std::size_t feedback = feedbackColumn();
        const RosterMatch match = matchRoster(results, where.keys);
        for (std::size_t number = 0; number < results.size(); ++number) {
            if (!match.row[number] || !hasMark(results[number])) continue;
            const std::size_t row = rows[*match.row[number]];
            if (file.cell(row, feedback).empty() && !isLocked(row))
                file.set(row, feedback, feedbackOf(results[number].result));
        }
    }

    CsvFile file;
    std::vector<std::size_t> rows;
    std::size_t participants = 0, grades = 0, most = 0;
};

}  // namespace

FilledGradebook filledMoodle(const std::string& worksheet, const std::vector<StudentResult>& results,
                             const FillOptions& options) {
    return Worksheet(worksheet, options.file).fill(results, options);
}

}  // namespace radlab::grader

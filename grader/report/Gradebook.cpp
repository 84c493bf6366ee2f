#include "grader/report/Gradebook.h"

#include <algorithm>
#include <cstdio>
#include <map>

#include "grader/report/TextLines.h"
#include "grader/report/Wording.h"

namespace radlab::grader {

namespace {

constexpr std::size_t mostDecimals = 2;

// Where the decimal sign of a number stands, or nothing where it has none, more than two decimals, or is no number.
std::size_t pointOf(const std::string& text) {
    const std::size_t point = text.find_first_of(".,");
    const bool number = text.find_first_not_of("0123456789.,") == std::string::npos && point != std::string::npos &&
                        point == text.find_last_of(".,");
    return number && text.size() - point - 1 <= mostDecimals ? point : std::string::npos;
}

// Writes the marks, and keeps account of whose cell was left as it was.
class Filling {
public:
    Filling(CsvFile& csv, const MarkColumn& column, const FillOptions& chosen)
        : file(csv), where(column), options(chosen) {
        std::vector<std::string> own = {where.points};
        for (const std::size_t row : where.rows) own.push_back(file.cell(row, where.column));
        style.decimals = numberStyleOf(own, file.delimiter()).decimals;
        style.point = numberStyleOf(where.numbers, file.delimiter()).point;
        points = numberOf(where.points).value_or(0.0);
    }

    FilledGradebook fill(const std::vector<StudentResult>& results) {
        const RosterMatch match = matchRoster(results, where.keys);
        std::vector<bool> known(where.rows.size(), false);
        for (std::size_t number = 0; number < results.size(); ++number) {
            const StudentResult& student = results[number];
            if (match.row[number]) {
                known[*match.row[number]] = true;
                if (match.byName[number]) note("matched by the name alone", shownName(student.student));
                fillCell(student, *match.row[number]);
            } else if (hasMark(student)) {
                filled.unmatchedStudents.push_back(labelOf(student));
            }
        }
        for (std::size_t row = 0; row < known.size(); ++row)
            if (!known[row]) filled.unmatchedRows.push_back(oneLine(where.labels[row]));
        return result();
    }

private:
    static std::string labelOf(const StudentResult& student) {
        const std::string name = shownName(student.student), id = oneLine(student.student.id);
        return name == id ? id : id + " (" + name + ")";
    }

    void note(const std::string& what, const std::string& who) { notes[what].push_back(who); }

    void fillCell(const StudentResult& student, std::size_t row) {
        const bool zero = student.outcome == Outcome::nothing && options.zeroForNothing;
        if (!hasMark(student) && !zero) {
            note("left as it was, since there is no mark: " + outcomeWord(student), labelOf(student));
            return;
        }
        const std::string kept = where.kept(where.rows[row]);
        if (!kept.empty()) {
            note("left as it was, since " + kept, labelOf(student));
            return;
        }
        file.set(where.rows[row], where.column, numberText(zero ? 0.0 : scaled(student.result), style));
        ++filled.filled;
    }

    double scaled(const Result& result) {
        if (points <= 0.0 || result.maxScore <= 0.0 || points == result.maxScore) return result.score;
        const std::string from = marksText(result.maxScore), to = marksText(points);
        scale = "marks were scaled: " + from + " of radlab are worth " + to + " in this file";
        return result.score / result.maxScore * points;
    }

    FilledGradebook result() {
        if (!scale.empty()) filled.notes.push_back(scale);
        if (points <= 0.0)
            filled.notes.emplace_back("marks were not scaled, since the file does not say what full marks are worth");
        for (const auto& [what, who] : notes) filled.notes.push_back(what + ": " + listText(who));
        filled.text = file.text();
        return std::move(filled);
    }

    CsvFile& file;
    const MarkColumn& where;
    const FillOptions& options;
    NumberStyle style;
    double points = 0.0;
    std::string scale;
    std::map<std::string, std::vector<std::string>> notes;
    FilledGradebook filled;
};

}  // namespace

NumberStyle numberStyleOf(const std::vector<std::string>& cells, char delimiter) {
    std::ptrdiff_t commas = 0, points = 0;
    NumberStyle style;
    for (const std::string& cell : cells) {
        const std::size_t point = pointOf(cell);
        if (point == std::string::npos) continue;
        ++(cell[point] == ',' ? commas : points);
        style.decimals = std::max(style.decimals, cell.size() - point - 1);
    }
    style.point = commas > points || (commas == points && delimiter == ';') ? ',' : '.';
    return style;
}

std::string numberText(double value, const NumberStyle& style) {
    char text[64];
    std::snprintf(text, sizeof text, "%.2f", value);
    std::string number = text;
    const std::size_t whole = number.find('.');
    while (number.back() == '0' && number.size() - whole - 1 > style.decimals) number.pop_back();
    if (number.back() == '.') number.pop_back();
    std::replace(number.begin(), number.end(), '.', style.point);
    return number;
}

std::optional<double> numberOf(std::string text) {
    std::replace(text.begin(), text.end(), ',', '.');
    if (text.empty() || text.find_first_not_of("0123456789.") != std::string::npos) return std::nullopt;
    if (std::count(text.begin(), text.end(), '.') > 1 || text == ".") return std::nullopt;
    return std::stod(text);
}

FilledGradebook fillMarks(CsvFile& file, const MarkColumn& where, const std::vector<StudentResult>& results,
                          const FillOptions& options) {
    return Filling(file, where, options).fill(results);
}

}  // namespace radlab::grader

#include "grader/report/Canvas.h"

#include <algorithm>
#include <cctype>

#include "base/Error.h"
#include "grader/report/TextLines.h"

namespace radlab::grader {

namespace {

constexpr std::size_t mostListed = 20;  // titles in an error

// Titles of totals, which Canvas takes for no assignment wherever they stand in a title.
constexpr const char* totals[] = {"Current Score", "Current Points", "Current Grade",  "Final Score",    "Final Points",
                                  "Final Grade",   "Override Score", "Override Grade", "Override Status"};

struct Assignment {
    std::size_t column;
    std::string title, number;
};

bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

std::string lower(std::string text) {
    for (char& letter : text) letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
    return text;
}

bool isReadOnly(const std::string& cell) { return holds(lower(cell), "read only"); }

// "Title (1234)" in its two parts; nothing for another title.
std::optional<Assignment> assignmentOf(const std::string& cell, std::size_t column) {
    const std::size_t open = cell.rfind(" (");
    if (cell.empty() || cell.back() != ')' || open == std::string::npos) return std::nullopt;
    const std::string number = cell.substr(open + 2, cell.size() - open - 3);
    if (number.empty() || number.find_first_not_of("0123456789") != std::string::npos) return std::nullopt;
    if (std::any_of(std::begin(totals), std::end(totals), [&](const char* total) { return holds(cell, total); }))
        return std::nullopt;
    return Assignment{column, cell.substr(0, open), number};
}

// A file that is read, and what stands where.
class Gradebook {
public:
    Gradebook(const std::string& text, const std::string& name) : file(text, name) {
        const bool whole = file.columns(0) > 3 && holds(file.cell(0, 0), "Student") && holds(file.cell(0, 1), "ID");
        parted = file.columns(0) > 4 && file.cell(0, 0) == "LastName" && file.cell(0, 1) == "FirstName" &&
                 file.cell(0, 2) == "ID";
        section = columnOf("Section");
        if ((!whole && !parted) || section == 0)
            throw Error(file.where(0), "is no gradebook of Canvas: found the titles " + titles(0) +
                                           ", expected Student, ID, SIS Login ID, Section and then assignments");
        for (std::size_t row = 1; row < file.rows(); ++row) {
            // A student may be called like that, but has an ID.
            if (holds(file.cell(row, 0), "Points Possible") && file.cell(row, idColumn()).empty())
                pointsRow = row;
            else if (isStudent(row))
                students.push_back(row);
        }
    }

    FilledGradebook fill(const std::vector<StudentResult>& results, const FillOptions& options) {
        MarkColumn where;
        where.column = chosen(options).column;
        where.rows = students;
        where.keys = keys();
        for (const std::size_t row : students) where.labels.push_back(nameIn(row));
        where.points = pointsRow > 0 ? file.cell(pointsRow, where.column) : "";
        where.numbers = numbers();
        where.kept = [this, column = where.column](std::size_t row) { return whyKept(file.cell(row, column)); };
        return fillMarks(file, where, results, options);
    }

private:
    std::size_t columnOf(const std::string& title) const {
        for (std::size_t column = 0; column < file.columns(0); ++column)
            if (holds(file.cell(0, column), title)) return column;
        return 0;
    }

    std::size_t idColumn() const { return parted ? 2 : 1; }

    // Rows that say how marks are posted have nothing where students have names and numbers.
    bool isStudent(std::size_t row) const {
        for (std::size_t column = 0; column < section; ++column)
            if (file.cell(row, column).find_first_not_of(' ') != std::string::npos) return true;
        return false;
    }

    std::string nameIn(std::size_t row) const {
        return parted ? file.cell(row, 0) + ", " + file.cell(row, 1) : file.cell(row, 0);
    }

    std::string titles(std::size_t from) const {
        std::string list;
        for (std::size_t column = from; column < std::min(file.columns(0), from + mostListed); ++column)
            list += (list.empty() ? "'" : ", '") + oneLine(file.cell(0, column)) + "'";
        return list.empty() ? "none" : list;
    }

    std::vector<Assignment> assignments() const {
        std::vector<Assignment> found;
        for (std::size_t column = section + 1; column < file.columns(0); ++column) {
            const std::optional<Assignment> assignment = assignmentOf(file.cell(0, column), column);
            if (assignment && (pointsRow == 0 || !isReadOnly(file.cell(pointsRow, column))))
                found.push_back(*assignment);
        }
        return found;
    }

    // Those that are exactly what was asked for, or else those whose title has it in it.
    static std::vector<Assignment> fitting(const std::vector<Assignment>& all, const std::string& wanted) {
        std::vector<Assignment> exact, near;
        for (const Assignment& one : all) {
            if (wanted == one.number || wanted == one.title || wanted == one.title + " (" + one.number + ")")
                exact.push_back(one);
            if (holds(lower(one.title), lower(wanted))) near.push_back(one);
        }
        return exact.empty() ? near : exact;
    }

    Assignment chosen(const FillOptions& options) const {
        const std::vector<Assignment> all = assignments();
        if (all.empty())
            throw Error(file.where(0), "holds no assignment: found the titles " + titles(section + 1) +
                                           ", expected one like 'Radiosity (1234)'");
        const std::vector<Assignment> found = fitting(all, options.assignment);
        if (found.size() == 1) return found.front();
        std::string list;
        const std::vector<Assignment>& listed = found.empty() ? all : found;
        for (std::size_t i = 0; i < std::min(listed.size(), mostListed); ++i)
            list += (i == 0 ? "'" : ", '") + oneLine(listed[i].title) + "' (" + listed[i].number + ")";
        const std::string wanted = options.assignment.empty() ? "" : " '" + oneLine(options.assignment) + "'";
        throw Error(file.where(0), std::string(found.empty() ? "no assignment fits" : "several assignments fit") +
                                       wanted + ": found " + list +
                                       ", expected --assignment with the number of one of them");
    }

    RosterKeys keys() const {
        RosterKeys all;
        const auto column = [&](std::size_t place) {
            std::vector<std::string> cells;
            for (const std::size_t row : students) cells.push_back(file.cell(row, place));
            return cells;
        };
        all.accounts.push_back(column(idColumn()));
        for (const char* title : {"SIS User ID", "SIS Login ID", "Integration ID"})
            if (columnOf(title) > 0) all.accounts.push_back(column(columnOf(title)));
        std::vector<std::string> asWritten, turned;
        for (const std::size_t row : students) {
            const std::string name = nameIn(row);
            const std::size_t comma = name.find(',');
            asWritten.push_back(name);
            turned.push_back(comma == std::string::npos ? "" : name.substr(comma + 1) + name.substr(0, comma));
        }
        all.names = {asWritten, turned};
        return all;
    }

    std::vector<std::string> numbers() const {
        std::vector<std::string> cells;
        for (std::size_t row = 1; row < file.rows(); ++row)
            for (std::size_t column = section + 1; column < file.columns(row); ++column)
                cells.push_back(file.cell(row, column));
        return cells;
    }

    static std::string whyKept(const std::string& cell) {
        if (lower(cell) == "ex") return "Canvas has the student excused";
        if (cell == "N/A") return "Canvas has it not assigned to the student";
        return isReadOnly(cell) ? "Canvas has the cell read only" : "";
    }

    CsvFile file;
    bool parted = false;  // the name in two columns
    std::size_t section = 0, pointsRow = 0;
    std::vector<std::size_t> students;
};

}  // namespace

FilledGradebook filledCanvas(const std::string& gradebook, const std::vector<StudentResult>& results,
                             const FillOptions& options) {
    return Gradebook(gradebook, options.file).fill(results, options);
}

}  // namespace radlab::grader

#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "grader/protocol/Student.h"
#include "grader/report/CsvFile.h"
#include "grader/report/Roster.h"

namespace radlab::grader {

/// How the file that an instructor downloaded from a learning platform is filled in.
struct FillOptions {
    std::string file = "gradebook";  ///< what errors call it
    std::string assignment;          ///< title or number of the column to fill; empty where there is but one
    bool zeroForNothing = false;     ///< write 0 for who handed in nothing, instead of leaving the cell as it was
    bool feedback = false;           ///< Moodle: write a summary into empty feedback cells, too
};

/// The file filled in, and what the instructor should know. All texts are on one line, and safe to show.
struct FilledGradebook {
    std::string text;
    std::size_t filled = 0;                      ///< cells with a mark of this class
    std::vector<std::string> notes;              ///< what was decided, and what was left as it was and why
    std::vector<std::string> unmatchedStudents;  ///< with a mark, and no row of their own
    std::vector<std::string> unmatchedRows;      ///< of the file, with nobody of this class
};

/// Where the marks belong in a file.
struct MarkColumn {
    std::size_t column = 0;
    std::vector<std::size_t> rows;                 ///< those of students
    RosterKeys keys;                               ///< a key for each of these rows
    std::vector<std::string> labels;               ///< what each of these rows is called
    std::string points;                            ///< the cell that says what full marks are worth; empty: unknown
    std::vector<std::string> numbers;              ///< cells that may show which decimal sign the file uses
    std::function<std::string(std::size_t)> kept;  ///< why the cell of a row must stay as it is; empty: it need not
};

/// How a file writes numbers.
struct NumberStyle {
    char point = '.';
    std::size_t decimals = 0;  ///< at least so many; two where a mark needs them
};

/// How a file writes numbers, told by cells that hold some: the sign that most use, else a comma where cells are
/// parted by semicolons; the decimals of the one that has most. Cells that are no
/// number of at most two decimals tell nothing.
NumberStyle numberStyleOf(const std::vector<std::string>& cells, char delimiter);

/// A number of at most two decimals as a file writes it: "85,50".
std::string numberText(double value, const NumberStyle& style);

/// A number with a decimal point or comma, or nothing.
std::optional<double> numberOf(std::string text);

/// Writes the marks of a class into a column. Students without a mark, for whatever reason, leave their cell as it was.
///
/// Marks are scaled where full marks are worth something else in the file.
FilledGradebook fillMarks(CsvFile& file, const MarkColumn& where, const std::vector<StudentResult>& results,
                          const FillOptions& options);

}  // namespace radlab::grader

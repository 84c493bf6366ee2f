#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/Error.h"

namespace radlab::grader {

/// What spreadsheets take as the sign of UTF-8 at the begin of a file.
inline constexpr std::string_view byteOrderMark = "\xef\xbb\xbf";

/// A CSV file of which some cells are changed and every other byte stays as it was.
///
/// Delimiter (comma, semicolon or tab, whichever splits the first line into more cells), quoting, ends of lines, empty
/// lines and a byte order mark are those of the file. A line without any byte is no row.
class CsvFile {
public:
    /// @param name what errors call the file
    /// Errors: no line at all, a quote that is never closed, text after a closing quote, a byte 0 (as UTF-16 has).
    CsvFile(std::string text, std::string name);

    char delimiter() const { return separator; }
    std::size_t rows() const { return lines.size(); }
    std::size_t columns(std::size_t row) const { return lines[row].cells.size(); }

    /// The value of a cell, without its quotes; empty where the row is shorter.
    const std::string& cell(std::size_t row, std::size_t column) const;

    /// Changes a cell; it is quoted where it was, or where its value needs it.
    ///
    /// Errors: a row that is shorter.
    void set(std::size_t row, std::size_t column, const std::string& value);

    /// The file as it is now.
    std::string text() const;

    /// Where a row stands, for errors.
    Location where(std::size_t row) const { return {fileName, lines[row].number}; }

private:
    struct Cell {
        std::size_t begin, length;  // in bytes, quotes included
        std::string value;
        bool quoted = false;
        bool changed = false;
    };
    struct Line {
        std::vector<Cell> cells;
        int number;
    };

    void read(std::size_t begin);
    Cell readCell(std::size_t& at, int& number) const;
    void readQuoted(Cell& cell, std::size_t& at, int& number) const;

    std::string bytes, fileName;
    std::vector<Line> lines;
    char separator = ',';
};

/// A cell of a new CSV file, quoted where its value needs it.
///
/// @source RFC 4180
std::string csvCell(std::string_view value, char delimiter = ',');

/// A row of a new CSV file, its line ended by CR and LF.
std::string csvRow(const std::vector<std::string>& values);

/// The text on one line, such that no spreadsheet takes it for a formula: a sign that would begin one gets an
/// apostrophe before it.
///
/// Also after a semicolon, where a spreadsheet of another language would begin a cell. Numbers stay as they are.
/// @source OWASP, CSV Injection
std::string spreadsheetText(std::string_view bytes);

}  // namespace radlab::grader

#include "grader/report/CsvFile.h"

#include <algorithm>
#include <charconv>

#include "grader/protocol/PlainText.h"
#include "grader/report/TextLines.h"

namespace radlab::grader {

namespace {

// How often a delimiter stands in the first line, outside quotes.
std::ptrdiff_t splitsOf(std::string_view text, char delimiter) {
    bool quoted = false;
    std::ptrdiff_t splits = 0;
    for (const char letter : text) {
        if (letter == '"') quoted = !quoted;
        if (!quoted && (letter == '\n' || letter == '\r')) break;
        if (!quoted && letter == delimiter) ++splits;
    }
    return splits;
}

char delimiterOf(std::string_view text) {
    char best = ',';
    for (const char candidate : {';', '\t'})
        if (splitsOf(text, candidate) > splitsOf(text, best)) best = candidate;
    return best;
}

bool endsLine(char letter) { return letter == '\n' || letter == '\r'; }

// Behind the end of a line, which is LF, CR or both.
void passLineEnd(std::string_view text, std::size_t& at) {
    const bool both = text.substr(at, 2) == "\r\n";
    at += both ? 2 : 1;
}

bool isNumber(std::string_view text) {
    if (text.find_first_not_of("0123456789.eE+-") != std::string_view::npos) return false;
    if (!text.empty() && text.front() == '+') text.remove_prefix(1);
    double value = 0;
    const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
    return failure == std::errc() && end == text.data() + text.size();
}

// Spreadsheets of East Asia take the wide forms of the signs, too.
bool beginsFormula(std::string_view text) {
    text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
    for (const char* sign : {"=", "+", "-", "@", "＝", "＋", "－", "＠"})
        if (text.substr(0, std::string_view(sign).size()) == sign) return true;
    return false;
}

}  // namespace

CsvFile::CsvFile(std::string text, std::string name) : bytes(std::move(text)), fileName(std::move(name)) {
    if (bytes.find('\0') != std::string::npos)
        throw Error({fileName}, "is no CSV file: found a byte 0, expected text in UTF-8; save it as CSV UTF-8");
    const bool marked = std::string_view(bytes).substr(0, byteOrderMark.size()) == byteOrderMark;
    read(marked ? byteOrderMark.size() : 0);
    if (lines.empty()) throw Error({fileName}, "is empty: expected a line of titles");
}

void CsvFile::read(std::size_t begin) {
    separator = delimiterOf(std::string_view(bytes).substr(begin));
    int number = 1;
    for (std::size_t at = begin; at < bytes.size(); ++number) {
        if (endsLine(bytes[at])) {
            passLineEnd(bytes, at);
            continue;
        }
        Line line{{}, number};
        line.cells.push_back(readCell(at, number));
        while (at < bytes.size() && bytes[at] == separator) line.cells.push_back(readCell(++at, number));
        if (at < bytes.size()) passLineEnd(bytes, at);
        lines.push_back(std::move(line));
    }
}

CsvFile::Cell CsvFile::readCell(std::size_t& at, int& number) const {
    Cell cell{at, 0, "", at < bytes.size() && bytes[at] == '"'};
    if (cell.quoted) {
        readQuoted(cell, at, number);
    } else {
        while (at < bytes.size() && bytes[at] != separator && !endsLine(bytes[at])) ++at;
        cell.value = bytes.substr(cell.begin, at - cell.begin);
    }
    cell.length = at - cell.begin;
    return cell;
}

void CsvFile::readQuoted(Cell& cell, std::size_t& at, int& number) const {
    const int begun = number;
    bool closed = false;
    for (++at; at < bytes.size() && !closed; ++at) {
        if (bytes[at] == '\n') ++number;
        closed = bytes[at] == '"' && bytes.substr(at + 1, 1) != "\"";
        if (closed) continue;
        if (bytes[at] == '"') ++at;
        cell.value += bytes[at];
    }
    if (!closed) throw Error({fileName, begun}, "a quote is opened and never closed");
    if (at < bytes.size() && bytes[at] != separator && !endsLine(bytes[at]))
        throw Error({fileName, number}, "text after a closing quote: found '" + oneLine(bytes.substr(at, 1)) +
                                            "', expected the next cell or the end of the line");
}

const std::string& CsvFile::cell(std::size_t row, std::size_t column) const {
    static const std::string none;
    return column < lines[row].cells.size() ? lines[row].cells[column].value : none;
}

void CsvFile::set(std::size_t row, std::size_t column, const std::string& value) {
    if (column >= columns(row))
        throw Error(where(row), "the line is too short: found " + std::to_string(columns(row)) +
                                    " cells, expected at least " + std::to_string(column + 1));
    lines[row].cells[column].value = value;
    lines[row].cells[column].changed = true;
}

std::string CsvFile::text() const {
    std::string all;
    std::size_t copied = 0;
    for (const Line& line : lines)
        for (const Cell& cell : line.cells) {
            if (!cell.changed) continue;
            all.append(bytes, copied, cell.begin - copied);
            const std::string written = csvCell(cell.value, separator);
            const bool quote = cell.quoted && (written.empty() || written.front() != '"');
            all += quote ? '"' + written + '"' : written;
            copied = cell.begin + cell.length;
        }
    return all.append(bytes, copied);
}

std::string csvCell(std::string_view value, char delimiter) {
    const std::string special = std::string("\"\r\n") + delimiter;
    const bool edged = !value.empty() && (value.front() == ' ' || value.back() == ' ');
    if (value.find_first_of(special) == std::string_view::npos && !edged) return std::string(value);
    std::string quoted = "\"";
    for (const char letter : value) quoted += letter == '"' ? "\"\"" : std::string(1, letter);
    return quoted + '"';
}

std::string csvRow(const std::vector<std::string>& values) {
    std::string row;
    for (const std::string& value : values) row += csvCell(value) + ",";
    if (!row.empty()) row.pop_back();
    return row + "\r\n";
}

std::string spreadsheetText(std::string_view bytes) {
    std::string line = oneLine(bytes);
    if (isNumber(line)) return line;
    std::string safe;
    for (std::size_t begin = 0; begin <= line.size();) {
        const std::size_t end = std::min(line.find(';', begin), line.size());
        const std::string part = line.substr(begin, end - begin);
        safe += (begin > 0 ? ";" : "") + std::string(beginsFormula(part) ? "'" : "") + part;
        begin = end + 1;
    }
    return safe;
}

}  // namespace radlab::grader

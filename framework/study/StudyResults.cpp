#include "study/StudyResults.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include "base/Error.h"
#include "base/NumberText.h"
#include "base/WholeFile.h"

namespace radlab::study {

namespace {

constexpr int digits = 6;

std::string textOf(const std::string& value) { return value; }
std::string textOf(std::size_t value) { return std::to_string(value); }
std::string textOf(double value) {
    std::string text;
    appendNumber(text, value, digits);
    return text;
}
std::string textOf(const std::optional<double>& value) { return value ? textOf(*value) : ""; }

template <class Number>
void readNumber(const std::string& text, Number& value) {
    const char* end = text.data() + text.size();
    const auto read = std::from_chars(text.data(), end, value);
    if (read.ec != std::errc() || read.ptr != end) throw Error("found '" + text + "', expected a number");
}
void read(const std::string& text, std::string& value) { value = text; }
void read(const std::string& text, std::size_t& value) { readNumber(text, value); }
void read(const std::string& text, double& value) {
    readNumber(text, value);
    if (!std::isfinite(value)) throw Error("found '" + text + "', expected a finite number");
}
void read(const std::string& text, std::optional<double>& value) {
    if (!text.empty()) read(text, value.emplace());
}

struct Column {
    const char* name;
    std::string (*text)(const Measurement&);
    void (*read)(const std::string&, Measurement&);
};

template <auto Member>
constexpr Column column(const char* name) {
    return {name, [](const Measurement& row) { return textOf(row.*Member); },
            [](const std::string& text, Measurement& row) { read(text, row.*Member); }};
}

constexpr Column columns[] = {
    column<&Measurement::version>("version"),
    column<&Measurement::plan>("plan"),
    column<&Measurement::scene>("scene"),
    column<&Measurement::contents>("contents"),
    column<&Measurement::wanted>("patches_wanted"),
    column<&Measurement::patches>("patches"),
    column<&Measurement::method>("method"),
    column<&Measurement::setting>("setting"),
    column<&Measurement::level>("level"),
    column<&Measurement::repeats>("repeats"),
    column<&Measurement::seconds>("seconds"),
    column<&Measurement::fastest>("seconds_least"),
    column<&Measurement::slowest>("seconds_most"),
    column<&Measurement::solverError>("solver_error"),
    column<&Measurement::solverReference>("solver_reference_error"),
    column<&Measurement::wholeError>("whole_error"),
    column<&Measurement::wholeReference>("whole_reference_error"),
    column<&Measurement::bytes>("bytes"),
    column<&Measurement::shots>("shots"),
};

std::vector<std::string> names() {
    std::vector<std::string> all;
    for (const Column& one : columns) all.emplace_back(one.name);
    return all;
}

Measurement rowOf(const std::vector<std::string>& fields, const Location& where) {
    if (fields.size() != std::size(columns))
        throw Error(where, "found " + std::to_string(fields.size()) + " fields, expected " +
                               std::to_string(std::size(columns)) + "; --fresh starts anew");
    Measurement row;
    for (std::size_t i = 0; i < fields.size(); ++i) try {
            columns[i].read(fields[i], row);
        } catch (const Error& wrong) {
            throw Error(where, std::string(columns[i].name) + ": " + wrong.what() + "; --fresh starts anew");
        }
    return row;
}

bool sameWork(const Measurement& a, const Measurement& b) {
    return a.plan == b.plan && a.scene == b.scene && a.wanted == b.wanted && a.method == b.method &&
           a.setting == b.setting;
}

}  // namespace

std::string csvField(const std::string& text) {
    if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quoted + "\"";
}

std::vector<std::vector<std::string>> csvLines(std::string_view text) {
    std::vector<std::vector<std::string>> lines;
    std::vector<std::string> line(1);
    bool quoted = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (c == '"' && quoted && i + 1 < text.size() && text[i + 1] == '"') {
            line.back() += text[++i];
        } else if (c == '"') {
            quoted = !quoted;
        } else if (c == ',' && !quoted) {
            line.emplace_back();
        } else if (c == '\n' && !quoted) {
            lines.push_back(std::exchange(line, std::vector<std::string>(1)));
        } else if (c != '\r' || quoted) {
            line.back() += c;
        }
    }
    return lines;
}

std::string csvOf(const std::vector<Measurement>& rows) {
    std::string text;
    for (const Column& one : columns) text += (text.empty() ? "" : ",") + std::string(one.name);
    text += '\n';
    for (const Measurement& row : rows) {
        for (std::size_t i = 0; i < std::size(columns); ++i)
            text += (i == 0 ? "" : ",") + csvField(columns[i].text(row));
        text += '\n';
    }
    return text;
}

StudyResults::StudyResults(std::filesystem::path where, bool fresh) : file(std::move(where)) {
    if (fresh || !std::filesystem::exists(file)) return;
    const auto lines = csvLines(readFile(file));
    if (lines.empty()) return;
    if (lines.front() != names())
        throw Error({file.string(), 1}, "these are not the columns of a study's results; --fresh writes over them");
    for (std::size_t i = 1; i < lines.size(); ++i) {
        const Measurement row = rowOf(lines[i], {file.string(), static_cast<int>(i) + 1});
        if (row.version == RADLAB_VERSION) measured.push_back(row);
    }
}

const Measurement* StudyResults::find(const Measurement& like) const {
    const auto found = std::find_if(measured.begin(), measured.end(), [&](const Measurement& row) {
        return sameWork(row, like) && row.contents == like.contents;
    });
    return found == measured.end() ? nullptr : &*found;
}

void StudyResults::add(const Measurement& row) {
    std::erase_if(measured, [&](const Measurement& old) { return sameWork(old, row); });
    measured.push_back(row);
    writeFile(file, csvOf(measured));
}

}  // namespace radlab::study

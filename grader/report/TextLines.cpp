#include "grader/report/TextLines.h"

#include <algorithm>
#include <iterator>

#include "base/Error.h"
#include "grader/protocol/PlainText.h"

namespace radlab::grader {

namespace {

constexpr const char* ellipsis = "…";

struct Range {
    char32_t first, last;
};

// Two columns wide: Hangul, the scripts of East Asia, symbols that are often emoji.
constexpr Range wideRanges[] = {{0x1100, 0x115f},   {0x231a, 0x231b},   {0x23e9, 0x23f3},  {0x25fd, 0x25fe},
                                {0x2600, 0x27bf},   {0x2b1b, 0x2b55},   {0x2e80, 0xd7ff},  {0xf900, 0xfaff},
                                {0xfe10, 0xfe6f},   {0xff00, 0xff60},   {0xffe0, 0xffe6},  {0x16fe0, 0x18dff},
                                {0x1aff0, 0x1b2ff}, {0x1f000, 0x1faff}, {0x20000, 0x3fffd}};

int widthOf(char32_t value) {
    const auto holds = [value](const Range& range) { return value >= range.first && value <= range.last; };
    return value >= wideRanges[0].first && std::any_of(std::begin(wideRanges), std::end(wideRanges), holds) ? 2 : 1;
}

// The longest start of a text that fits; at least one character, so that who breaks a text gets on.
std::string_view startThatFits(std::string_view text, int columns) {
    std::size_t end = 0;
    for (int used = 0; end < text.size();) {
        const Character character = firstCharacter(text.substr(end));
        used += widthOf(character.value);
        if (used > columns && end > 0) break;
        end += character.length;
    }
    return text.substr(0, end);
}

std::string_view takeWord(std::string_view& text) {
    text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
    const std::string_view word = text.substr(0, text.find(' '));
    text.remove_prefix(word.size());
    return word;
}

// Breaks one line; each piece begins with the spaces that the line begins with.
void wrapLine(std::string_view line, int columns, std::vector<std::string>& lines) {
    if (columnsOf(line) <= columns) {
        lines.emplace_back(line);
        return;
    }
    const std::size_t spaces = std::min(line.find_first_not_of(' '), static_cast<std::size_t>(columns / 2));
    const std::string margin(spaces, ' ');
    std::string current = margin;
    int used = static_cast<int>(spaces);
    const auto endLine = [&] {
        lines.push_back(current);
        current = margin;
        used = static_cast<int>(spaces);
    };
    for (std::string_view word = takeWord(line); !word.empty(); word = takeWord(line)) {
        const bool first = current == margin;
        if (!first && used + 1 + columnsOf(word) > columns)
            endLine();
        else if (!first) {
            current += ' ';
            ++used;
        }
        while (used + columnsOf(word) > columns) {
            const std::string_view piece = startThatFits(word, columns - used);
            current += piece;
            word.remove_prefix(piece.size());
            endLine();
        }
        current += word;
        used += columnsOf(word);
    }
    if (current != margin) lines.push_back(current);
}

std::string withoutTabs(std::string_view text) {
    std::string spaced;
    for (const char letter : text) spaced += letter == '\t' ? "    " : std::string(1, letter);
    return spaced;
}

}  // namespace

int columnsOf(std::string_view text) {
    int columns = 0;
    while (!text.empty()) {
        const Character character = firstCharacter(text);
        columns += widthOf(character.value);
        text.remove_prefix(character.length);
    }
    return columns;
}

std::string oneLine(std::string_view bytes) {
    std::string text = visibleText(bytes);
    std::replace_if(
        text.begin(), text.end(), [](char letter) { return letter == '\n' || letter == '\t'; }, ' ');
    return text;
}

std::string cutLine(std::string_view text, int columns) {
    RADLAB_CHECK(columns >= 2);
    if (columnsOf(text) <= columns) return std::string(text);
    // One column might be too few for a wide first character, which startThatFits takes all the same.
    const std::string_view start = startThatFits(text, columns - 1);
    return columnsOf(start) < columns ? std::string(start) + ellipsis : ellipsis;
}

std::vector<std::string> wrapText(std::string_view text, int columns) {
    RADLAB_CHECK(columns >= 4);
    const std::string spaced = withoutTabs(text);
    std::vector<std::string> lines;
    for (std::string_view rest = spaced; !rest.empty();) {
        const std::size_t end = std::min(rest.find('\n'), rest.size());
        wrapLine(rest.substr(0, end), columns, lines);
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    while (!lines.empty() && lines.back().find_first_not_of(' ') == std::string::npos) lines.pop_back();
    return lines;
}

void limitLines(std::vector<std::string>& lines, std::size_t most, int columns) {
    if (lines.size() <= most) return;
    lines.resize(most);
    if (most > 0) lines.back() = cutLine(lines.back() + " " + ellipsis, columns);
}

}  // namespace radlab::grader

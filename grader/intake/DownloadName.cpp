#include "grader/intake/DownloadName.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <regex>

namespace radlab::grader {

namespace {

// The leftmost numbers are Canvas' own: what follows them is the student's, who may write there what looks like
// numbers.
const std::regex& canvasPattern() {
    static const std::regex pattern(
        R"((?:(?!LATE_)([\s\S]*?)_)?(LATE_)?(anon_[0-9A-Za-z]+|\d+)_(?:(\d+)_([\s\S]+)|(?:text|link)\.html))");
    return pattern;
}

const std::regex& moodlePattern() {
    static const std::regex pattern(R"(([^_]+)(?:_(\d+))?_assignsubmission_([a-z]+)(?:_([\s\S]*))?)");
    return pattern;
}

const std::regex& archivePattern() {
    static const std::regex pattern(
        R"(([\s\S]*?)(?:\.zip|\.tar(?:-\d+)?(?:\.(?:gz|xz|bz2|zst))?|\.(?:tgz|txz|tbz2?|tzst)))", std::regex::icase);
    return pattern;
}

bool beginsWithNumber(const std::string& text) {
    const std::size_t digits = text.find_first_not_of("0123456789");
    return digits != 0 && digits != std::string::npos && text[digits] == '_';
}

char lowered(char letter) { return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter + ('a' - 'A')) : letter; }

// The name without "-N" before its ending, and N.
std::optional<std::pair<std::string, int>> withoutNumber(std::string_view name) {
    const std::string_view ending = endingOf(name);
    const std::string_view stem = name.substr(0, name.size() - ending.size());
    const std::size_t dash = stem.rfind('-');
    if (dash == std::string_view::npos) return {};
    int number = 0;
    const char* const end = stem.data() + stem.size();
    const auto [stopped, error] = std::from_chars(stem.data() + dash + 1, end, number);
    if (error != std::errc() || stopped != end || number < 1) return {};
    return {{std::string(stem.substr(0, dash)) + std::string(ending), number}};
}

}  // namespace

std::optional<CanvasName> canvasName(const std::string& file) {
    std::smatch parts;
    if (!std::regex_match(file, parts, canvasPattern())) return {};
    return CanvasName{parts[1], parts[3], parts[4], parts[5], parts[2].matched, beginsWithNumber(parts[5])};
}

std::optional<MoodleName> moodleName(const std::string& entry) {
    std::smatch parts;
    if (!std::regex_match(entry, parts, moodlePattern())) return {};
    return MoodleName{parts[1], parts[2], parts[3] == "file", parts[4]};
}

std::string originalName(const std::string& file) {
    if (const auto moodle = moodleName(file)) return moodle->original;
    if (const auto canvas = canvasName(file)) return canvas->original;
    return "";
}

int numberOf(std::string_view file) {
    const auto numbered = withoutNumber(file);
    return numbered ? numbered->second : 0;
}

FileKind kindOf(std::string_view file) {
    if (std::regex_match(file.begin(), file.end(), archivePattern())) return FileKind::archive;
    for (const char* foreign : {".7z", ".rar"})
        if (sameButForCase(endingOf(file), foreign)) return FileKind::foreignArchive;
    return FileKind::other;
}

std::string withoutEnding(std::string_view file) {
    std::cmatch parts;
    if (std::regex_match(file.data(), file.data() + file.size(), parts, archivePattern())) return parts[1];
    return std::string(file.substr(0, file.size() - endingOf(file).size()));
}

std::string_view endingOf(std::string_view file) {
    const std::size_t dot = file.rfind('.');
    return dot == std::string_view::npos || dot == 0 ? std::string_view() : file.substr(dot);
}

bool sameButForCase(std::string_view a, std::string_view b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](char x, char y) { return lowered(x) == lowered(y); });
}

std::optional<NameMatch> matchName(std::string_view found, std::string_view wanted) {
    if (found == wanted) return NameMatch{};
    const auto numbered = withoutNumber(found);
    if (numbered && numbered->first == wanted) return NameMatch{NameMatch::How::numbered, numbered->second};
    if (sameButForCase(found, wanted)) return NameMatch{NameMatch::How::otherCase, 0};
    if (numbered && sameButForCase(numbered->first, wanted))
        return NameMatch{NameMatch::How::otherCase, numbered->second};
    return {};
}

}  // namespace radlab::grader

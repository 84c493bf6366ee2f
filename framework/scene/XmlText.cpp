#include "scene/XmlText.h"

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <system_error>

#include "base/Error.h"
#include "base/Interrupts.h"

namespace radlab {

namespace {

constexpr std::uintmax_t largestFile = std::uintmax_t(1) << 30;
constexpr std::size_t longestQuote = 40;

unsigned byteAt(std::string_view text, std::size_t at) { return static_cast<unsigned char>(text[at]); }

int lineAt(std::string_view text, std::size_t at) {
    return 1 + static_cast<int>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
}

/// The smallest code point that may be written with so many bytes: a longer spelling of a smaller one is not UTF-8.
unsigned smallestOfLength(std::size_t length) { return length == 2 ? 0x80u : length == 3 ? 0x800u : 0x10000u; }

/// Bytes of the UTF-8 character at a place, 0 where there is none.
std::size_t utf8Length(std::string_view text, std::size_t at) {
    const unsigned lead = byteAt(text, at);
    if (lead < 0x80) return 1;
    const std::size_t length = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
    if (lead < 0xC2 || lead > 0xF4 || at + length > text.size()) return 0;
    unsigned code = lead & (0x7Fu >> length);
    for (std::size_t i = 1; i < length; ++i) {
        if ((byteAt(text, at + i) & 0xC0u) != 0x80u) return 0;
        code = (code << 6) | (byteAt(text, at + i) & 0x3Fu);
    }
    const bool surrogate = code >= 0xD800 && code <= 0xDFFF;
    return code < smallestOfLength(length) || code > 0x10FFFF || surrogate ? 0 : length;
}

bool isControl(unsigned byte) { return byte < 0x20 && byte != '\t' && byte != '\n' && byte != '\r'; }

std::string hexText(unsigned byte) {
    const char* digits = "0123456789ABCDEF";
    return std::string("0x") + digits[byte >> 4] + digits[byte & 15];
}

/// Past the end of the document type that starts at `at`; quotes and brackets may hold a '>'.
std::size_t endOfDoctype(std::string_view text, std::size_t at) {
    int brackets = 0;
    char quote = 0;
    for (; at < text.size(); ++at) {
        const char c = text[at];
        if (quote) {
            if (c == quote) quote = 0;
        } else if (c == '"' || c == '\'') {
            quote = c;
        } else if (c == '[' || c == ']') {
            brackets += c == '[' ? 1 : -1;
        } else if (c == '>' && brackets <= 0) {
            return at + 1;
        }
    }
    return std::string_view::npos;
}

}  // namespace

std::string pathText(const std::filesystem::path& path) {
    const auto utf8 = path.u8string();
    return {utf8.begin(), utf8.end()};
}

std::filesystem::path pathFromText(std::string_view text) { return {std::u8string(text.begin(), text.end())}; }

std::string inQuotes(std::string_view text) {
    std::string shown(text.substr(0, longestQuote));
    if (text.size() > longestQuote) {
        while (!shown.empty() && (byteAt(shown, shown.size() - 1) & 0xC0u) == 0x80u) shown.pop_back();
        if (!shown.empty() && byteAt(shown, shown.size() - 1) >= 0x80u) shown.pop_back();
        shown += "...";
    }
    for (char& c : shown)
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) c = ' ';
    return "'" + shown + "'";
}

std::string readTextFile(const std::filesystem::path& file) {
    const Location where{pathText(file), 0};
    std::error_code problem;
    const auto status = std::filesystem::status(file, problem);
    if (!std::filesystem::exists(status)) throw Error(where, "there is no such file");
    if (std::filesystem::is_directory(status)) throw Error(where, "this is a folder, expected a file");
    const auto size = std::filesystem::file_size(file, problem);
    if (problem) throw Error(where, "this is not a plain file");
    if (size > largestFile)
        throw Error(where, "the file is too large, found " + std::to_string(size) + " bytes, expected at most 1 GiB");
    std::ifstream stream(file, std::ios::binary);
    std::string text(static_cast<std::size_t>(size), '\0');
    if (!stream || !stream.read(text.data(), static_cast<std::streamsize>(size)))
        throw Error(where, "the file cannot be read, check that you are allowed to");
    return text;
}

void checkText(std::string_view text, const std::string& fileName) {
    for (std::size_t at = 0, length = 0; at < text.size(); at += length) {
        Interrupts::check();
        const unsigned byte = byteAt(text, at);
        length = utf8Length(text, at);
        if (length > 0 && !isControl(byte)) continue;
        throw Error(Location{fileName, lineAt(text, at)},
                    "this is not text, found byte " + hexText(byte) + ", expected XML as UTF-8");
    }
}

std::string withoutDoctype(std::string_view text) {
    std::string result(text);
    const std::size_t start = text.find("<!DOCTYPE");
    // One inside a comment, or after the first element, is none of ours.
    if (start == std::string_view::npos) return result;
    for (std::size_t at = text.find('<'); at < start; at = text.find('<', at + 1)) {
        const bool comment = text.substr(at, 4) == "<!--";
        if (!comment && text.substr(at, 2) != "<?") return result;
        const std::size_t end = text.find(comment ? "-->" : "?>", at);
        if (end == std::string_view::npos || end > start) return result;
        at = end;
    }
    const std::size_t end = endOfDoctype(text, start);
    if (end == std::string_view::npos) return result;
    std::replace_if(
        result.begin() + static_cast<std::ptrdiff_t>(start), result.begin() + static_cast<std::ptrdiff_t>(end),
        [](char c) { return c != '\n'; }, ' ');
    return result;
}

}  // namespace radlab

#include "grader/protocol/PlainText.h"

namespace radlab::grader {

namespace {

constexpr char32_t replacement = 0xfffd;
constexpr const char* replacementBytes = "\xef\xbf\xbd";

bool isContinuation(char byte) { return (static_cast<unsigned char>(byte) & 0xc0) == 0x80; }

bool isControl(char32_t value) { return value < 0x20 || (value >= 0x7f && value < 0xa0); }

// Marks that reorder what follows, and line ends that are none to a terminal: a text can be made to read as another.
bool isDeceptive(char32_t value) {
    return value == 0x061c || value == 0x200e || value == 0x200f || (value >= 0x2028 && value <= 0x202e) ||
           (value >= 0x2066 && value <= 0x2069) || value == 0xfeff;
}

std::string spelledOut(char32_t value) {
    std::string text = value < 0x80 ? "\\x" : "\\u";
    for (int shift = value < 0x80 ? 4 : 12; shift >= 0; shift -= 4) text += "0123456789abcdef"[value >> shift & 15];
    return text;
}

// Calls use(character, its bytes) for each character of a text.
template <class Use>
void forEachCharacter(std::string_view text, Use use) {
    while (!text.empty()) {
        const Character character = firstCharacter(text);
        use(character, character.valid ? text.substr(0, character.length) : replacementBytes);
        text.remove_prefix(character.length);
    }
}

}  // namespace

Character firstCharacter(std::string_view bytes) {
    const auto lead = static_cast<unsigned char>(bytes.front());
    if (lead < 0x80) return {lead, 1, true};
    if (lead < 0xc2 || lead > 0xf4) return {replacement, 1, false};
    const std::size_t length = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : 2;
    // The bounds of the second byte keep out overlong forms, surrogates and what lies beyond U+10FFFF.
    unsigned lowest = lead == 0xe0 ? 0xa0 : lead == 0xf0 ? 0x90 : 0x80;
    unsigned highest = lead == 0xed ? 0x9f : lead == 0xf4 ? 0x8f : 0xbf;
    char32_t value = lead & (0x7fu >> length);
    for (std::size_t i = 1; i < length; ++i) {
        const unsigned byte = i < bytes.size() ? static_cast<unsigned char>(bytes[i]) : 0;
        if (byte < lowest || byte > highest) return {replacement, i, false};
        value = value << 6 | (byte & 0x3f);
        lowest = 0x80;
        highest = 0xbf;
    }
    return {value, length, true};
}

std::string validUtf8(std::string_view bytes) {
    std::string text;
    forEachCharacter(bytes, [&](const Character&, std::string_view shown) { text += shown; });
    return text;
}

std::string visibleText(std::string_view bytes) {
    std::string text;
    bool carriageReturn = false;  // held back until it is known not to begin a Windows end of line
    forEachCharacter(bytes, [&](const Character& character, std::string_view shown) {
        const char32_t value = character.value;
        if (carriageReturn && value != '\n') text += spelledOut('\r');
        carriageReturn = value == '\r';
        if (carriageReturn) return;
        const bool kept = value == '\n' || value == '\t' || !(isControl(value) || isDeceptive(value));
        text += kept ? std::string(shown) : spelledOut(value);
    });
    return carriageReturn ? text + spelledOut('\r') : text;
}

std::string xmlText(std::string_view bytes) {
    std::string text;
    forEachCharacter(bytes, [&](const Character& character, std::string_view shown) {
        const char32_t value = character.value;
        const bool forbidden = isControl(value) || value == 0xfffe || value == 0xffff;
        if (value == '\n' || value == '\t' || !forbidden) text += shown;
    });
    return text;
}

std::string_view startOf(std::string_view text, std::size_t bytes) {
    if (text.size() <= bytes) return text;
    // A character has at most three continuation bytes; more of them are no UTF-8 and may be cut anywhere.
    std::size_t end = bytes;
    for (int back = 0; back < 3 && end > 0 && isContinuation(text[end]); ++back) --end;
    return text.substr(0, isContinuation(text[end]) ? bytes : end);
}

}  // namespace radlab::grader

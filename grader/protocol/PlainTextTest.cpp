#include "grader/protocol/PlainText.h"

#include <random>

#include <doctest/doctest.h>

using namespace radlab::grader;
using namespace std::string_literals;

namespace {

std::string randomBytes(unsigned seed) {
    std::mt19937 random(seed);
    // Bytes that begin or continue long characters come often, so that all kinds of broken ones do.
    const std::string likely = "\xe0\xed\xf0\xf4\x80\x9f\xa0\xbf\xc2\x1b\na";
    std::string bytes;
    for (int i = 0; i < 200; ++i)
        bytes += random() % 2 ? likely[random() % likely.size()] : static_cast<char>(random());
    return bytes;
}

bool isValid(std::string_view text) {
    while (!text.empty()) {
        const Character character = firstCharacter(text);
        if (!character.valid) return false;
        text.remove_prefix(character.length);
    }
    return true;
}

}  // namespace

TEST_CASE("plain text: UTF-8 of one to four bytes is read and left as it is") {
    CHECK(firstCharacter("A").value == U'A');
    CHECK(firstCharacter("é").value == U'é');
    CHECK(firstCharacter("→").value == U'→');
    CHECK(firstCharacter("😀").value == U'😀');
    CHECK(firstCharacter("😀").length == 4);
    CHECK(firstCharacter("\xf4\x8f\xbf\xbf").value == 0x10ffff);
    const std::string text = "F(s→j) = ρ · 1/π, é, 漢字, 😀, \xed\x9f\xbf, \xee\x80\x80\n";
    CHECK(validUtf8(text) == text);
}

TEST_CASE("plain text: each maximal part that is not UTF-8 becomes one U+FFFD") {
    CHECK(validUtf8("a\xff"
                    "b") == "a\uFFFDb");
    CHECK(validUtf8("\x80\xbf") == "\uFFFD\uFFFD");
    CHECK(validUtf8("\xc0\xaf") == "\uFFFD\uFFFD");                      // overlong '/'
    CHECK(validUtf8("\xe0\x80\x80") == "\uFFFD\uFFFD\uFFFD");            // overlong NUL
    CHECK(validUtf8("\xed\xa0\x80") == "\uFFFD\uFFFD\uFFFD");            // a surrogate
    CHECK(validUtf8("\xf4\x90\x80\x80") == "\uFFFD\uFFFD\uFFFD\uFFFD");  // beyond U+10FFFF
    CHECK(validUtf8("\xf0\x9f\x98") == "\uFFFD");                        // cut off at the end
    CHECK(validUtf8("\xf0\x9f\x98z\xe2\x86\x92") == "\uFFFDz→");         // cut off in the middle
    CHECK(validUtf8("a\0b"s) == "a\0b"s);
}

TEST_CASE("plain text: no bytes whatsoever make a text that is not UTF-8") {
    for (unsigned seed = 0; seed < 300; ++seed) {
        CAPTURE(seed);
        const std::string bytes = randomBytes(seed);
        CHECK(isValid(validUtf8(bytes)));
        CHECK(isValid(visibleText(bytes)));
        CHECK(isValid(xmlText(bytes)));
        CHECK(validUtf8(validUtf8(bytes)) == validUtf8(bytes));
    }
}

TEST_CASE("visible text: what a terminal obeys is spelled out") {
    CHECK(visibleText("\x1b[2J") == "\\x1b[2J");
    CHECK(visibleText("a\0b\a\x7f"s) == "a\\x00b\\x07\\x7f");
    CHECK(visibleText("\u009b31m") == "\\u009b31m");
    CHECK(visibleText("score: 0\rscore: 100") == "score: 0\\x0dscore: 100");
    CHECK(visibleText("one\r\ntwo\n\tthree") == "one\ntwo\n\tthree");
    CHECK(visibleText("end\r") == "end\\x0d");
    CHECK(visibleText("\r\r\n") == "\\x0d\n");
}

TEST_CASE("visible text: what turns the reading direction round is spelled out, letters of any script are not") {
    CHECK(visibleText("\u202Egnorw") == "\\u202egnorw");
    CHECK(visibleText("\u2066x\u2069") == "\\u2066x\\u2069");
    CHECK(visibleText("שלום, 漢字, ρ ≤ 1") == "שלום, 漢字, ρ ≤ 1");
}

TEST_CASE("XML text: characters that XML 1.0 forbids are gone, newline and tab stay") {
    CHECK(xmlText("a\x1b[31m\0\x08 b\n\tc"s) == "a[31m b\n\tc");
    CHECK(xmlText("x\uFFFEy\uFFFFz\u0085") == "xyz");
    CHECK(xmlText("\xff→") == "\uFFFD→");
}

TEST_CASE("the start of a text never ends in the middle of a character") {
    CHECK(startOf("abc", 5) == "abc");
    CHECK(startOf("abc", 2) == "ab");
    CHECK(startOf("a→b", 1) == "a");
    CHECK(startOf("a→b", 2) == "a");
    CHECK(startOf("a→b", 3) == "a");
    CHECK(startOf("a→b", 4) == "a→");
    CHECK(startOf("\x80\x80\x80\x80\x80\x80", 5).size() == 5);
    CHECK(startOf("→", 0).empty());
}

#include "grader/report/TextLines.h"

#include <doctest/doctest.h>

using namespace radlab::grader;

using Lines = std::vector<std::string>;

TEST_CASE("columns: letters take one, East Asian characters and emoji take two") {
    CHECK(columnsOf("") == 0);
    CHECK(columnsOf("F(s→j) = ρ/π…") == 13);
    CHECK(columnsOf("漢字") == 4);
    CHECK(columnsOf("😀") == 2);
}

TEST_CASE("one line: no text makes more than one line or moves the cursor") {
    CHECK(oneLine("a\nb\tc\rd\x1b[A") == "a b c\\x0dd\\x1b[A");
}

TEST_CASE("cut: a text that fits stays, a longer one ends with …") {
    CHECK(cutLine("abcd", 4) == "abcd");
    CHECK(cutLine("abcde", 4) == "abc…");
    CHECK(cutLine("ééééé", 4) == "ééé…");
    CHECK(cutLine("漢字漢字", 5) == "漢字…");
    CHECK(cutLine("漢字漢字", 4) == "漢…");
    CHECK(cutLine("漢字漢字", 2) == "…");
}

TEST_CASE("wrap: lines end between words") {
    CHECK(wrapText("one two three four", 9) == Lines{"one two", "three", "four"});
    CHECK(wrapText("one two three", 13) == Lines{"one two three"});
    CHECK(wrapText("", 10).empty());
}

TEST_CASE("wrap: a word that is too long is broken, and no character with it") {
    CHECK(wrapText("ab cdefghijkl mn", 4) == Lines{"ab", "cdef", "ghij", "kl", "mn"});
    CHECK(wrapText("漢字漢字漢", 5) == Lines{"漢字", "漢字", "漢"});
}

TEST_CASE("wrap: a line that fits keeps its spaces, a broken one its indentation") {
    CHECK(wrapText("a  b\n    c", 10) == Lines{"a  b", "    c"});
    CHECK(wrapText("  one two three", 9) == Lines{"  one two", "  three"});
    CHECK(wrapText("\tx", 9) == Lines{"    x"});
    CHECK(wrapText("a\n\nb\n\n \n", 9) == Lines{"a", "", "b"});
}

TEST_CASE("wrap: no line is wider than asked, however odd the text") {
    const std::string odd =
        std::string(50, ' ') + "x\n" + std::string(30, ' ') + "\n漢 " + std::string(99, 'y') + "漢字漢字漢字";
    for (int columns : {4, 5, 7, 20}) {
        CAPTURE(columns);
        for (const std::string& line : wrapText(odd, columns)) CHECK(columnsOf(line) <= columns);
    }
}

TEST_CASE("limit: the last line says that more were left out") {
    Lines lines = {"one", "two", "three"};
    limitLines(lines, 3, 10);
    CHECK(lines.size() == 3);
    limitLines(lines, 2, 10);
    CHECK(lines == Lines{"one", "two …"});
    lines = {"abcdefghij", "x"};
    limitLines(lines, 1, 10);
    CHECK(lines == Lines{"abcdefghi…"});
    limitLines(lines, 0, 10);
    CHECK(lines.empty());
}

#include "grader/report/Gradebook.h"

#include <doctest/doctest.h>

using namespace radlab::grader;

TEST_CASE("numbers of a file: the sign that most use, and the most decimals") {
    CHECK(numberStyleOf({"100,00", "7,5"}, ',').point == ',');
    CHECK(numberStyleOf({"100.00", "7,5", "2.5"}, ';').point == '.');
    CHECK(numberStyleOf({"100", "x", ""}, ';').point == ',');
    CHECK(numberStyleOf({"100", "x", ""}, ',').point == '.');
    CHECK(numberStyleOf({"100.0", "7"}, ',').decimals == 1);
    CHECK(numberStyleOf({"100.00", "7.5"}, ',').decimals == 2);
    CHECK(numberStyleOf({"1,000", "1.2.3", "a.b", "0.12345"}, '\t').decimals == 0);
    CHECK(numberStyleOf({"1,000"}, ',').point == '.');
}

TEST_CASE("numbers of a file: as many decimals as the file has, and two where they are needed") {
    CHECK(numberText(85, {'.', 0}) == "85");
    CHECK(numberText(85, {',', 2}) == "85,00");
    CHECK(numberText(85.5, {',', 1}) == "85,5");
    CHECK(numberText(6.6667, {'.', 0}) == "6.67");
    CHECK(numberText(0, {'.', 1}) == "0.0");
    CHECK(numberText(100, {'.', 0}) == "100");
}

TEST_CASE("numbers of a file: read with point or comma, and nothing else") {
    CHECK(numberOf("100,50") == 100.5);
    CHECK(numberOf("7") == 7.0);
    CHECK(numberOf(".5") == 0.5);
    for (const char* text : {"", "-", "1,2,3", "EX", "1e5", ".", "-3", "nan"}) {
        CAPTURE(text);
        CHECK_FALSE(numberOf(text));
    }
}

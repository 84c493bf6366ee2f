#include "scene/Number.h"

#include <clocale>
#include <cmath>

#include <doctest/doctest.h>

using namespace radlab;

TEST_CASE("a number is read to the last place of a float") {
    CHECK(parseNumber("0.1") == 0.1);
    CHECK(parseNumber("-12.5e-1") == -1.25);
    CHECK(parseNumber("+3") == 3.0);
    CHECK(parseNumber(".5") == 0.5);
    CHECK(parseNumber("5.") == 5.0);
    CHECK(parseNumber("1E3") == 1000.0);
    CHECK(static_cast<float>(*parseNumber("3.4028234663852886e38")) == 3.4028234663852886e38f);
    CHECK(static_cast<float>(*parseNumber("1.17549435e-38")) == 1.17549435e-38f);
    CHECK(static_cast<float>(*parseNumber("0.333333333333333333333333333")) == 1.0f / 3.0f);
}

TEST_CASE("digits beyond what a number can hold still count for its size") {
    CHECK(*parseNumber("123456789012345678901234567890") == doctest::Approx(1.2345678901234568e29));
    CHECK(*parseNumber("0.00000000000000000000000000001") == doctest::Approx(1e-29));
    CHECK(*parseNumber("100000000000000000000000000000000000000000e-40") == doctest::Approx(10));
}

TEST_CASE("a number out of any range is infinite or zero and does not overflow the reader") {
    CHECK(std::isinf(*parseNumber("1e99999999999999999999")));
    CHECK(*parseNumber("1e-99999999999999999999") == 0.0);
    CHECK(*parseNumber("0e99999999999999999999") == 0.0);
}

TEST_CASE("what is only partly a number is none") {
    for (const char* text :
         {"", "-", ".", "e5", "1e", "1e+", "1.2.3", "1f", "0x10", "nan", "inf", "-inf", "1 ", "--1", "1,5"}) {
        CAPTURE(text);
        CHECK_FALSE(parseNumber(text));
    }
}

TEST_CASE("a number is read the same in a locale that writes a comma") {
    const std::string before = std::setlocale(LC_ALL, nullptr);
    // Not every machine has one: then the test says nothing, but passes.
    for (const char* name : {"de_DE.UTF-8", "de_DE", "German"}) std::setlocale(LC_ALL, name);
    CHECK(parseNumber("1.5") == 1.5);
    CHECK(numberText(1.5) == "1.5");
    std::setlocale(LC_ALL, before.c_str());
}

TEST_CASE("a whole number has no point, no exponent and fits an int") {
    CHECK(parseWhole("12") == 12);
    CHECK(parseWhole("+12") == 12);
    CHECK(parseWhole("-1") == -1);
    for (const char* text : {"", "+", "+-1", "1.0", "1e2", "2147483648", "0x1", "1a"}) {
        CAPTURE(text);
        CHECK_FALSE(parseWhole(text));
    }
}

TEST_CASE("a list is separated by white space and commas in any mix") {
    CHECK(splitList(" 1, 2,,3\n4\t5\r\n,") == std::vector<std::string_view>{"1", "2", "3", "4", "5"});
    CHECK(splitList(" ,\n").empty());
}

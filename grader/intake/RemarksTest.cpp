#include "grader/intake/Remarks.h"

#include <doctest/doctest.h>

using namespace radlab::grader;

TEST_CASE("a name is one line without control characters, and not long") {
    CHECK(shownName("a\nb\tc\x1b[2Jd\r") == "a\\x0ab\\x09c\\x1b[2Jd\\x0d");
    CHECK(shownName("\xe2\x80\xaegpj.exe") == "\\u202egpj.exe");
    CHECK(shownName("\xff") == "\xef\xbf\xbd");
    CHECK(shownName(std::string(5000, 'x')) == std::string(120, 'x') + "...");
    CHECK(shownNames({"a", "b\n"}, true) == "a, b\\x0a and more");
}

TEST_CASE("remarks beyond the limit are counted in one, and a refusal counts even then") {
    Remarks remarks(2);
    for (const char* text : {"one", "two", "three"}) remarks.note(text);
    CHECK_FALSE(remarks.refusedAny());
    remarks.refuse("four");
    CHECK(remarks.refusedAny());
    CHECK(remarks.lines() == std::vector<std::string>{"one", "two", "and 2 more such remarks"});
    Remarks all(3);
    all.add(remarks);
    CHECK(all.refusedAny());
    all.note("five");
    all.note("six");
    CHECK(all.lines() == std::vector<std::string>{"one", "two", "five", "and 3 more such remarks"});
}

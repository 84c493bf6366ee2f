#include "grader/intake/Choice.h"

#include <algorithm>

#include "grader/intake/IntakeTestHelp.h"

using namespace radlab;
using namespace radlab::grader;

namespace {

// The path that is chosen, in whatever order the files come; "" where there is none.
std::string chosen(std::vector<Candidate> files) {
    const auto byPath = [](const Candidate& a, const Candidate& b) { return a.path < b.path; };
    std::sort(files.begin(), files.end(), byPath);
    std::string first;
    bool begun = false;
    do {
        Choice choice(test::rules());
        Gathered gathered(test::rules());
        for (const Candidate& file : files)
            if (choice.wants(file.path)) choice.offer(file);
        choice.finish(gathered);
        const std::string path = gathered.files.empty() ? "" : gathered.files["ProgRef.cpp"].path;
        if (begun) CHECK(path == first);
        first = path;
        begun = true;
    } while (std::next_permutation(files.begin(), files.end(), byPath));
    return first;
}

}  // namespace

TEST_CASE("exercises/NAME comes first, then the NAME in the fewest folders") {
    CHECK(chosen({{"ProgRef.cpp", "a"}, {"exercises/ProgRef.cpp", "b"}, {"x/y/ProgRef.cpp", "c"}}) ==
          "exercises/ProgRef.cpp");
    CHECK(chosen({{"x/ProgRef.cpp", "a"}, {"x/exercises/ProgRef.cpp", "b"}}) == "x/ProgRef.cpp");
    CHECK(chosen({{"x/old/ProgRef.cpp", "a"}, {"x/exercises/ProgRef.cpp", "b"}}) == "x/exercises/ProgRef.cpp");
    CHECK(chosen({{"x/main.cpp", "a"}}) == "");
}

TEST_CASE("the exact name comes before one with a number, the highest number, then other cases") {
    CHECK(chosen({{"x/ProgRef.cpp", "a"}, {"ProgRef-1.cpp", "b"}, {"progref.cpp", "c"}}) == "x/ProgRef.cpp");
    CHECK(chosen({{"ProgRef-2.cpp", "a"}, {"ProgRef-10.cpp", "b"}, {"progref.cpp", "c"}}) == "ProgRef-10.cpp");
    CHECK(chosen({{"x/progref.cpp", "a"}, {"PROGREF.CPP", "b"}}) == "PROGREF.CPP");
}

TEST_CASE("two that come first alike are one if they are the same, and refused by name if not") {
    CHECK(chosen({{"a/ProgRef.cpp", "same"}, {"b/ProgRef.cpp", "same"}}) != "");
    Choice choice(test::rules());
    Gathered gathered(test::rules());
    choice.offer({"b/ProgRef.cpp", "one"});
    choice.offer({"a/ProgRef.cpp", "other"});
    CHECK_FALSE(choice.wants("c/ProgRef.cpp"));
    CHECK(choice.wants("ProgRef.cpp"));
    choice.finish(gathered);
    CHECK(gathered.files.empty());
    REQUIRE(gathered.remarks.refusedAny());
    CHECK(gathered.remarks.told()[0].text.find("b/ProgRef.cpp and a/ProgRef.cpp differ") == 0);
}

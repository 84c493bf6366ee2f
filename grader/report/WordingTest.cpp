#include "grader/report/Wording.h"

#include <limits>

#include <doctest/doctest.h>

#include "grader/report/SampleClass.h"

using namespace radlab::grader;
using namespace radlab::grader::test;

TEST_CASE("wording: marks have at most two decimals, and no more than they need") {
    CHECK(marksText(0) == "0");
    CHECK(marksText(20) == "20");
    CHECK(marksText(100) == "100");
    CHECK(marksText(7.5) == "7.5");
    CHECK(marksText(20.0 / 3.0) == "6.67");
    CHECK(marksText(-0.001) == "0");
    CHECK(marksText(1e300).size() < 10);
    CHECK(marksText(std::numeric_limits<double>::infinity()) == "inf");
}

TEST_CASE("wording: all is right only with all six functions, and all of them together") {
    CHECK(allRight(resultWith(Status::pass)));
    Result result = resultWith(Status::pass);
    result.stages[6].status = Status::fail;
    CHECK_FALSE(allRight(result));
    result = resultWith(Status::pass);
    result.stages.erase(result.stages.begin());
    CHECK_FALSE(allRight(result));
    CHECK_FALSE(allRight(Result()));
}

TEST_CASE("wording: something is started as soon as one function is judged") {
    CHECK(nothingStarted(resultWith(Status::notStarted)));
    CHECK_FALSE(nothingStarted(oneWrong()));
    CHECK_FALSE(nothingStarted(resultWith(Status::blocked)));
    CHECK_FALSE(nothingStarted(Result()));
}

TEST_CASE("wording: a diagnosis' hint goes before the check's own") {
    CheckResult check = tellingCheck();
    check.hint = "own";
    CHECK(hintOf(check) == check.diagnosis->hint);
    check.diagnosis->hint = "";
    CHECK(hintOf(check) == "own");
}

TEST_CASE("wording: the next step is first what fails, then what is not written") {
    Result result = oneWrong();
    CHECK(nextStep(result, true).front() ==
          "mend calcAnalyticalFF (stage 2) in exercises/ProgRef.cpp, then ./radlab check calcAnalyticalFF");
    result.stages[1].status = Status::pass;
    CHECK(nextStep(result, true).front() == "write calcFF (stage 6) in exercises/ProgRef.cpp, then ./radlab check");
    result.submission = "a\nb\x1b/c.cpp";
    CHECK(nextStep(result, true).front() == "write calcFF (stage 6) in a b\\x1b/c.cpp, then ./radlab check");
}

TEST_CASE("wording: a student without a mark is never called graded") {
    const std::vector<StudentResult> students = smallClass();
    const std::pair<std::string, bool> expected[] = {
        {"graded", true},   {"graded", true},         {"nothing handed in", false},
        {"refused", false}, {"grader failed", false}, {"does not compile", true}};
    for (std::size_t i = 0; i < students.size(); ++i) {
        CAPTURE(i);
        CHECK(outcomeWord(students[i]) == expected[i].first);
        CHECK(hasMark(students[i]) == expected[i].second);
    }
    const StudentResult failed = graded("student-07", resultWith(Status::error));
    CHECK(outcomeWord(failed) == "grader failed");
    CHECK_FALSE(hasMark(failed));
}

TEST_CASE("wording: times are shown to the minute, and other texts safely as they are") {
    CHECK(timeText("2026-11-23T08:15:59Z") == "2026-11-23 08:15 UTC");
    CHECK(timeText("yesterday") == "yesterday");
    CHECK(timeText("2026-11-23T08:15:\x1bZ\n") == "2026-11-23T08:15:\\x1bZ ");
    CHECK(timeText("").empty());
}

TEST_CASE("wording: what does not compile is said, and what to do next") {
    CHECK(verdictText(notCompiled()) == "It does not compile.");
    CHECK(nextStep(notCompiled(), true).front() == "correct the compiler's first error, then ./radlab check");
}

TEST_CASE("wording: a list is one line of safe texts") {
    CHECK(listText({}).empty());
    CHECK(listText({"a", "b\x1b", "c\nd"}) == "a, b\\x1b, c d");
    CHECK(listText({"a", "b"}, "; ") == "a; b");
}

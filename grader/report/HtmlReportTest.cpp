#include "grader/report/HtmlReport.h"

#include <doctest/doctest.h>

#include "base/Error.h"
#include "base/ImageFile.h"
#include "base/TestFolder.h"
#include "base/WholeFile.h"
#include "grader/protocol/PlainText.h"
#include "grader/report/PageTestHelp.h"
#include "grader/report/SampleResult.h"

using namespace radlab::grader;
using namespace radlab::grader::test;
using radlab::Image;
using radlab::test::Folder;

namespace {

Picture picture() { return {"a room", Image(4, 3), Image(4, 3, glm::vec3(1)), Image(4, 3), 0.03125, 0.01}; }

#ifdef RADLAB_HAVE_STB
constexpr bool canHoldPictures = true;
#else
constexpr bool canHoldPictures = false;
#endif

}  // namespace

TEST_CASE("page: shows the verdict, each stage and each check with what was found") {
    const std::string page = verdictPage(oneWrong());
    CHECK(contains(page, "<h1>4 of 6 functions are right.</h1>"));
    CHECK(contains(page, "Next: mend calcAnalyticalFF (stage 2) in exercises/ProgRef.cpp, then"));
    CHECK(countOf(page, "<section ") == 7);
    CHECK(countOf(page, "<article ") == 5);
    CHECK(contains(page, "unit squares that face each other at distance 2."));
    CHECK(contains(page, "the factor 1/π of the formula is missing"));
    CHECK(contains(page, "<summary>Where to look</summary>"));
    CHECK(contains(page, "<pre>Scene room = facingSquares(2.0f);\npublish(room);\n"));
    CHECK(contains(page, "<summary>What it printed</summary><pre>debug: cos = 1.000000\ndebug: F = 0.25\n</pre>"));
}

TEST_CASE("page: what a check has not is not shown, not even as an empty heading") {
    Result result = oneWrong();
    result.stages[1].checks = {check("x", "bare", Status::fail, 0)};
    const std::string page = verdictPage(result);
    for (const char* text :
         {"What is wrong", "Where to look", "What it printed", "as C++", "<figure>", "<p class=\"said\">"}) {
        CAPTURE(text);
        CHECK_FALSE(contains(page, text));
    }
}

TEST_CASE("page: each state of things has its verdict") {
    CHECK(contains(verdictPage(resultWith(Status::pass)), "<h1>All functions are right.</h1>"));
    CHECK(
        contains(verdictPage(resultWith(Status::notStarted)), "<h1>Nothing is written yet, so nothing is wrong.</h1>"));
    CHECK(contains(verdictPage(resultWith(Status::error)), "<h1>The grader or the machine failed."));
    CHECK(contains(verdictPage(resultWith(Status::error)), "marks, not final"));
    Result one = resultWith(Status::pass);
    one.stages.resize(1);
    CHECK(contains(verdictPage(one), "<h1>1 of 1 function is right.</h1>"));
    CHECK(contains(verdictPage(Result()), "<h1>0 of 0 functions are right.</h1>"));
}

TEST_CASE("page: stages and checks that nobody asked for are left out") {
    Result result = oneWrong();
    result.stages[0].status = Status::skipped;
    result.stages[1].checks[4].status = Status::skipped;
    CHECK(countOf(verdictPage(result), "<section ") == 6);
    CHECK(countOf(verdictPage(result), "<article ") == 4);
}

TEST_CASE("page: texts of a submission are text, never markup, template or control") {
    const std::string page = verdictPage(withTexts(oneWrong(), hostileText()));
    CHECK_FALSE(contains(page, "<script"));
    CHECK_FALSE(contains(page, "<img"));
    CHECK_FALSE(contains(page, "\x1b"));
    CHECK_FALSE(contains(page, "\u202E"));
    CHECK(contains(page, "{{score}}{{{next}}}"));
    CHECK(contains(page, "&lt;script&gt;alert(1)"));
    CHECK(contains(page, "]]&gt;&amp;amp;"));
    CHECK(validUtf8(page) == page);
}

TEST_CASE("page: a very long output is cut, and the page says so") {
    Result result = oneWrong();
    result.stages[1].checks[1].output = std::string(10 << 20, '\x1b');
    const std::string page = verdictPage(result);
    CHECK(page.size() < 400000);
    CHECK(contains(page, "… and 10420224 bytes more"));
}

TEST_CASE("page: nothing comes from elsewhere and no script runs") {
    const std::string page = verdictPage(oneWrong());
    for (const char* text : {"http://", "https://", "<script", "@import", "<link"}) {
        CAPTURE(text);
        CHECK_FALSE(contains(page, text));
    }
}

TEST_CASE("page: pictures are written beside it and shown with their difference" * doctest::skip(!canHoldPictures)) {
    const Folder folder;
    Result result = oneWrong();
    result.stages[1].checks[1].picture = picture();
    const std::string page = radlab::readFile(writeHtmlReport(result, folder / "report"));
    CHECK(countOf(page, "<figure>") == 3);
    CHECK(contains(page, "a room: RMS difference 0.0312, at most 0.01 passes."));
    const std::string start = "report/1-calcanalyticalff-ff-facing-";
    for (const char* what : {"reference", "yours", "difference"}) {
        CAPTURE(what);
        CHECK(contains(page, "src=\"1-calcanalyticalff-ff-facing-" + std::string(what) + ".png\""));
        CHECK(radlab::readImage(folder / (start + what + ".png")).width() == 4);
    }
}

TEST_CASE("page: no id whatsoever makes a file outside the folder" * doctest::skip(!canHoldPictures)) {
    const Folder folder;
    Result result = oneWrong();
    CheckResult& check = result.stages[1].checks[1];
    check.picture = picture();
    check.id = "../../\0é\n<x>" + std::string(5000, '/');
    result.stages[1].stage = "../..";
    result.stages[1].checks.push_back(check);
    const std::string page = radlab::readFile(writeHtmlReport(result, folder / "a/b"));
    CHECK(countOf(page, "<figure>") == 6);
    CHECK(folder.entries() == 1);
    CHECK(std::distance(std::filesystem::directory_iterator(folder / "a"), {}) == 1);
    CHECK(std::distance(std::filesystem::directory_iterator(folder / "a/b"), {}) == 7);
}

TEST_CASE("page: a picture that cannot be written leaves no page behind" * doctest::skip(!canHoldPictures)) {
    const Folder folder;
    Result result = oneWrong();
    result.stages[1].checks[1].picture = picture();
    std::filesystem::create_directories(folder / "report/1-calcanalyticalff-ff-facing-yours.png/x");
    CHECK_THROWS_AS(writeHtmlReport(result, folder / "report"), radlab::Error);
    CHECK_FALSE(std::filesystem::exists(folder / "report/index.html"));
}

TEST_CASE("page: a folder that cannot be made is an error that names it") {
    const Folder folder;
    radlab::writeFile(folder / "file", "x");
    CHECK_THROWS_AS(writeHtmlReport(oneWrong(), folder / "file"), radlab::Error);
}

#include "grader/report/ClassPage.h"

#include <doctest/doctest.h>

#include "grader/protocol/PlainText.h"
#include "grader/report/Digest.h"
#include "grader/report/PageTestHelp.h"
#include "grader/report/SampleClass.h"

#if __has_include(<sodium.h>)

using namespace radlab::grader;
using namespace radlab::grader::test;

namespace {

ClassInfo info() { return {"Radiosity", "2026-11-23T09:20:00Z", "0.1.0", {"seccomp"}, {"marks.csv"}}; }

std::string pageOf(const std::vector<StudentResult>& students) { return classPage(info(), students); }

}  // namespace

TEST_CASE("class page: shows the figures of the class, and only those that there are") {
    const std::string page = pageOf(smallClass());
    CHECK(contains(page, "<b>6</b><span>students</span>"));
    CHECK(contains(page, "<a href=\"#status=uncompiled\"><b>1</b><span>does not compile</span></a>"));
    CHECK(contains(page, "<b>56</b><span>mean of 100</span>"));
    CHECK(contains(page, "<b>68</b><span>median</span>"));
    CHECK(contains(page, "Graded 2026-11-23 09:20 UTC"));
    CHECK(contains(page, "<a href=\"marks.csv\">marks.csv</a>"));
    CHECK(contains(page, "kept in a box by: seccomp."));
    std::vector<StudentResult> good = smallClass();
    good.resize(1);
    const std::string small = pageOf(good);
    CHECK(contains(small, "<b>1</b><span>student</span>"));
    for (const char* word : {"<span>late", "<span>refused", "Needs a look", "Common mistakes"}) {
        CAPTURE(word);
        CHECK_FALSE(contains(small, word));
    }
}

TEST_CASE("class page: a histogram of all marks and of each stage, with its checks") {
    const std::string page = pageOf(smallClass());
    CHECK(countOf(page, "<svg ") == 7);
    CHECK(contains(page, "aria-label=\"Marks in calcAnalyticalFF\""));
    CHECK(contains(page, "mean 14 of 20 ·"));
    CHECK(contains(page, "<span>the brightest patch is returned</span> <span title=\"1 of 1\">100 %</span>"));
}

TEST_CASE("class page: each student has a row with marks, status and a link to the page") {
    const std::string page = pageOf(smallClass());
    CHECK(countOf(page, "<tr data-status=") == 6);
    CHECK(contains(page, "<a href=\"students/student-02.html\">student-02</a>"));
    CHECK(contains(page, "<td class=\"number full\">10</td><td class=\"number part\">8</td>"));
    CHECK(contains(page, "<td class=\"number total\">68</td>"));
    CHECK(contains(page, "<span class=\"chip graded\">graded</span> <span class=\"chip late\">late</span>"));
    CHECK(contains(page, "<td class=\"number total\"></td><td><span class=\"chip error\">grader failed</span>"));
    CHECK(
        contains(page, "<td class=\"number total\">0</td><td><span class=\"chip uncompiled\">does not compile</span>"));
}

TEST_CASE("class page: common mistakes name who made them, and who needs a look is listed with the reason") {
    const std::string page = pageOf(smallClass());
    CHECK(contains(page, "<a href=\"#q=missing-inverse-pi\">missing-inverse-pi</a>"));
    CHECK(contains(page, "the factor 1/π of the formula is missing"));
    CHECK(contains(page, "../ProgRef.cpp: a name that leads out of the folder"));
    CHECK(contains(page, "the worker did not start"));
}

TEST_CASE("class page: rare mistakes are folded up below the eight most common") {
    std::vector<StudentResult> students;
    for (int i = 10; i < 21; ++i) {
        students.push_back(graded("student-" + std::to_string(i), oneWrong()));
        students.back().result.stages[1].checks[1].diagnosis->id = "mistake-" + std::to_string(i);
    }
    const std::string page = pageOf(students);
    CHECK(contains(page, "<summary>3 more</summary>"));
    CHECK(countOf(page, "<summary>Who</summary>") == 11);
}

TEST_CASE("class page: the only script is the one whose hash the page names") {
    const std::string page = pageOf(classSaying(hostileText()));
    CHECK(countOf(page, "<script") == 1);
    const std::size_t begin = page.find("<script>") + 8, end = page.find("</script>");
    CHECK(contains(page, "script-src 'sha256-" + sha256Base64(page.substr(begin, end - begin)) + "'"));
    CHECK(contains(page, "default-src 'none';"));
}

TEST_CASE("class page: names and reasons are text, never markup, template or control") {
    const std::string page = pageOf(classSaying(hostileText()));
    CHECK_FALSE(contains(page, "<img"));
    CHECK_FALSE(contains(page, "alert(1)</script>"));
    CHECK_FALSE(contains(page, "\x1b"));
    CHECK_FALSE(contains(page, "\u202E"));
    CHECK(contains(page, "&lt;script&gt;alert(1)"));
    CHECK(contains(page, "{{score}}{{{next}}}"));
    CHECK(validUtf8(page) == page);
    ClassInfo hostile = info();
    hostile.title = hostile.graded = hostile.version = hostileText();
    hostile.protections = hostile.files = {hostileText()};
    CHECK(countOf(classPage(hostile, {}), "<script") == 1);
    CHECK(countOf(classPage(hostile, {}), "<img") == 0);
}

TEST_CASE("class page: a thousand students make a page of at most a megabyte") {
    const std::string page = pageOf(largeClass(1000));
    CHECK(page.size() < 1 << 20);
    CHECK(countOf(page, "<tr data-status=") == 1000);
    CHECK(contains(page, "<b>1000</b><span>students</span>"));
}

TEST_CASE("class page: a class of nobody is a page, too") {
    const std::string page = pageOf({});
    CHECK(contains(page, "<b>0</b><span>students</span>"));
    CHECK_FALSE(contains(page, "<svg"));
}

#endif

#include "grader/report/StudentPage.h"

#include <doctest/doctest.h>

#include "grader/protocol/PlainText.h"
#include "grader/report/PageTestHelp.h"
#include "grader/report/SampleClass.h"

#if __has_include(<sodium.h>)

using namespace radlab::grader;
using namespace radlab::grader::test;

namespace {

CheckPicture pictureOf(const std::string& stage, const std::string& check) {
    CheckPicture picture{stage, check, "a room", 0.03125, 0.01, {}};
    for (const char* title : {"reference", "yours", "difference"})
        picture.images.push_back({title, std::string("png of ") + title, 4, 3});
    return picture;
}

}  // namespace

TEST_CASE("student page: shows who, when, the mark and what every page of a result shows") {
    StudentResult student = graded("student-02", oneWrong());
    student.student.name = "Student Two";
    student.student.late = true;
    const std::string page = studentPage(student, {});
    CHECK(contains(page, "<title>Student Two: 68 of 100 marks</title>"));
    CHECK(contains(page, "<h1>Student Two</h1>"));
    CHECK(contains(page, "student-02 · handed in 2026-11-20 17:04 UTC · graded 2026-11-23 09:12 UTC"));
    CHECK(contains(page, ">late</span>"));
    CHECK(contains(page, "<h2>4 of 6 functions are right.</h2>"));
    CHECK(countOf(page, "<article ") == 5);
    CHECK(contains(page, "the factor 1/π of the formula is missing"));
}

TEST_CASE("student page: links back to the class, or to nowhere") {
    const StudentResult student = graded("student-01", oneWrong());
    CHECK(contains(studentPage(student, {}), "<a href=\"../index.html\">"));
    const std::string alone = studentPage(student, {}, {""});
    CHECK_FALSE(contains(alone, "All students"));
    CHECK_FALSE(contains(alone, "index.html"));
}

TEST_CASE("student page: where nothing was graded, it says why and shows no mark") {
    const std::vector<StudentResult> students = smallClass();
    const std::string nothing = studentPage(students[2], {}), refused = studentPage(students[3], {}),
                      error = studentPage(students[4], {});
    CHECK(contains(nothing, "<h2>Nothing was handed in.</h2>"));
    CHECK(contains(refused, "<h2>What was handed in was refused.</h2>"));
    CHECK(contains(refused, "<li class=\"said\">../ProgRef.cpp: a name that leads out of the folder</li>"));
    CHECK(contains(error, "<h2>The grader or the machine failed.</h2>"));
    CHECK(contains(error, "there is no mark for it"));
    CHECK_FALSE(contains(error, "the worker did not start"));
    for (const std::string& page : {nothing, refused, error}) {
        CHECK_FALSE(contains(page, "class=\"score\""));
        CHECK_FALSE(contains(page, "<table>"));
        CHECK(contains(page, "no mark</title>"));
    }
}

TEST_CASE("student page: what does not compile shows what the compiler said, a warning stays folded up") {
    const std::string page = studentPage(graded("student-06", notCompiled()), {});
    CHECK(contains(page, "<h2>It does not compile.</h2>"));
    CHECK(contains(page, "Next: correct the compiler&apos;s first error, then ./radlab check."));
    CHECK(contains(page, "0 <small>of 100 marks</small>"));
    CHECK(contains(page, "error: &apos;shooterr&apos; was not declared"));
    CHECK_FALSE(contains(page, "<details><summary>What the compiler said"));
    Result warned = oneWrong();
    warned.compiler = "warning: unused";
    CHECK(contains(studentPage(graded("student-02", warned), {}), "<details><summary>What the compiler said"));
    CHECK_FALSE(contains(studentPage(graded("student-02", oneWrong()), {}), "What the compiler said"));
}

TEST_CASE("student page: earlier marks stand below the new one, newest first") {
    StudentResult student = graded("student-02", oneWrong());
    CHECK_FALSE(contains(studentPage(student, {}), "Marks so far"));
    student.earlier = {{47.6, 100, "2026-11-16T09:00:00Z", "2026-11-14T10:00:00Z", "0.1.0", 1},
                       {13, 100, "2026-11-09T09:00:00Z", "", "0.1.0", 1}};
    const std::string page = studentPage(student, {});
    CHECK(page.find("<b>68/100</b>") < page.find("47.6/100"));
    CHECK(page.find("47.6/100") < page.find("13/100"));
    CHECK(contains(page, "<td>2026-11-16 09:00 UTC</td><td>2026-11-14 10:00 UTC</td>"));
    student.outcome = Outcome::error;
    CHECK_FALSE(contains(studentPage(student, {}), "<b>68/100</b>"));
}

TEST_CASE("student page: pictures are in the page, all three of a check that is wrong, its own of one that is right") {
    const StudentResult student = graded("student-02", oneWrong());
    const std::vector<CheckPicture> pictures = {pictureOf("calcAnalyticalFF", "ff.facing"),
                                                pictureOf("calcAnalyticalFF", "ff.shooter"),
                                                pictureOf("another", "ff.facing")};
    const std::string page = studentPage(student, pictures);
    CHECK(countOf(page, "<figure>") == 4);
    CHECK(countOf(page, "src=\"data:image/png;base64,cG5nIG9mIHlvdXJz\"") == 2);
    CHECK(countOf(page, "src=\"data:image/png;base64,cG5nIG9mIHJlZmVyZW5jZQ==\"") == 1);
    CHECK(contains(page, "a room: RMS difference 0.0312, at most 0.01 passes."));
    CHECK(contains(page, "img-src data:;"));
}

TEST_CASE("student page: texts of a submission are text, never markup, template or control") {
    for (const StudentResult& student : classSaying(hostileText())) {
        CAPTURE(student.student.id);
        const std::string page = studentPage(student, {});
        CHECK_FALSE(contains(page, "<script"));
        CHECK_FALSE(contains(page, "<img"));
        CHECK_FALSE(contains(page, "\x1b"));
        CHECK_FALSE(contains(page, "\u202E"));
        CHECK(contains(page, "&lt;script&gt;alert(1)"));
        CHECK(contains(page, "{{score}}{{{next}}}"));
        CHECK(validUtf8(page) == page);
    }
}

TEST_CASE("student page: nothing comes from elsewhere and no script may run") {
    const std::string page = studentPage(graded("student-02", oneWrong()), {});
    CHECK(contains(page, "content=\"default-src &apos;none&apos;;") == false);
    CHECK(contains(page, "content=\"default-src 'none'; style-src 'unsafe-inline'; img-src data:; base-uri 'none'"));
    for (const char* text : {"http://", "https://", "<script", "@import", "<link"}) {
        CAPTURE(text);
        CHECK_FALSE(contains(page, text));
    }
}

TEST_CASE("student page: its file is named by the id, which names no other folder") {
    Student student;
    student.id = "student-07_a.b";
    CHECK(studentPageFile(student) == "students/student-07_a.b.html");
    for (const char* id : {"../x", "a/b", "a b", "a\\b", "é", "a\"b"}) {
        student.id = id;
        CHECK_THROWS_AS(studentPageFile(student), std::logic_error);
    }
}

#endif

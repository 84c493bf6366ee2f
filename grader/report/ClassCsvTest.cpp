#include "grader/report/ClassCsv.h"

#include <algorithm>

#include <doctest/doctest.h>

#include "grader/report/CsvFile.h"
#include "grader/report/SampleClass.h"

using namespace radlab::grader;
using namespace radlab::grader::test;

namespace {

// A table as a reader sees it.
struct Table {
    explicit Table(const std::string& text) : file(text, "table.csv") {}

    std::string value(std::size_t row, const std::string& title) const {
        for (std::size_t column = 0; column < file.columns(0); ++column)
            if (file.cell(0, column) == title) return file.cell(row, column);
        FAIL("no column " << title);
        return "";
    }

    CsvFile file;
};

}  // namespace

TEST_CASE("marks.csv: a row a student, with a mark only where there is one") {
    std::vector<StudentResult> students = smallClass();
    students[1].earlier = {{40, 100, "2026-11-16T09:00:00Z", "", "0.1.0", 7}};
    const Table table(marksCsv(students));
    REQUIRE(table.file.rows() == 7);
    CHECK(table.value(1, "id") == "student-01");
    CHECK(table.value(2, "total") == "68");
    CHECK(table.value(2, "max_total") == "100");
    CHECK(table.value(2, "calcAnalyticalFF") == "8");
    CHECK(table.value(2, "late") == "late");
    CHECK(table.value(2, "seed") == "42");
    CHECK(table.value(2, "graded") == "2026-11-23T09:12:00Z");
    CHECK(table.value(2, "earlier_total") == "40");
    CHECK(table.value(2, "earlier_seed") == "7");
    CHECK(table.value(3, "outcome") == "nothing handed in");
    CHECK(table.value(6, "outcome") == "does not compile");
    CHECK(table.value(6, "total") == "0");
    for (const std::size_t row : {3, 4, 5}) CHECK(table.value(row, "total").empty());
    for (std::size_t row = 0; row < 7; ++row) CHECK(table.file.columns(row) == table.file.columns(0));
}

TEST_CASE("checks.csv: a row a student and check, with the mistake") {
    const Table table(checksCsv(smallClass()));
    REQUIRE(table.file.rows() == 6);
    CHECK(table.value(2, "id") == "student-02");
    CHECK(table.value(2, "check") == "ff.facing");
    CHECK(table.value(2, "status") == "fail");
    CHECK(table.value(2, "marks") == "0");
    CHECK(table.value(2, "max_marks") == "4");
    CHECK(table.value(2, "mistake") == "missing-inverse-pi");
    CHECK(table.value(1, "mistake").empty());
}

TEST_CASE("tables: both begin with a byte order mark and end their lines with CR LF") {
    for (const std::string& text : {marksCsv(smallClass()), checksCsv(smallClass())}) {
        CHECK(text.rfind("\xef\xbb\xbfid,", 0) == 0);
        CHECK(std::count(text.begin(), text.end(), '\n') == std::count(text.begin(), text.end(), '\r'));
    }
}

TEST_CASE("tables: no name becomes a formula, a row of its own or a control character") {
    std::vector<StudentResult> students = smallClass();
    students[0].student.name = "=HYPERLINK(\"http://x\",\"y\")";
    students[1].student.name = "a\r\nstudent-09,100;=1+1";
    students[2].student.name = hostileText();
    const std::string text = marksCsv(students);
    const Table table(text);
    REQUIRE(table.file.rows() == 7);
    CHECK(table.value(1, "name") == "'=HYPERLINK(\"http://x\",\"y\")");
    CHECK(table.value(2, "name") == "a student-09,100;'=1+1");
    CHECK(text.find('\x1b') == std::string::npos);
    CHECK(table.value(3, "outcome") == "nothing handed in");
}

TEST_CASE("tables: a thousand students are a thousand rows") {
    CHECK(Table(marksCsv(largeClass(1000))).file.rows() == 1001);
}

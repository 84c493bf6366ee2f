#include "grader/report/Canvas.h"

#include <doctest/doctest.h>

#include "base/Error.h"
#include "grader/report/PageTestHelp.h"
#include "grader/report/SampleClass.h"

using namespace radlab::grader;
using namespace radlab::grader::test;

namespace {

const std::string header =
    "Student,ID,SIS User ID,SIS Login ID,Section,Radiosity (4711),Essay (4712),Assignments Current Score,Final Grade "
    "(2)\n";
const std::string points = "    Points Possible,,,,,100.00,10.00,(read only),(read only)\n";

// Canvas' file of the small class: students 1 to 6 have the IDs 71 to 76.
std::string gradebook() {
    return header + ",,,,,Manual Posting,,,\n" + points +
           "\"One, Student\",71,S1,one,Section A,,5.00,55.5,\n"
           "\"Two, Student\",72,S2,two,Section A,12.00,,,\n"
           "\"Three, Student\",73,S3,three,Section A,3.00,,,\n"
           "\"Four, Student\",74,S4,four,Section A,,,,\n"
           "\"Five, Student\",75,S5,five,Section A,50.00,,,\n"
           "\"Six, Student\",76,S6,six,Section A,,,,\n"
           "\"Student, Test\",99,,,Section A,,,,\n";
}

std::vector<StudentResult> students() {
    std::vector<StudentResult> all = smallClass();
    for (std::size_t i = 0; i < all.size(); ++i) all[i].student.account = "7" + std::to_string(i + 1);
    return all;
}

FillOptions assignment(const std::string& wanted) {
    FillOptions options;
    options.file = "gradebook.csv";
    options.assignment = wanted;
    return options;
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
        text.replace(at, from.size(), to);
    return text;
}

std::string faultOf(const std::string& text, const std::string& wanted) {
    try {
        filledCanvas(text, students(), assignment(wanted));
    } catch (const radlab::Error& error) {
        return error.what();
    }
    return "";
}

bool notes(const FilledGradebook& filled, const std::string& part) {
    for (const std::string& note : filled.notes)
        if (contains(note, part)) return true;
    return false;
}

}  // namespace

TEST_CASE("Canvas: the marks stand in their column, and every other byte is as it was") {
    const FilledGradebook filled = filledCanvas(gradebook(), students(), assignment("4711"));
    std::string expected = replaced(gradebook(), "one,Section A,,", "one,Section A,100.00,");
    expected = replaced(expected, "two,Section A,12.00,", "two,Section A,68.00,");
    expected = replaced(expected, "six,Section A,,", "six,Section A,0.00,");
    CHECK(filled.text == expected);
    CHECK(filled.filled == 3);
    CHECK(filled.unmatchedStudents.empty());
    CHECK(filled.unmatchedRows == std::vector<std::string>{"Student, Test"});
    CHECK_FALSE(notes(filled, "scaled"));
}

TEST_CASE("Canvas: who has no mark leaves the cell as it was, and the notes say so") {
    const FilledGradebook filled = filledCanvas(gradebook(), students(), assignment("4711"));
    CHECK(notes(filled, "no mark: nothing handed in: student-03"));
    CHECK(notes(filled, "no mark: refused: student-04"));
    CHECK(notes(filled, "no mark: grader failed: student-05"));
    FillOptions zero = assignment("4711");
    zero.zeroForNothing = true;
    const FilledGradebook zeroes = filledCanvas(gradebook(), students(), zero);
    CHECK(contains(zeroes.text, "three,Section A,0.00,"));
    CHECK(contains(zeroes.text, "four,Section A,,"));
    CHECK(contains(zeroes.text, "five,Section A,50.00,"));
}

TEST_CASE("Canvas: CR LF, a byte order mark, semicolons, decimal commas and quotes are kept") {
    std::string text = replaced(replaced(gradebook(), ",", ";"), "\n", "\r\n");
    text = "\xef\xbb\xbf" + replaced(replaced(text, ".00", ",00"), "two;Section A;12,00", "two;Section A;\"12,00\"");
    const FilledGradebook filled = filledCanvas(text, students(), assignment("4711"));
    std::string expected = replaced(text, "one;Section A;;", "one;Section A;100,00;");
    expected = replaced(expected, "two;Section A;\"12,00\"", "two;Section A;\"68,00\"");
    expected = replaced(expected, "six;Section A;;", "six;Section A;0,00;");
    CHECK(filled.text == expected);
}

TEST_CASE("Canvas: decimal commas in a file of commas are quoted") {
    const std::string text =
        "Student,ID,SIS Login ID,Section,Radiosity (1)\nPoints Possible,,,,\"100,00\"\nOne,71,one,A,\nTwo,72,two,A,3\n";
    const FilledGradebook filled = filledCanvas(text, students(), assignment(""));
    CHECK(contains(filled.text, "One,71,one,A,\"100,00\"\nTwo,72,two,A,\"68,00\"\n"));
}

TEST_CASE("Canvas: marks are scaled to what full marks are worth, which stays as it is") {
    const FilledGradebook filled = filledCanvas(gradebook(), students(), assignment("Essay"));
    CHECK(contains(filled.text, "one,Section A,,10.00,55.5"));
    CHECK(contains(filled.text, "two,Section A,12.00,6.80,"));
    CHECK(contains(filled.text, points));
    CHECK(notes(filled, "marks were scaled: 100 of radlab are worth 10 in this file"));
    const std::string unknown = replaced(gradebook(), ",10.00,(read", ",,(read");
    CHECK(notes(filledCanvas(unknown, students(), assignment("Essay")), "marks were not scaled"));
    CHECK(contains(filledCanvas(unknown, students(), assignment("Essay")).text, "two,Section A,12.00,68.00,"));
}

TEST_CASE("Canvas: no student's name makes a row that says what full marks are worth") {
    const std::string text = gradebook() + "Points Possible,77,,,Section A,1.00,,,\n";
    const FilledGradebook filled = filledCanvas(text, students(), assignment("4711"));
    CHECK(contains(filled.text, "two,Section A,68.00,"));
    CHECK(filled.unmatchedRows == std::vector<std::string>{"Student, Test", "Points Possible"});
}

TEST_CASE("Canvas: excused, not assigned and read-only cells stay as they are") {
    std::string text = replaced(gradebook(), "one,Section A,,", "one,Section A,EX,");
    text = replaced(text, "two,Section A,12.00,", "two,Section A,N/A,");
    text = replaced(text, "six,Section A,,", "six,Section A,(read only),");
    const FilledGradebook filled = filledCanvas(text, students(), assignment("4711"));
    CHECK(filled.text == text);
    CHECK(filled.filled == 0);
    CHECK(notes(filled, "excused: student-01"));
    CHECK(notes(filled, "not assigned to the student: student-02"));
    CHECK(notes(filled, "read only: student-06"));
}

TEST_CASE("Canvas: the only assignment needs no name, several need one, and an error lists them") {
    const std::string only = replaced(replaced(gradebook(), "Essay (4712)", "Notes"), "10.00,(read", ",(read");
    CHECK(filledCanvas(only, students(), assignment("")).filled == 3);
    for (const char* wanted : {"4711", "Radiosity", "Radiosity (4711)", "radio"})
        CHECK(filledCanvas(gradebook(), students(), assignment(wanted)).filled == 3);
    CHECK(contains(faultOf(gradebook(), ""),
                   "gradebook.csv:1: several assignments fit: found 'Radiosity' (4711), 'Essay' (4712), expected"));
    CHECK(
        contains(faultOf(gradebook(), "Quiz"), "no assignment fits 'Quiz': found 'Radiosity' (4711), 'Essay' (4712)"));
    CHECK(contains(faultOf(gradebook(), "Final Grade"), "no assignment fits"));
    const std::string none = replaced(replaced(gradebook(), "(4711)", ""), "(4712)", "");
    CHECK(contains(faultOf(none, ""), "holds no assignment: found the titles 'Radiosity ', 'Essay '"));
}

TEST_CASE("Canvas: a title that is exactly the one asked for comes before those that hold it") {
    const std::string text = replaced(gradebook(), "Essay (4712)", "Radiosity 2 (4712)");
    CHECK(contains(filledCanvas(text, students(), assignment("Radiosity")).text, "two,Section A,68.00,,"));
    CHECK(contains(faultOf(text, "radio"), "several assignments fit 'radio'"));
}

TEST_CASE("Canvas: students are found by login, too, and by a name that only one has") {
    std::vector<StudentResult> all = students();
    const char* logins[] = {"one", "two", "three", "four", "five", "six"};
    for (std::size_t i = 0; i < all.size(); ++i) all[i].student.account = logins[i];
    CHECK(filledCanvas(gradebook(), all, assignment("4711")).filled == 3);
    for (StudentResult& student : all) student.student.account.clear();
    all[0].student.name = "onestudent";
    all[1].student.name = "Student Two";
    const FilledGradebook filled = filledCanvas(gradebook(), all, assignment("4711"));
    CHECK(filled.filled == 2);
    CHECK(notes(filled, "matched by the name alone: onestudent, Student Two"));
    CHECK(filled.unmatchedStudents == std::vector<std::string>{"student-06"});
}

TEST_CASE("Canvas: names in two columns are read as well") {
    const std::string text =
        "LastName,FirstName,ID,SIS Login ID,Section,Radiosity (4711)\nPoints Possible,,,,,100\n"
        "One,Student,71,one,A,\nTwo,Student,72,two,A,\n";
    std::vector<StudentResult> all = students();
    all[1].student.account = "x";
    all[1].student.name = "Student Two";
    const FilledGradebook filled = filledCanvas(text, all, assignment(""));
    CHECK(contains(filled.text, "71,one,A,100\n"));
    CHECK(contains(filled.text, "72,two,A,68\n"));
}

TEST_CASE("Canvas: another file is an error that shows its titles") {
    CHECK(contains(faultOf("Name,Mark\nx,1\n", ""),
                   "gradebook.csv:1: is no gradebook of Canvas: found the titles 'Name', 'Mark'"));
    CHECK(contains(faultOf("Student,ID,Login,Group,Radiosity (1)\n", ""), "is no gradebook of Canvas"));
    CHECK(contains(faultOf(gradebook() + "\"Broken", ""), "gradebook.csv:11: a quote is opened"));
}

TEST_CASE("Canvas: hostile names in the file stay in it, and what is listed of them is safe") {
    const std::string name = "=HYPERLINK(\"\"x\"\")\x1b[2J";
    const std::string text = gradebook() + "\"" + name + "\",80,,,Section A,,,,\n";
    const FilledGradebook filled = filledCanvas(text, students(), assignment("4711"));
    CHECK(contains(filled.text, "\"" + name + "\",80,,,Section A,,,,\n"));
    REQUIRE(filled.unmatchedRows.size() == 2);
    CHECK(filled.unmatchedRows[1] == "=HYPERLINK(\"x\")\\x1b[2J");
}

TEST_CASE("Canvas: a class of a thousand is filled in") {
    std::string text = header + points;
    const std::vector<StudentResult> all = largeClass(1000);
    for (const StudentResult& student : all)
        text += "\"" + student.student.name + "\"," + student.student.account + ",,,A,,,,\n";
    const FilledGradebook filled = filledCanvas(text, all, assignment("4711"));
    CHECK(filled.filled == 500);
    CHECK(filled.unmatchedRows.empty());
    CHECK(filled.unmatchedStudents.empty());
}

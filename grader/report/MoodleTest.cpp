#include "grader/report/Moodle.h"

#include <algorithm>

#include <doctest/doctest.h>

#include "base/Error.h"
#include "grader/report/PageTestHelp.h"
#include "grader/report/SampleClass.h"

using namespace radlab::grader;
using namespace radlab::grader::test;

namespace {

constexpr const char* english =
    "Identifier,\"Full name\",\"Email address\",Status,Grade,\"Maximum grade\",\"Grade can be changed\","
    "\"Last modified (submission)\",\"Last modified (grade)\",\"Feedback comments\"";
constexpr const char* german =
    "ID,\"Vollständiger Name\",E-Mail-Adresse,Status,Bewertung,Bestwertung,\"Bewertung kann geändert werden\","
    "\"Zuletzt geändert (Abgabe)\",\"Zuletzt geändert (Bewertung)\",\"Feedback als Kommentar\"";
constexpr const char* french =
    "Identifiant,\"Nom complet\",\"Adresse de courriel\",Statut,Note,\"Note maximale\",\"La note peut être modifiée\","
    "\"Dernière modification (travail remis)\",\"Dernière modification (note)\",\"Feedback par commentaires\"";

// Moodle's file of the small class: participants 9001 to 9006.
std::string worksheet(const std::string& titles, const std::string& participant, const std::string& most,
                      const std::string& yes) {
    std::string text = titles + "\r\n";
    const char* names[] = {"One", "Two", "Three", "Four", "Five", "Six"};
    for (int i = 0; i < 6; ++i)
        text += "\"" + participant + std::to_string(9001 + i) + "\",\"Student " + names[i] + "\",s" +
                std::to_string(i + 1) + "@example.org,\"Submitted for grading\",," + most + "," + yes +
                ",\"Monday, 5 October 2026, 10:00 AM\",-,\r\n";
    return text;
}

std::string worksheet() { return "\xef\xbb\xbf" + worksheet(english, "Participant ", "100.00", "Yes"); }

std::vector<StudentResult> students() {
    std::vector<StudentResult> all = smallClass();
    for (std::size_t i = 0; i < all.size(); ++i) all[i].student.account = std::to_string(9001 + i);
    return all;
}

FilledGradebook fill(const std::string& text, const FillOptions& options = {}) {
    return filledMoodle(text, students(), options);
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    REQUIRE(at != std::string::npos);
    return text.replace(at, from.size(), to);
}

std::string marked(std::string text, const std::string& person, const std::string& mark) {
    const std::size_t begin = text.find(person + "@example.org,\"Submitted for grading\",");
    REQUIRE(begin != std::string::npos);
    return text.insert(text.find(",,", begin) + 1, mark);
}

std::string faultOf(const std::string& text, const FillOptions& options = {}) {
    try {
        fill(text, options);
    } catch (const radlab::Error& error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST_CASE("Moodle: the marks stand in their column, and every other byte is as it was") {
    const FilledGradebook filled = fill(worksheet());
    CHECK(filled.text == marked(marked(marked(worksheet(), "s1", "100.00"), "s2", "68.00"), "s6", "0.00"));
    CHECK(filled.filled == 3);
    CHECK(filled.unmatchedRows.empty());
    CHECK(filled.unmatchedStudents.empty());
}

TEST_CASE("Moodle: worksheets in other languages are read and keep their numbers") {
    const std::string inGerman = worksheet(german, "Teilnehmer/in", "\"100,00\"", "Ja");
    CHECK(fill(inGerman).text ==
          marked(marked(marked(inGerman, "s1", "\"100,00\""), "s2", "\"68,00\""), "s6", "\"0,00\""));
    const std::string inFrench = worksheet(french, "Participant", "\"50,00\"", "Oui");
    CHECK(fill(inFrench).text ==
          marked(marked(marked(inFrench, "s1", "\"50,00\""), "s2", "\"34,00\""), "s6", "\"0,00\""));
}

TEST_CASE("Moodle: where no title is known, the marks stand left of the largest one") {
    const std::string text = worksheet(replaced(english, "Status,Grade,", "Stav,Známka,"), "Účastník", "100", "Ano");
    CHECK(fill(text).text == marked(marked(marked(text, "s1", "100"), "s2", "68"), "s6", "0"));
}

TEST_CASE("Moodle: a worksheet cut down to what Moodle needs is enough") {
    const FilledGradebook filled =
        fill("Identifier,Grade,Last modified (grade)\nParticipant 9002,,-\nParticipant 9001,,-\nParticipant 4,,-\n");
    CHECK(filled.text ==
          "Identifier,Grade,Last modified (grade)\nParticipant 9002,68,-\nParticipant 9001,100,-\nParticipant 4,,-\n");
    CHECK(filled.unmatchedRows == std::vector<std::string>{"Participant 4"});
    CHECK(filled.unmatchedStudents == std::vector<std::string>{"student-06"});
}

TEST_CASE("Moodle: a locked grade stays as it is") {
    const std::string text = replaced(worksheet(), "s2@example.org,\"Submitted for grading\",,100.00,Yes",
                                      "s2@example.org,\"Submitted for grading\",5.00,100.00,No");
    const FilledGradebook filled = fill(text);
    CHECK(filled.filled == 2);
    CHECK(contains(filled.text, "\",5.00,100.00,No,"));
    CHECK(std::any_of(filled.notes.begin(), filled.notes.end(),
                      [](const std::string& note) { return contains(note, "locked: student-02"); }));
}

TEST_CASE("Moodle: feedback is HTML of our own words, only where nobody has written any") {
    FillOptions options;
    options.feedback = true;
    std::string text = worksheet();
    text.insert(text.find("\r\n", text.find("Participant 9001")), "well done");
    const FilledGradebook filled = fill(text, options);
    CHECK(contains(filled.text, ",-,well done\r\n"));
    CHECK(
        contains(filled.text,
                 ",-,\"<p>4 of 6 functions are right. 68 of 100 marks.</p><ul><li>maxenergy_patch: 10/10, right</li>"));
    CHECK(contains(filled.text, ",-,<p>It does not compile. 0 of 100 marks.</p>\r\n"));
    CHECK(countOf(filled.text, "<p>") == 2);
    CHECK(contains(faultOf(replaced(worksheet(), "Feedback comments", "Else"), options),
                   "there is no column for feedback"));
}

TEST_CASE("Moodle: names of stages in the feedback are escaped, whatever they are") {
    std::vector<StudentResult> all = students();
    for (StageResult& stage : all[1].result.stages) stage.stage = "<script>alert(1)</script>";
    FillOptions options;
    options.feedback = true;
    const std::string text = filledMoodle(worksheet(), all, options).text;
    CHECK_FALSE(contains(text, "<script>"));
    CHECK(contains(text, "&lt;script&gt;"));
}

TEST_CASE("Moodle: students are found by e-mail or name, too") {
    std::vector<StudentResult> all = students();
    for (std::size_t i = 0; i < all.size(); ++i) all[i].student.account = "s" + std::to_string(i + 1) + "@example.org";
    CHECK(filledMoodle(worksheet(), all, {}).filled == 3);
    for (StudentResult& student : all) student.student.account = "x";
    all[1].student.name = "Student Two";
    CHECK(filledMoodle(worksheet(), all, {}).filled == 1);
}

TEST_CASE("Moodle: other files and assignments with a scale are errors that show the titles") {
    CHECK(
        contains(faultOf("Name,Grade\nx,1\n"), "is no grading worksheet of Moodle: found the titles 'Name', 'Grade'"));
    CHECK(contains(faultOf("Identifier,Grade\n"), "is no grading worksheet of Moodle"));
    CHECK(contains(faultOf("Identifier,Mark\nParticipant 1,\n"), "the column of the marks is not clear"));
    CHECK(contains(faultOf("Identifier,Grade,Note\nParticipant 1,,\n"), "the column of the marks is not clear"));
    CHECK(contains(faultOf("ID,Bewertung,Skala\nTeilnehmer/in1,,\"gut\nschlecht\"\n"), "graded by a scale"));
    CHECK(contains(faultOf("Identifier,Grade,Last modified (grade)\nParticipant 1,good,-\n"), "graded by a scale"));
}

#include "grader/intake/DownloadName.h"

#include <doctest/doctest.h>

using namespace radlab::grader;

TEST_CASE("Canvas: name, lateness, the two numbers and the student's own name of the file are told apart") {
    const auto plain = canvasName("student07_123_456_ProgRef-1.cpp");
    REQUIRE(plain);
    CHECK(plain->name == "student07");
    CHECK(plain->account == "123");
    CHECK(plain->upload == "456");
    CHECK(plain->original == "ProgRef-1.cpp");
    CHECK_FALSE(plain->late);
    CHECK_FALSE(plain->ambiguous);
    const auto late = canvasName("student_seven_LATE_123_456_my_work.tar.gz");
    REQUIRE(late);
    CHECK(late->name == "student_seven");
    CHECK(late->late);
    CHECK(late->original == "my_work.tar.gz");
}

TEST_CASE("Canvas: hidden names, texts that were typed in, and names that are none of its own") {
    const auto hidden = canvasName("LATE_anon_Ab3dE_456_ProgRef.cpp");
    REQUIRE(hidden);
    CHECK(hidden->name.empty());
    CHECK(hidden->account == "anon_Ab3dE");
    CHECK(hidden->late);
    const auto typed = canvasName("student07_123_text.html");
    REQUIRE(typed);
    CHECK(typed->account == "123");
    CHECK(typed->original.empty());
    for (const char* other : {"student-07", "student-07.cpp", "a_1_ProgRef.cpp", "a_1_2_", "_1_2", "", "a_1_b_2.cpp"})
        CHECK_FALSE(canvasName(other));
}

TEST_CASE("Canvas: the first two numbers count, and a third right after them makes the name ambiguous") {
    const auto file = canvasName("student07_123_456_789_1011_ProgRef.cpp");
    REQUIRE(file);
    CHECK(file->account == "123");
    CHECK(file->original == "789_1011_ProgRef.cpp");
    CHECK(file->ambiguous);
    CHECK_FALSE(canvasName("student07_123_456_work_789_1011_ProgRef.cpp")->ambiguous);
    CHECK_FALSE(canvasName("student07_123_456_789.zip")->ambiguous);
}

TEST_CASE("Moodle: folders with and without the last line, files, typed texts, groups") {
    for (const char* name :
         {"Student Seven_12345_assignsubmission_file_", "Student Seven_12345_assignsubmission_file"}) {
        const auto folder = moodleName(name);
        REQUIRE(folder);
        CHECK(folder->name == "Student Seven");
        CHECK(folder->account == "12345");
        CHECK(folder->holdsFiles);
        CHECK(folder->original.empty());
    }
    CHECK(moodleName("Student Seven_12345_assignsubmission_file_My_work.cpp")->original == "My_work.cpp");
    CHECK_FALSE(moodleName("Student Seven_12345_assignsubmission_onlinetext_")->holdsFiles);
    CHECK(moodleName("Default group_assignsubmission_file_")->account.empty());
    CHECK(moodleName("Sch\xc3\xbcler \xe4\xb8\x83_9_assignsubmission_file_")->name == "Sch\xc3\xbcler \xe4\xb8\x83");
    for (const char* other : {"Student Seven_12345", "a_b_1_assignsubmission_file_", "_1_assignsubmission_file_"})
        CHECK_FALSE(moodleName(other));
}

TEST_CASE("endings tell archives that are read, archives that are not, and the rest") {
    for (const char* name : {"a.zip", "a.ZIP", "a.tar", "a.tar.gz", "a.tgz", "a.tar.xz", "a.tar.bz2", "a.tar.zst",
                             "a-1.zip", "a.tar-1.gz", "a.b.tbz2"})
        CHECK(kindOf(name) == FileKind::archive);
    CHECK(kindOf("a.7z") == FileKind::foreignArchive);
    CHECK(kindOf("a.Rar") == FileKind::foreignArchive);
    for (const char* name : {"a.cpp", "zip", "a.zip.txt", "a.gz", "a", ""}) CHECK(kindOf(name) == FileKind::other);
    CHECK(withoutEnding("student-07.tar.gz") == "student-07");
    CHECK(withoutEnding("student.07.cpp") == "student.07");
    CHECK(withoutEnding("student-07") == "student-07");
}

TEST_CASE("names match exactly, with a number appended, or but for case") {
    using How = NameMatch::How;
    CHECK(matchName("ProgRef.cpp", "ProgRef.cpp")->how == How::exact);
    CHECK(matchName("ProgRef-12.cpp", "ProgRef.cpp")->how == How::numbered);
    CHECK(matchName("ProgRef-12.cpp", "ProgRef.cpp")->number == 12);
    CHECK(matchName("progref.CPP", "ProgRef.cpp")->how == How::otherCase);
    CHECK(matchName("progref-3.cpp", "ProgRef.cpp")->number == 3);
    for (const char* other : {"ProgRef", "ProgRef.cpp.txt", "ProgRef-.cpp", "ProgRef-0.cpp", "ProgRef-1x.cpp",
                              "ProgRef--1.cpp", "ProgRef-99999999999.cpp", "aProgRef.cpp", "", "-1"})
        CHECK_FALSE(matchName(other, "ProgRef.cpp"));
}

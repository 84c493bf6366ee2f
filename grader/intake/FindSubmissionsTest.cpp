#include <fcntl.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <map>

#include "base/Error.h"
#include "grader/intake/IntakeTestHelp.h"

using namespace radlab;
using namespace radlab::grader;
using radlab::test::has;
using radlab::test::put;

namespace {

namespace fs = std::filesystem;

fs::path root(const test::Folder& folder) { return folder / ""; }

std::map<std::string, Submission> foundIn(const fs::path& folder) {
    std::map<std::string, Submission> byId;
    std::string before;
    for (const Submission& submission : findSubmissions(folder)) {
        CHECK(before < submission.student.id);
        before = submission.student.id;
        byId[submission.student.id] = submission;
    }
    return byId;
}

std::vector<std::string> namesOf(const Submission& submission) {
    std::vector<std::string> names;
    for (const fs::path& place : submission.places) names.push_back(place.filename());
    return names;
}

void setTime(const fs::path& file, std::time_t time) {
    const timespec both[2] = {{time, 0}, {time, 0}};
    REQUIRE(utimensat(AT_FDCWD, file.c_str(), both, AT_SYMLINK_NOFOLLOW) == 0);
}

using Names = std::vector<std::string>;

// A clone as Classroom 50 leaves it, saying that it belongs to this classroom and assignment.
void putClone(const fs::path& clone, const std::string& classroom, const std::string& assignment) {
    put(clone / ".git/config");
    put(clone / ".classroom50.yaml", "schema: \"classroom50/repo-config/v1\"\nclassroom: \"" + classroom +
                                         "\"\nassignment: \"" + assignment + "\"\n");
    put(clone / "exercises/ProgRef.cpp");
    put(clone / "result.json", R"({"schema": "classroom50/result/v1", "score": 100, "max-score": 100})");
    put(clone / "results.json", "[]");
}

Names idsIn(const fs::path& folder) {
    Names ids;
    for (const auto& [id, submission] : foundIn(folder)) {
        CHECK(submission.student.account == id);
        CHECK(take(submission, test::rules()).outcome == Outcome::graded);
        ids.push_back(id);
    }
    return ids;
}

}  // namespace

TEST_CASE("a folder, an archive or a file a student, whatever lies beside them") {
    const test::Folder folder;
    put(folder / "student-01/ProgRef.cpp");
    put(folder / "student-02.zip");
    put(folder / "student-03.tar.gz");
    put(folder / "student-04.cpp");
    fs::create_directory(folder / "student-05");
    for (const char* other : {".DS_Store", "Thumbs.db", "index.html", "__MACOSX/._x", ".git/config"})
        put(folder / other);
    setTime(folder / "student-02.zip", 1795421700);
    const auto found = foundIn(root(folder));
    REQUIRE(found.size() == 5);
    CHECK(namesOf(found.at("student-01")) == Names{"student-01"});
    CHECK(namesOf(found.at("student-02")) == Names{"student-02.zip"});
    CHECK(found.at("student-02").student.name == "student-02");
    CHECK(found.at("student-02").student.account == "student-02");
    CHECK(found.at("student-02").student.submitted == "2026-11-23T08:15:00Z");
    CHECK(namesOf(found.at("student-03")) == Names{"student-03.tar.gz"});
    CHECK(namesOf(found.at("student-04")) == Names{"student-04.cpp"});
    CHECK(found.at("student-05").student.remarks.empty());
}

TEST_CASE("Canvas: files of one student belong together, the newest last, and one that is late says so") {
    const test::Folder folder;
    put(folder / "seven_LATE_123_900_ProgRef-1.cpp");
    put(folder / "seven_LATE_123_1000_picture.png");
    put(folder / "seven_LATE_123_900_ProgRef.cpp");
    put(folder / "eight_124_77_work.zip");
    put(folder / "nine_125_text.html");
    put(folder / "gradebook.csv");
    setTime(folder / "seven_LATE_123_900_ProgRef.cpp", 1795421760);
    setTime(folder / "seven_LATE_123_900_ProgRef-1.cpp", 1795421700);
    setTime(folder / "seven_LATE_123_1000_picture.png", 1795421640);
    const auto found = foundIn(root(folder));
    REQUIRE(found.size() == 4);
    const Submission& seven = found.at("seven_123");
    CHECK(namesOf(seven) == Names{"seven_LATE_123_900_ProgRef.cpp", "seven_LATE_123_900_ProgRef-1.cpp",
                                  "seven_LATE_123_1000_picture.png"});
    CHECK(seven.student.name == "seven");
    CHECK(seven.student.account == "123");
    CHECK(seven.student.late);
    CHECK(seven.student.submitted == "2026-11-23T08:16:00Z");
    CHECK_FALSE(found.at("eight_124").student.late);
    CHECK(found.at("nine_125").places.empty());
    CHECK(found.at("nine_125").student.remarks.empty());
    CHECK(found.count("gradebook") == 1);
}

TEST_CASE("Canvas: a name that could be another student's is left out beside that one's own, and told") {
    const test::Folder folder;
    put(folder / "seven_123_456_work.zip");
    put(folder / "seven_123_999_1000_work.zip");  // of a student who calls himself "seven_123", or of seven
    put(folder / "eight_124_457_1_work.zip");
    const auto found = foundIn(root(folder));
    REQUIRE(found.size() == 2);
    CHECK(namesOf(found.at("seven_123")) == Names{"seven_123_456_work.zip"});
    CHECK(has(found.at("seven_123").student.remarks, "seven_123_999_1000_work.zip: its numbers"));
    CHECK(namesOf(found.at("eight_124")) == Names{"eight_124_457_1_work.zip"});
}

TEST_CASE("Canvas: an account under two names is two students, and both are told") {
    const test::Folder folder;
    put(folder / "seven_123_456_ProgRef.cpp");
    put(folder / "eight_123_457_ProgRef.cpp");
    const auto found = foundIn(root(folder));
    REQUIRE(found.size() == 2);
    CHECK(has(found.at("seven_123").student.remarks, "account 123"));
    CHECK(has(found.at("eight_123").student.remarks, "account 123"));
}

TEST_CASE("Moodle: folders or files, texts typed in hold no work") {
    const test::Folder folder;
    put(folder / "Student Seven_12345_assignsubmission_file_/ProgRef.cpp");
    put(folder / "Student Seven_12345_assignsubmission_onlinetext_/onlinetext.html");
    put(folder / "Student Eight_12346_assignsubmission_file/work.zip");
    put(folder / "Student Nine_12347_assignsubmission_onlinetext_/onlinetext.html");
    const auto found = foundIn(root(folder));
    REQUIRE(found.size() == 3);
    CHECK(namesOf(found.at("Student-Seven_12345")) == Names{"Student Seven_12345_assignsubmission_file_"});
    CHECK(found.at("Student-Seven_12345").student.name == "Student Seven");
    CHECK(found.at("Student-Seven_12345").student.account == "12345");
    CHECK(found.count("Student-Eight_12346") == 1);
    CHECK(found.at("Student-Nine_12347").places.empty());

    const test::Folder flat;
    put(flat / "Student Seven_12345_assignsubmission_file_ProgRef.cpp");
    put(flat / "Student Seven_12345_assignsubmission_file_notes.txt");
    CHECK(foundIn(root(flat)).at("Student-Seven_12345").places.size() == 2);
}

TEST_CASE("GitHub Classroom: the login is what follows the assignment") {
    const test::Folder folder;
    for (const char* name : {"radiosity-1-ann-a", "radiosity-1-ben", "radiosity-1-cy"})
        put(folder / (std::string(name) + "/.git/config"));
    fs::create_directory(folder / "notes");
    const auto found = foundIn(root(folder));
    REQUIRE(found.size() == 4);
    CHECK(found.at("ann-a").student.account == "ann-a");
    CHECK(found.at("ann-a").student.name == "radiosity-1-ann-a");
    CHECK(namesOf(found.at("ben")) == Names{"radiosity-1-ben"});
    CHECK(found.count("notes") == 1);
}

TEST_CASE("GitHub Classroom: the folder that gh makes names the assignment, also from outside") {
    const test::Folder folder;
    const fs::path inner = folder / "radiosity-submissions";
    for (const char* name : {"radiosity-ann-a", "radiosity-ann-b"}) put(inner / name / ".git/config");
    for (const fs::path& given : {root(folder), inner}) {
        const auto found = foundIn(given);
        REQUIRE(found.size() == 2);
        CHECK(found.count("ann-a") == 1);
        CHECK(found.at("ann-b").places[0] == fs::canonical(inner) / "radiosity-ann-b");
    }
    const test::Folder single;  // nothing tells where the login begins
    put(single / "radiosity-ann/.git/config");
    CHECK(foundIn(root(single)).count("radiosity-ann") == 1);
}

TEST_CASE("Classroom 50: the login is what follows classroom and assignment, and the table of marks is no student") {
    const test::Folder folder;
    const fs::path inner = folder / "cs-a-radiosity-1_submissions_2026_11_23_T_08_15_00";
    for (const char* login : {"ann-a", "ann-b"})
        putClone(inner / (std::string("cs-a-radiosity-1-") + login), "cs-a", "radiosity-1");
    put(inner / "scores.csv", "username,score\nann-a,90\n");
    CHECK(idsIn(inner) == Names{"ann-a", "ann-b"});
    CHECK(idsIn(root(folder)) == Names{"ann-a", "ann-b"});
    fs::remove_all(inner / "cs-a-radiosity-1-ann-b");
    CHECK(idsIn(inner) == Names{"ann-a"});
}

TEST_CASE("Classroom 50: in a folder of any name, what most clones say of themselves tells where the login begins") {
    const test::Folder folder;
    for (const char* login : {"ann-a", "ann-b", "ann-c"})
        putClone(folder / (std::string("cs-a-radiosity-1-") + login), "CS-A", "radiosity-1");
    CHECK(idsIn(root(folder)) == Names{"ann-a", "ann-b", "ann-c"});
    put(folder / "scores.csv");
    CHECK(idsIn(root(folder)) == Names{"ann-a", "ann-b", "ann-c"});
}

TEST_CASE("Classroom 50: a student's own .classroom50.yaml does not make a submission somebody else's") {
    const test::Folder folder;
    const fs::path forged = folder / "cs-radiosity-ann-ben";
    for (const char* login : {"ben", "cy"})
        putClone(folder / (std::string("cs-radiosity-") + login), "cs", "radiosity");
    putClone(forged, "cs-radiosity", "ann");  // would be ben
    CHECK(idsIn(root(folder)) == Names{"ann-ben", "ben", "cy"});
    for (const std::string& yaml :
         {std::string(), std::string(100000, 'x'), std::string("classroom: ../..\nassignment:"),
          std::string("\0classroom: \xff\n", 14)}) {
        put(forged / ".classroom50.yaml", yaml);
        CHECK(idsIn(root(folder)) == Names{"ann-ben", "ben", "cy"});
    }
    fs::remove(forged / ".classroom50.yaml");
    fs::create_symlink("/dev/zero", forged / ".classroom50.yaml");
    CHECK(idsIn(root(folder)) == Names{"ann-ben", "ben", "cy"});

    const test::Folder single;  // the only one is no majority
    putClone(single / "cs-radiosity-ann-ben", "cs-radiosity", "ann");
    CHECK(idsIn(root(single)) == Names{"cs-radiosity-ann-ben"});

    const test::Folder pair;  // two that do not agree
    putClone(pair / "cs-a-radiosity-ann", "cs-a", "radiosity");
    putClone(pair / "cs-a-radiosity-ben", "cs", "a");
    CHECK(idsIn(root(pair)) == Names{"ann", "ben"});
}

TEST_CASE("Classroom 50: early versions put the login first") {
    const test::Folder folder;
    const fs::path inner = folder / "school_submissions_2026_05_09_T_14_30_45";
    for (const char* login : {"ann-a", "ben", "cy"})
        putClone(inner / (std::string(login) + "-radiosity-1"), "cs", "radiosity-1");
    CHECK(idsIn(inner) == Names{"ann-a", "ben", "cy"});
    for (const char* login : {"ann-a", "ben"})
        fs::remove(inner / (std::string(login) + "-radiosity-1/.classroom50.yaml"));
    CHECK(idsIn(inner) == Names{"ann-a-radiosity-1", "ben-radiosity-1", "cy-radiosity-1"});
}

TEST_CASE("Classroom 50: what the web app downloads is an archive of a repository a login") {
    const test::Folder folder;
    for (const std::string login : {"ann-a", "ben"}) {
        const std::string top = "school-cs-radiosity-" + login + "-0123abc/";
        put(folder / (login + ".zip"), test::pack({{top + "exercises/ProgRef.cpp"},
                                                   {top + "exercises/extensions/Mirror.cpp"},
                                                   {top + ".classroom50.yaml", "classroom: \"x\"\n"},
                                                   {top + "result.json", "{}"}}));
    }
    CHECK(idsIn(root(folder)) == Names{"ann-a", "ben"});
}

TEST_CASE("repositories cloned by hand are called as their folders are") {
    const test::Folder folder;
    for (const char* name : {"Ann Archer", "ben", "cy-d"}) {
        put(folder / name / ".git/config");
        put(folder / name / "exercises/ProgRef.cpp");
    }
    put(folder / "scores.csv");
    const auto found = foundIn(root(folder));
    REQUIRE(found.size() == 3);
    CHECK(found.at("Ann-Archer").student.name == "Ann Archer");
    CHECK(found.count("ben") == 1);
    CHECK(found.count("cy-d") == 1);
}

TEST_CASE("links, pipes, sockets and devices are students with a remark and without a place") {
    const test::Folder folder;
    put(folder / "student-01/ProgRef.cpp");
    fs::create_symlink("/etc", folder / "student-02");
    fs::create_symlink("/etc/passwd", folder / "student-03.cpp");
    fs::create_symlink("nowhere", folder / "student-04.zip");
    REQUIRE(mkfifo((folder / "student-05.cpp").c_str(), 0644) == 0);
    const int socketFile = socket(AF_UNIX, SOCK_STREAM, 0);
    sockaddr_un address = {};
    address.sun_family = AF_UNIX;
    (folder / "student-06").string().copy(address.sun_path, sizeof address.sun_path - 1);
    REQUIRE(bind(socketFile, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0);
    close(socketFile);
    const auto found = foundIn(root(folder));
    REQUIRE(found.size() == 6);
    for (const char* id : {"student-02", "student-03", "student-04", "student-05", "student-06"}) {
        CAPTURE(id);
        CHECK(found.at(id).places.empty());
        CHECK(found.at(id).student.remarks.size() == 1);
        const Taken taken = take(found.at(id), test::rules());
        CHECK(taken.outcome == Outcome::refused);
        CHECK(taken.hash.empty());
    }
    CHECK(has(found.at("student-03").student.remarks, "symbolic link"));
    CHECK(has(found.at("student-05").student.remarks, "named pipe"));
    CHECK(has(found.at("student-06").student.remarks, "socket"));
    CHECK(take(found.at("student-01"), test::rules()).outcome == Outcome::graded);
}

TEST_CASE("odd names are students with safe ids, and both of two that are alike have ids of their own") {
    const test::Folder folder;
    const std::vector<std::string> names = {
        "a\nb", "\x1b[31mred", "\xe2\x80\xaegpj", "<script>", "=1+1", "\xff\xfe", "a  b", std::string(250, 'x'), "Sam",
        "sam",  "-rf",         "%2e%2e",          "~root",    "$(id)"};
    for (const std::string& name : names) put(folder / name / "ProgRef.cpp");
    const auto found = foundIn(root(folder));
    REQUIRE(found.size() == names.size());
    for (const auto& entry : found) {
        CAPTURE(entry.first);
        CHECK(take(entry.second, test::rules()).outcome == Outcome::graded);
        CHECK(std::count(names.begin(), names.end(), entry.second.student.name) == 1);
    }
    CHECK(found.count("Sam") == 0);
    CHECK(found.count("script") == 1);
}

TEST_CASE("no folder, a file, and a folder without a submission are errors that say so") {
    const test::Folder folder;
    CHECK_THROWS_WITH_AS(findSubmissions(folder / "nowhere"), doctest::Contains("no such folder"), Error);
    put(folder / "submissions.zip");
    CHECK_THROWS_AS(findSubmissions(folder / "submissions.zip"), Error);
    put(folder / "empty/.DS_Store");
    CHECK_THROWS_WITH_AS(findSubmissions(folder / "empty"), doctest::Contains("no submission"), Error);
}

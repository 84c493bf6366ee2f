#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <sys/un.h>
#include <unistd.h>

#include "base/TestSkip.h"
#include "grader/intake/Hash.h"
#include "grader/intake/IntakeTestHelp.h"

using namespace radlab;
using namespace radlab::grader;
using radlab::test::has;
using radlab::test::pack;
using radlab::test::put;
using radlab::test::takeFrom;
using radlab::test::work;

namespace {

namespace fs = std::filesystem;

// A folder a case: the place of a student's submission.
struct Place {
    test::Folder folder;
    fs::path path = folder / "student-07";

    Place() { fs::create_directory(path); }
    Taken taken(const IntakeRules& within = test::rules()) const { return takeFrom({path}, within); }
};

void expectTaken(const Taken& taken, const std::string& contents = work) {
    CAPTURE(taken.remarks.size());
    CHECK(taken.outcome == Outcome::graded);
    REQUIRE(taken.files.count("ProgRef.cpp") == 1);
    CHECK(taken.files.at("ProgRef.cpp") == contents);
    CHECK(taken.hash == hashOf({{"ProgRef.cpp", contents}}));
}

void expectNot(const Taken& taken, Outcome outcome, const std::string& remark) {
    CAPTURE(remark);
    CHECK(taken.outcome == outcome);
    CHECK(taken.files.empty());
    CHECK(taken.hash.empty());
    CHECK(has(taken.remarks, remark));
}

}  // namespace

TEST_CASE("the file is found in exercises, beside, or deeper, and nothing is said about it") {
    for (const char* path :
         {"exercises/ProgRef.cpp", "ProgRef.cpp", "radlab/exercises/ProgRef.cpp", "1/2/3/4/5/6/7/8/ProgRef.cpp"}) {
        const Place place;
        put(place.path / path);
        put(place.path / "framework/main.cpp");
        put(place.path / ".git/exercises/ProgRef.cpp", "no\n");
        expectTaken(place.taken());
        CHECK(place.taken().remarks.empty());
    }
}

TEST_CASE("a bare file of the right kind is the work, whatever it is called") {
    const test::Folder folder;
    for (const char* name : {"student-07.cpp", "student-07.CPP", "ProgRef.cpp"}) {
        put(folder / name);
        expectTaken(takeFrom({folder / name}));
    }
    put(folder / "student-07.pdf");
    expectNot(takeFrom({folder / "student-07.pdf"}), Outcome::nothing, "found instead: student-07.pdf");
    fs::create_symlink("student-07.cpp", folder / "link.cpp");
    expectNot(takeFrom({folder / "link.cpp"}), Outcome::refused, "symbolic link");
}

TEST_CASE("a missing file, an empty one and one of white space are nothing, and what is there instead is told") {
    const Place place;
    expectNot(place.taken(), Outcome::nothing, "ProgRef.cpp is missing; no other file was handed in");
    put(place.path / "main.cpp");
    put(place.path / "a\nb.txt");
    expectNot(place.taken(), Outcome::nothing, "found instead: a\\x0ab.txt, main.cpp");
    for (int i = 0; i < 10; ++i) put(place.path / ("x" + std::to_string(i)));
    expectNot(place.taken(), Outcome::nothing, "x2 and more");
    for (const char* contents : {"", " \n\t\r\n"}) {
        put(place.path / "ProgRef.cpp", contents);
        expectNot(place.taken(), Outcome::nothing, "ProgRef.cpp is empty");
        CHECK(place.taken().remarks.size() == 1);
    }
    expectNot(takeFrom({}), Outcome::nothing, "missing");
}

TEST_CASE("of names that differ in case, the exact one is taken, or one with a remark") {
    const Place place;
    put(place.path / "progref.cpp");
    expectTaken(place.taken());
    CHECK(has(place.taken().remarks, "progref.cpp was taken for ProgRef.cpp"));
    put(place.path / "deep/ProgRef.cpp", "exact\n");
    expectTaken(place.taken(), "exact\n");
}

TEST_CASE("two at the same depth that differ are refused, and both are named") {
    const Place place;
    put(place.path / "a/ProgRef.cpp");
    put(place.path / "b/ProgRef.cpp");
    expectTaken(place.taken());
    put(place.path / "b/ProgRef.cpp", "other\n");
    expectNot(place.taken(), Outcome::refused, "a/ProgRef.cpp and b/ProgRef.cpp differ");
}

TEST_CASE("bytes that no compiler reads are taken with a remark, and a byte order mark stays") {
    const Place place;
    using namespace std::string_literals;
    put(place.path / "ProgRef.cpp", "int\0x;"s);
    expectTaken(place.taken(), "int\0x;"s);
    CHECK(has(place.taken().remarks, "NUL bytes"));
    put(place.path / "ProgRef.cpp", "\xff\xfei\0n\0t\0"s);
    CHECK(has(place.taken().remarks, "UTF-16"));
    put(place.path / "ProgRef.cpp", "\xef\xbb\xbfint x;\n");
    expectTaken(place.taken(), "\xef\xbb\xbfint x;\n");
    CHECK(place.taken().remarks.empty());
}

TEST_CASE("a link to a file is refused, a hard link is a file") {
    const Place place;
    put(place.folder / "secret");
    fs::create_symlink("../secret", place.path / "ProgRef.cpp");
    expectNot(place.taken(), Outcome::refused, "ProgRef.cpp: a symbolic link");
    fs::remove(place.path / "ProgRef.cpp");
    fs::create_hard_link(place.folder / "secret", place.path / "ProgRef.cpp");
    expectTaken(place.taken());
}

TEST_CASE("a link to a folder is not entered, nor is one in the place of the submission") {
    const Place place;
    put(place.folder / "elsewhere/ProgRef.cpp");
    fs::create_directory_symlink("../elsewhere", place.path / "exercises");
    expectNot(place.taken(), Outcome::refused, "exercises: a symbolic link");
    fs::create_directory_symlink("elsewhere", place.folder / "linked");
    expectNot(takeFrom({place.folder / "linked"}), Outcome::refused, "linked: a symbolic link");
    fs::create_symlink(".", place.path / "loop");
    put(place.path / "ProgRef.cpp");
    expectTaken(place.taken());
}

TEST_CASE("a pipe and a socket are refused, and nobody waits for them") {
    const Place pipe;
    REQUIRE(mkfifo((pipe.path / "ProgRef.cpp").c_str(), 0644) == 0);
    expectNot(pipe.taken(), Outcome::refused, "ProgRef.cpp: a named pipe");
    expectNot(takeFrom({pipe.path / "ProgRef.cpp"}), Outcome::refused, "named pipe");

    const Place sockets;
    const int socketFile = socket(AF_UNIX, SOCK_STREAM, 0);
    sockaddr_un address = {};
    address.sun_family = AF_UNIX;
    (sockets.path / "ProgRef.cpp").string().copy(address.sun_path, sizeof address.sun_path - 1);
    REQUIRE(bind(socketFile, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0);
    expectNot(sockets.taken(), Outcome::refused, "ProgRef.cpp: a socket");
    close(socketFile);
}

TEST_CASE("a device in the place of the submission is refused") {
    expectNot(takeFrom({"/dev/zero"}), Outcome::refused, "zero: a device");
}

TEST_CASE("a device in a submission is refused") {
    const Place device;
    if (mknod((device.path / "ProgRef.cpp").c_str(), S_IFCHR | 0644, makedev(1, 5)) != 0)
        return test::skipped("only root may make a device");
    expectNot(device.taken(), Outcome::refused, "ProgRef.cpp: a device");
}

TEST_CASE("a file that is too large is refused unread, and others do not matter") {
    const Place place;
    put(place.path / "big.bin");
    fs::resize_file(place.path / "big.bin", std::uintmax_t{10} << 30);
    put(place.path / "ProgRef.cpp", std::string(std::size_t{1} << 20, ' ') + "x");
    expectNot(place.taken(), Outcome::refused, "ProgRef.cpp: too large: found 1048577 bytes, expected at most 1048576");
    fs::resize_file(place.path / "ProgRef.cpp", std::uintmax_t{10} << 30);
    expectNot(place.taken(), Outcome::refused, "too large");
    put(place.path / "ProgRef.cpp");
    expectTaken(place.taken());
    CHECK(place.taken().remarks.empty());
}

TEST_CASE("too many entries: what lies as deep or deeper is not looked at, what lies above is taken") {
    const Place place;
    IntakeRules few = test::rules();
    few.mostEntries = 100;
    put(place.path / "many/ProgRef.cpp");
    for (int i = 2; i < 100; ++i) put(place.path / "many" / std::to_string(i));
    expectTaken(place.taken(few));
    put(place.path / "many/100");
    expectNot(place.taken(few), Outcome::refused, "more than 100 files and folders; nothing at depth 1");
    put(place.path / "ProgRef.cpp", "above\n");
    fs::remove(place.path / "many/2");
    fs::remove(place.path / "many/3");
    expectTaken(place.taken(few), "above\n");
    put(place.path / "many/101");
    put(place.path / "many/102");
    const Taken taken = place.taken(few);
    expectTaken(taken, "above\n");
    CHECK(taken.remarks.size() == 1);
}

TEST_CASE("a tree that is too deep is not gone down") {
    const Place place;
    fs::path deep = place.path;
    for (int i = 0; i < 9; ++i) deep /= "d";
    put(deep / "ProgRef.cpp");
    expectNot(place.taken(), Outcome::refused, "more than 8 folders inside one another");
    std::string far;
    for (int i = 0; i < 100; ++i) far += "d/";
    fs::create_directories(place.path / far);
    put(place.path / "ProgRef.cpp");
    expectTaken(place.taken());
}

TEST_CASE("of several files of a student the newest counts, and an older one where that is none") {
    const test::Folder folder;
    const fs::path older = folder / "seven_123_455_ProgRef.cpp", newer = folder / "seven_123_456_ProgRef-1.cpp",
                   other = folder / "seven_123_457_notes.txt", packed = folder / "seven_123_458_work.zip";
    put(older, "older\n");
    put(newer, "newer\n");
    put(other);
    expectTaken(takeFrom({older, newer, other}), "newer\n");
    put(packed, "no archive");
    const Taken taken = takeFrom({older, newer, other, packed});
    expectTaken(taken, "newer\n");
    CHECK(has(taken.remarks, "the archive is refused"));
    put(packed, pack({{"radlab/exercises/ProgRef.cpp", "packed\n"}}));
    expectTaken(takeFrom({older, newer, other, packed}), "packed\n");
    expectNot(takeFrom({other}), Outcome::nothing, "found instead: notes.txt");
}

TEST_CASE("a file of Moodle's is known by its own name") {
    const test::Folder folder;
    const std::string before = "Student Seven_12345_assignsubmission_file_";
    put(folder / (before + "ProgRef.cpp"));
    put(folder / (before + "main.cpp"), "main\n");
    expectTaken(takeFrom({folder / (before + "ProgRef.cpp"), folder / (before + "main.cpp")}));
    expectNot(takeFrom({folder / (before + "main.cpp")}), Outcome::nothing, "found instead: main.cpp");
}

TEST_CASE("an archive in a student's folder is looked through where the file is not beside it") {
    const Place place;
    put(place.path / "work.zip", pack({{"work/ProgRef.cpp", "packed\n"}}));
    expectTaken(place.taken(), "packed\n");
    IntakeRules two = test::rules();
    two.files = {"ProgRef.cpp", "Helper.h"};
    put(place.path / "Helper.h", "help\n");
    CHECK(place.taken(two).files.size() == 2);
    fs::create_symlink("x", place.path / "link");
    fs::rename(place.path / "work.zip", place.path / "work.rar");
    expectNot(place.taken(), Outcome::refused, "work.rar: 7-Zip and RAR archives are not read");
    CHECK(has(place.taken().remarks, "link: a symbolic link"));
    fs::rename(place.path / "work.rar", place.path / "work.zip");
    put(place.path / "older.tgz", pack({{"ProgRef.cpp", "other\n"}}, test::asTarGz));
    expectNot(place.taken(), Outcome::refused, "several archives (older.tgz, work.zip)");
    put(place.path / "ProgRef.cpp");
    expectTaken(place.taken());
}

TEST_CASE("archives of all kinds are taken, empty ones are nothing, foreign ones are refused") {
    const test::Folder folder;
    const std::vector<test::Entry> entries = {{"radlab/exercises/ProgRef.cpp"}};
    const auto tarBy = [](int filter) { return test::Packing{ARCHIVE_FORMAT_TAR_USTAR, filter}; };
    put(folder / "a.zip", pack(entries));
    put(folder / "a.tar", pack(entries, test::asTar));
    put(folder / "a.tar.gz", pack(entries, test::asTarGz));
    put(folder / "a.tar.xz", pack(entries, tarBy(ARCHIVE_FILTER_XZ)));
    put(folder / "a.tar.bz2", pack(entries, tarBy(ARCHIVE_FILTER_BZIP2)));
    put(folder / "a.tar.zst", pack(entries, tarBy(ARCHIVE_FILTER_ZSTD)));
    for (const char* name : {"a.zip", "a.tar", "a.tar.gz", "a.tar.xz", "a.tar.bz2", "a.tar.zst"}) {
        CAPTURE(name);
        expectTaken(takeFrom({folder / name}));
        CHECK(takeFrom({folder / name}).remarks.empty());
    }
    put(folder / "a.zip", "");
    expectNot(takeFrom({folder / "a.zip"}), Outcome::nothing, "a.zip is empty");
    put(folder / "a.zip", pack({{"main.cpp"}}));
    expectNot(takeFrom({folder / "a.zip"}), Outcome::nothing, "found instead: main.cpp");
    put(folder / "a.7z");
    expectNot(takeFrom({folder / "a.7z"}), Outcome::refused, "7-Zip and RAR archives are not read");
    IntakeRules small = test::rules();
    small.mostArchive = 10;
    expectNot(takeFrom({folder / "a.tar"}, small), Outcome::refused, "too large");
}

TEST_CASE("several files may be wanted, the first must be there") {
    const Place place;
    IntakeRules two = test::rules();
    two.files = {"ProgRef.cpp", "Helper.h"};
    put(place.path / "Helper.h", "help\n");
    CHECK(place.taken(two).outcome == Outcome::nothing);
    put(place.path / "exercises/ProgRef.cpp");
    const Taken taken = place.taken(two);
    CHECK(taken.outcome == Outcome::graded);
    CHECK(taken.files == std::map<std::string, std::string>{{"ProgRef.cpp", work}, {"Helper.h", "help\n"}});
    CHECK(taken.hash == hashOf(taken.files));
}

TEST_CASE("remarks are counted beyond their limit") {
    const Place place;
    for (int i = 0; i < 30; ++i) fs::create_symlink("x", place.path / std::to_string(i));
    const Taken taken = place.taken();
    CHECK(taken.remarks.size() == 21);
    CHECK(taken.remarks.back() == "and 11 more such remarks");
}

#include "base/WholeFile.h"

#include <fstream>

#include <doctest/doctest.h>

#include "base/Error.h"
#include "base/TestFolder.h"

using namespace radlab;
using radlab::test::Folder;

TEST_CASE("a file comes back byte by byte") {
    const Folder folder;
    std::string bytes;
    for (int i = 0; i < 100000; ++i) bytes.push_back(static_cast<char>(i * i));
    for (const std::string& contents : {std::string(), std::string("a\r\nb\n"), std::string(3, '\0'), bytes}) {
        writeFile(folder / "file", contents);
        CHECK(readFile(folder / "file") == contents);
        CHECK(folder.entries() == 1);
    }
}

TEST_CASE("a shorter file replaces a longer one as a whole") {
    const Folder folder;
    writeFile(folder / "file", std::string(5000, 'x'));
    writeFile(folder / "file", "short");
    CHECK(readFile(folder / "file") == "short");
    CHECK(std::filesystem::file_size(folder / "file") == 5);
}

TEST_CASE("a folder is made with those that it lies in, and a file stays what it is") {
    const Folder folder;
    makeFolder(folder / "a/b");
    makeFolder(folder / "a/b");
    writeFile(folder / "a/b/file", "text");
    CHECK_THROWS_WITH_AS(makeFolder(folder / "a/b/file"), doctest::Contains("file: the folder cannot be made"), Error);
    CHECK(readFile(folder / "a/b/file") == "text");
}

TEST_CASE("in a folder that does not exist nothing is written, and none is made") {
    const Folder folder;
    const auto file = folder / "none/file";
    CHECK_THROWS_WITH_AS(writeFile(file, "text"), doctest::Contains((file.string() + ": cannot be written").c_str()),
                         Error);
    CHECK(folder.entries() == 0);
}

TEST_CASE("a folder in the place of the file stays as it was, with no part left beside it") {
    const Folder folder;
    std::filesystem::create_directory(folder / "taken");
    writeFile(folder / "taken/inside", "older");
    CHECK_THROWS_WITH_AS(writeFile(folder / "taken", "text"), doctest::Contains("taken: cannot be written"), Error);
    CHECK(folder.entries() == 1);
    CHECK(readFile(folder / "taken/inside") == "older");
}

#ifdef __linux__
TEST_CASE("on a name too long for its part the older file stays as it was") {
    const Folder folder;
    const auto file = folder / std::string(250, 'n');
    std::ofstream(file) << "older";
    CHECK_THROWS_AS(writeFile(file, "newer"), Error);
    CHECK(readFile(file) == "older");
    CHECK(folder.entries() == 1);
}
#endif

TEST_CASE("what is missing, a folder or larger than 1 GiB cannot be read, and the message says which") {
    const Folder folder;
    std::filesystem::create_directory(folder / "inner");
    CHECK_THROWS_WITH_AS(readFile(folder / "none"), doctest::Contains("none: no such file"), Error);
    CHECK_THROWS_WITH_AS(readFile(folder / "inner"), doctest::Contains("inner: is a folder"), Error);
    writeFile(folder / "large", "");
    std::filesystem::resize_file(folder / "large", (std::uintmax_t{1} << 30) + 1);  // takes no space
    CHECK_THROWS_WITH_AS(readFile(folder / "large"),
                         doctest::Contains("too large: found 1073741825 bytes, expected at most 1073741824"), Error);
}

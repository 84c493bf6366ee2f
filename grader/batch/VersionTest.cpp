#include "grader/batch/Version.h"

#include <doctest/doctest.h>

#include "base/Error.h"
#include "base/TestFolder.h"
#include "base/WholeFile.h"

using namespace radlab;
using namespace radlab::grader;

TEST_CASE("any change of a file of the grader gives another version, and only that") {
    const test::Folder folder;
    writeFile(folder / "a", "worker");
    writeFile(folder / "b", "manifest");
    const std::string version = versionOf({folder / "a", folder / "b"});
    CHECK(version.size() == 16);
    CHECK(version.find_first_not_of("0123456789abcdef") == std::string::npos);
    CHECK(versionOf({folder / "a", folder / "b"}) == version);
    CHECK(versionOf({folder / "b", folder / "a"}) != version);
    writeFile(folder / "a", "workerm");
    writeFile(folder / "b", "anifest");
    CHECK(versionOf({folder / "a", folder / "b"}) != version);
    CHECK_THROWS_AS(versionOf({folder / "a", folder / "absent"}), Error);
}

#ifdef __linux__
#include <unistd.h>
#endif

#include <doctest/doctest.h>

#include "base/TemporaryPlace.h"
#include "base/TestFolder.h"
#include "base/WholeFile.h"

using namespace radlab;

#ifdef __linux__

TEST_CASE("temporary files lie where TMPDIR says, or else where programs may be started") {
    const char* before = std::getenv("TMPDIR");
    const std::string kept = before ? before : "";
    const test::Folder folder;
    std::filesystem::create_directory(folder / "own");
    setenv("TMPDIR", (folder / "own").c_str(), 1);
    CHECK(temporaryPlace() == folder / "own");
    std::filesystem::permissions(folder / "own", std::filesystem::perms(0700));
    CHECK((temporaryPlace() == folder / "own") == (geteuid() != 0));
    setenv("TMPDIR", (folder / "absent").c_str(), 1);
    const std::filesystem::path other = temporaryPlace();
    CHECK(other != folder / "absent");
    writeFile(other / "radlab-test-program", "#!/bin/sh\nexit 7\n");
    std::filesystem::permissions(other / "radlab-test-program", std::filesystem::perms(0700));
    const int status = std::system((other / "radlab-test-program").c_str());
    CHECK(WEXITSTATUS(status) == 7);
    std::filesystem::remove(other / "radlab-test-program");
    if (before)
        setenv("TMPDIR", kept.c_str(), 1);
    else
        unsetenv("TMPDIR");
}

#endif

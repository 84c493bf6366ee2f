#include "grader/batch/FileLock.h"

#include <sys/wait.h>
#include <unistd.h>

#include <doctest/doctest.h>

#include "base/TestFolder.h"

using namespace radlab;
using namespace radlab::grader;

TEST_CASE("what a killed holder left behind is waited for, as it goes by itself") {
    const test::Folder folder;
    const pid_t holder = fork();
    if (holder == 0) {
        const FileLock lock(folder / "lock", "somebody");
        if (fork() == 0) sleep(3);  // far longer than a holder that lives is waited for
        _exit(0);
    }
    waitpid(holder, nullptr, 0);
    CHECK_NOTHROW(FileLock(folder / "lock", "somebody"));
}

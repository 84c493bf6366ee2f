#include "base/Program.h"

#include <new>

#include <doctest/doctest.h>

#include "base/Error.h"
#include "base/TestStderr.h"

using namespace radlab;
using radlab::test::CapturedStderr;

TEST_CASE("a program that ends by itself has its own exit code and prints nothing") {
    const CapturedStderr stderrText;
    CHECK(runProgram([] { return 0; }) == 0);
    CHECK(runProgram([] { return 7; }) == 7);
    CHECK(stderrText.text().empty());
}

TEST_CASE("bad input ends with 2 and one line that says where and what") {
    const CapturedStderr stderrText;
    CHECK(runProgram([]() -> int { throw Error({"room.x3d", 3}, "no faces"); }) == 2);
    CHECK(stderrText.text() == "error: room.x3d:3: no faces\n");
}

TEST_CASE("a stub that is not written yet ends with 2 and names the function and the file") {
    const CapturedStderr stderrText;
    CHECK(runProgram([]() -> int { throw NotImplemented("calcFF"); }) == 2);
    CHECK(stderrText.text() == "not started: calcFF is not written yet; write it in exercises/ProgRef.cpp\n");
}

TEST_CASE("a fault of the program ends with 3, whatever is thrown") {
    const CapturedStderr stderrText;
    CHECK(runProgram([]() -> int { throw std::logic_error("lost the thread"); }) == 3);
    CHECK(stderrText.text() == "internal error: lost the thread\n");
    CHECK(runProgram([]() -> int { throw std::bad_alloc(); }) == 3);
    CHECK(runProgram([]() -> int {
              RADLAB_CHECK(1 > 2);
              return 0;
          }) == 3);
    CHECK(stderrText.text().find("(1 > 2)") != std::string::npos);
    CHECK(runProgram([]() -> int { throw 42; }) == 3);
}

#include "base/TestSkip.h"

// Run by cmake/checks/SkipTest.py, which looks at what ctest makes of it.
TEST_CASE("the case that no machine can run" * doctest::skip()) {
    return radlab::test::skipped("no machine can run this");
}

#include "base/Warning.h"

#include <thread>

#include <doctest/doctest.h>

#include "base/TestStderr.h"

using namespace radlab;
using radlab::test::CapturedStderr;

TEST_CASE("a warning is one line on stderr") {
    const CapturedStderr stderrText;
    warn("passed over 2 faces");
    CHECK(stderrText.text() == "warning: passed over 2 faces\n");
}

TEST_CASE("a capture collects warnings in their order and prints none") {
    const CapturedStderr stderrText;
    const WarningCapture warnings;
    warn("one");
    warn("two");
    CHECK(warnings.texts == std::vector<std::string>{"one", "two"});
    CHECK(stderrText.text().empty());
}

TEST_CASE("the innermost capture takes a warning, and gives the next back to the outer one") {
    const CapturedStderr stderrText;
    {
        const WarningCapture outer;
        warn("before");
        {
            const WarningCapture inner;
            warn("inside");
            CHECK(inner.texts == std::vector<std::string>{"inside"});
        }
        warn("after");
        CHECK(outer.texts == std::vector<std::string>{"before", "after"});
    }
    warn("outside");
    CHECK(stderrText.text() == "warning: outside\n");
}

TEST_CASE("a capture leaves the warnings of other threads alone") {
    const CapturedStderr stderrText;
    const WarningCapture warnings;
    std::thread([] { warn("elsewhere"); }).join();
    CHECK(warnings.texts.empty());
    CHECK(stderrText.text() == "warning: elsewhere\n");
}

#pragma once

// What a test's code prints to stderr.

#include <iostream>
#include <sstream>
#include <string>

namespace radlab::test {

/// Collects what goes to std::cerr while it lives.
class CapturedStderr {
public:
    CapturedStderr() : before(std::cerr.rdbuf(collected.rdbuf())) {}
    ~CapturedStderr() { std::cerr.rdbuf(before); }
    CapturedStderr(const CapturedStderr&) = delete;
    CapturedStderr& operator=(const CapturedStderr&) = delete;

    std::string text() const { return collected.str(); }

private:
    std::ostringstream collected;
    std::streambuf* before;
};

}  // namespace radlab::test

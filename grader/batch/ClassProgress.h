#pragma once

#include <iosfwd>

#include "base/ProgressBar.h"

namespace radlab::grader {

/// How far the grading of a class is: a bar on a terminal, and elsewhere a line for every tenth.
class ClassProgress {
public:
    explicit ClassProgress(std::size_t submissions);
    /// The same on another stream, for tests.
    ClassProgress(std::size_t submissions, std::ostream& out, bool terminal);

    /// One more needed no grading.
    void skip();
    /// One more is done.
    void done(bool failed);

private:
    void show();

    std::size_t total, skipped = 0, finished = 0, failures = 0, told = 0;
    std::ostream& out;
    bool terminal;
    Stopwatch watch;
    ProgressBar bar;
};

}  // namespace radlab::grader

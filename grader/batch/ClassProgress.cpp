#include "grader/batch/ClassProgress.h"

#include <iostream>

namespace radlab::grader {

namespace {

constexpr std::size_t lines = 10;

}  // namespace

ClassProgress::ClassProgress(std::size_t submissions)
    : ClassProgress(submissions, std::cerr, errorStreamIsTerminal()) {}

ClassProgress::ClassProgress(std::size_t submissions, std::ostream& stream, bool isTerminal)
    : total(submissions),
      out(stream),
      terminal(isTerminal),
      bar("grading", static_cast<double>(submissions), "submissions", stream, isTerminal) {}

void ClassProgress::skip() {
    ++skipped;
    bar.skip(1);
    show();
}

void ClassProgress::done(bool failed) {
    ++finished;
    failures += failed ? 1 : 0;
    show();
}

void ClassProgress::show() {
    bar.show(static_cast<double>(finished), std::to_string(failures) + " failed");
    const std::size_t tenth = (skipped + finished) * lines / total;
    if (terminal || tenth == told) return;
    told = tenth;
    out << "grading: " << skipped + finished << " of " << total << " done, " << failures << " failed";
    const std::size_t left = total - skipped - finished;
    if (finished > 0 && left > 0)
        out << ", " << durationText(watch.seconds() * static_cast<double>(left) / static_cast<double>(finished))
            << " left";
    out << std::endl;
}

}  // namespace radlab::grader

#pragma once

#include <functional>
#include <iosfwd>
#include <string>

#include "base/Stopwatch.h"

namespace radlab {

/// A line on stderr that shows how far a long work is, its rate and the time left.
///
/// Silent where stderr is no terminal, unless RADLAB_PROGRESS is set. Redrawn at most ten times a second; wiped when it goes.
class ProgressBar {
public:
    /// title names the work, unit its steps ("shots"); total is how many there are.
    ProgressBar(std::string title, double total, std::string unit = "");
    /// The same on another stream, drawn if visible; for tests.
    ProgressBar(std::string title, double total, std::string unit, std::ostream& out, bool visible);
    ~ProgressBar();
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;

    /// Takes steps out of the total that turned out to cost nothing: rate and time left are those of the others.
    void skip(double steps) { total -= steps; }

    /// Shows that done of total steps are done, with a word on the state of things if given.
    void show(double done, const std::string& note = "");

private:
    std::string line(double done, const std::string& note) const;

    std::string title;
    std::string unit;
    double total;
    std::ostream& out;
    bool visible;
    Stopwatch watch;
    double lastDrawn = -1.0;
    std::size_t lastLength = 0;
};

/// Does work that cannot tell how far it is, under a bar with its title.
template <class Work>
auto shownAs(const std::string& title, const Work& work) {
    ProgressBar bar(title, 1.0);
    bar.show(0.0);
    return work();
}

/// "0.4 s", "12 s", "3 min 20 s", "2 h 5 min".
std::string durationText(double seconds);

/// Whether stderr is a terminal, where a person reads along.
bool errorStreamIsTerminal();

}  // namespace radlab

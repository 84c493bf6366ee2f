#include "base/ProgressBar.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <sstream>
#include <thread>

#include <doctest/doctest.h>

using namespace radlab;
using doctest::Approx;

namespace {

void wait(int milliseconds) { std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds)); }

// What a terminal shows in its line after the text: a carriage return goes back to its beginning.
std::string onScreen(const std::string& text) {
    std::string line;
    std::size_t column = 0;
    for (const char c : text) {
        if (c == '\r') {
            column = 0;
            continue;
        }
        if (column == line.size()) line.push_back(' ');
        line[column++] = c;
    }
    line.erase(line.find_last_not_of(' ') + 1);
    return line;
}

}  // namespace

TEST_CASE("the bar shows its title, how far the work is, its rate and the time left") {
    std::ostringstream out;
    ProgressBar bar("shooting", 400, "shots", out, true);
    wait(200);
    bar.show(100, "9 % unshot");
    const std::string line = onScreen(out.str());
    CAPTURE(line);
    double percent = 0.0, rate = 0.0, left = 0.0;
    const std::string numbers = line.substr(std::min(line.size(), line.find("] ")));
    REQUIRE(std::sscanf(numbers.c_str(), "] %lf %%, %lf shots/s, %lf s left, 9 %% unshot", &percent, &rate, &left) ==
            3);
    CHECK(line.find("shooting [######..................] 25 %") == 0);
    CHECK(line.find(" s left, 9 % unshot") != std::string::npos);
    CHECK(percent == 25.0);
    CHECK(rate <= 500.0);
    CHECK(rate > 5.0);
    CHECK(rate * left == Approx(300.0).epsilon(0.1));
}

TEST_CASE("without a unit there is no rate, and before the first step no time left") {
    std::ostringstream first, second;
    ProgressBar("reading", 10, "", first, true).show(0);
    CHECK(first.str().find("reading [........................] 0 %") != std::string::npos);
    CHECK(first.str().find("left") == std::string::npos);
    ProgressBar("reading", 10, "", second, true).show(5);
    CHECK(second.str().find("/s") == std::string::npos);
    CHECK(second.str().find("left") != std::string::npos);
}

TEST_CASE("more than all is all, and nothing to do is done") {
    std::ostringstream first, second;
    ProgressBar("work", 10, "", first, true).show(25);
    CHECK(first.str().find("[########################] 100 %") != std::string::npos);
    CHECK(first.str().find('-') == std::string::npos);
    ProgressBar("work", 0, "", second, true).show(0);
    CHECK(second.str().find("[########################] 100 %") != std::string::npos);
}

TEST_CASE("steps that cost nothing are left out of all") {
    std::ostringstream out;
    ProgressBar bar("work", 100, "", out, true);
    bar.skip(80);
    bar.show(5);
    CHECK(out.str().find("] 25 %") != std::string::npos);
}

TEST_CASE("a bar that is not visible is silent to its end") {
    std::ostringstream out;
    {
        ProgressBar bar("work", 10, "steps", out, false);
        bar.show(1);
        bar.show(10, "done");
    }
    CHECK(out.str().empty());
}

TEST_CASE("a shorter line leaves nothing of a longer one") {
    std::ostringstream out;
    ProgressBar bar("work", 10, "", out, true);
    bar.show(0, "a long word on the state of things");
    wait(120);
    bar.show(0, "short");
    CHECK(onScreen(out.str()) == "work [........................] 0 %, short");
}

TEST_CASE("the line is wiped when the bar goes") {
    std::ostringstream out;
    {
        ProgressBar bar("work", 10, "steps", out, true);
        bar.show(3);
        CHECK_FALSE(onScreen(out.str()).empty());
    }
    CHECK(onScreen(out.str()).empty());
    CHECK(out.str().back() == '\r');
    CHECK(out.str().find('\n') == std::string::npos);
}

TEST_CASE("the line is drawn at most ten times a second") {
    std::ostringstream out;
    const auto drawn = [&] {
        const std::string text = out.str();
        return std::count(text.begin(), text.end(), '[');
    };
    const Stopwatch watch;
    ProgressBar bar("work", 1e6, "steps", out, true);
    while (drawn() < 4) bar.show(watch.seconds());
    CHECK(watch.seconds() >= 0.3);
}

TEST_CASE("durations are told in the two units that matter") {
    CHECK(durationText(0.0) == "0.0 s");
    CHECK(durationText(0.42) == "0.4 s");
    CHECK(durationText(12.3) == "12 s");
    CHECK(durationText(60.0) == "1 min 0 s");
    CHECK(durationText(200.0) == "3 min 20 s");
    CHECK(durationText(3599.7) == "1 h 0 min");
    CHECK(durationText(7500.0) == "2 h 5 min");
}

TEST_CASE("no duration is told as 60 seconds") {
    CHECK(durationText(59.4) == "59 s");
    CHECK(durationText(59.7) == "1 min 0 s");
}

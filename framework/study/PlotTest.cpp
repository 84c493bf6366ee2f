#include "study/Plot.h"

#include <doctest/doctest.h>

#include "study/PlotScript.h"
#include "study/Wording.h"

using namespace radlab::study;
using doctest::Approx;

TEST_CASE("names that would overlap are moved apart, in their order and within the plot") {
    CHECK(spreadOut({0.1, 0.9}, 0.2, 0, 1) == std::vector<double>{0.1, 0.9});
    const std::vector<double> near = spreadOut({0.5, 0.5, 0.4}, 0.1, 0, 1);
    CHECK(near[2] == Approx(0.4));
    CHECK(near[0] == Approx(0.5));
    CHECK(near[1] == Approx(0.6));
    const std::vector<double> high = spreadOut({1.0, 0.98}, 0.1, 0, 1);
    CHECK(high[0] == Approx(1.0));
    CHECK(high[1] == Approx(0.9));
    const std::vector<double> crowded = spreadOut({0, 0, 0}, 0.6, 0, 1);
    CHECK(crowded[0] == Approx(0.0));
    CHECK(crowded[2] == Approx(1.2));
}

TEST_CASE("axes have a number for each power of ten, and 2 and 5 times these where there are few") {
    CHECK(ticsBetween(0.5, 2000).size() == 4);
    const std::vector<double> tics = ticsBetween(8, 60);
    REQUIRE(tics.size() == 3);
    CHECK(tics[0] == Approx(10));
    CHECK(tics[1] == Approx(20));
    CHECK(tics[2] == Approx(50));
}

TEST_CASE("shares, times and counts are told in words that fit their size") {
    CHECK(shareText(0.042) == "4.2\u00a0%");
    CHECK(shareText(3.1e-6) == "0.00031\u00a0%");
    CHECK(shareText(1.2345) == "123\u00a0%");
    CHECK(shareText(0.0997) == "10\u00a0%");
    CHECK(shareText(0.03, 1) == "3\u00a0%");
    CHECK(secondsText(0.00042) == "0.42 ms");
    CHECK(secondsText(0.25) == "0.25 s");
    CHECK(secondsText(48.2) == "48 s");
    CHECK(countText(65536) == "65,536");
    CHECK(countText(79) == "79");
}

TEST_CASE("text in a script stays text, whatever is in it") {
    Plot plot{"it's", {"time", Unit::seconds}, {"error", Unit::share}, {}, {}};
    CHECK(plotScript({plot}).empty());
    plot.curves.push_back({"point", "a 'quoted' `name`", {{0.01, 0.1}, {1, 0.001}}});
    const std::string script = plotScript({plot}, ".part");
    CHECK(script.find("set output 'it''s.svg.part'") != std::string::npos);
    CHECK(script.find("set output 'it''s_narrow.svg.part'") != std::string::npos);
    CHECK(script.find("'a ''quoted'' `name`'") != std::string::npos);
}

#include "grader/stages/ExponentFit.h"

#include <cmath>
#include <numbers>

#include <doctest/doctest.h>

#include "grader/stages/Meshes.h"

using namespace radlab::grader;

namespace {

constexpr double pi = std::numbers::pi;

struct Samples {
    Factor cosine{"the shooter's cosine", {}, 1.0, ""};
    Factor area{"the receiver's area", {}, 1.0, ""};
    Factor distance{"the distance", {}, -2.0, "r"};
    std::vector<double> ratios;

    template <class Ratio>
    explicit Samples(const Ratio& ratio, int count = 60, double noise = 0.0) {
        Random random(5);
        for (int i = 0; i < count; ++i) {
            const double c = random.between(0.1, 1.0), a = random.magnitude(0.01, 10), r = random.magnitude(0.1, 100);
            cosine.logs.push_back(std::log(c));
            area.logs.push_back(std::log(a));
            distance.logs.push_back(std::log(r));
            ratios.push_back(std::log(ratio(c, a, r)) + noise * random.between(-1, 1));
        }
    }
    std::string text() const {
        const auto found = fitExponents(ratios, {cosine, area, distance});
        return found ? found->text : "nothing";
    }
};

}  // namespace

TEST_CASE("single wrong factors are named") {
    CHECK(Samples([](double c, double, double) { return 1 / c; }).text().find("the shooter's cosine is missing") !=
          std::string::npos);
    CHECK(Samples([](double c, double, double) { return c; }).text().find("the shooter's cosine is squared") !=
          std::string::npos);
    CHECK(Samples([](double, double a, double) { return 1 / (a * a); })
              .text()
              .find("the receiver's area divides where it should multiply") != std::string::npos);
    CHECK(Samples([](double, double, double r) { return 1 / r; }).text().find("it falls as 1/r³, not 1/r²") !=
          std::string::npos);
    CHECK(Samples([](double, double, double r) { return r * r; }).text().find("the distance is missing") !=
          std::string::npos);
}

TEST_CASE("combinations are named, the constant among them") {
    const std::string text = Samples([](double, double a, double r) { return pi / (a * r); }).text();
    CHECK(text.find("the receiver's area is missing") != std::string::npos);
    CHECK(text.find("1/r³, not 1/r²") != std::string::npos);
    CHECK(text.find("all is π times") != std::string::npos);
    CHECK(Samples([](double, double, double) { return 1 / (4 * pi); }).text().find("all is 1/(4π) times") !=
          std::string::npos);
    CHECK(Samples([](double, double, double) { return 1.7; }).text().find("all is 1.7 times") != std::string::npos);
}

TEST_CASE("the noise of float arithmetic is no matter, another formula is not fitted") {
    CHECK(Samples([](double c, double, double) { return c; }, 60, 1e-5).text().find("squared") != std::string::npos);
    CHECK(Samples([](double c, double, double) { return 1 + c; }).text() == "nothing");
    CHECK(Samples([](double, double, double) { return 1.0; }).text() == "nothing");
    CHECK(Samples([](double c, double, double) { return c; }, 8).text() == "nothing");  // too few samples
}

// Stage 2, calcAnalyticalFF: form factors by the point to point formula.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "grader/stages/AnalyticalCases.h"
#include "grader/stages/AnalyticalMistakes.h"
#include "grader/stages/ExponentFit.h"
#include "grader/stages/PairFormula.h"

namespace radlab::grader {

namespace {

class AnalyticalFF : public Stage {
public:
    std::string function() const override { return "calcAnalyticalFF"; }
    std::vector<Check> checks(std::uint64_t seed) const override { return analyticalChecks(seed); }
    std::vector<Computation> right() const override { return {fillsFormFactors()}; }
    Numbers numbers(const Step& step, const State& before, const Outcome& outcome) const override;
    std::string name(const Step& step, std::size_t k) const override;
    std::string show(const Step& step, std::size_t k, double value) const override;
    std::string tolerance() const override { return "0.03 %, as π to 4 digits and float arithmetic need"; }
    std::vector<Mistake> mistakes() const override { return analyticalMistakes(); }
    std::optional<Diagnosis> fit(const std::vector<Comparison>& comparisons) const override;
    std::vector<std::string> inputs() const override { return {"center", "normal", "area", "unshot_rad"}; }
};

Numbers AnalyticalFF::numbers(const Step& step, const State& before, const Outcome& outcome) const {
    Numbers numbers{{static_cast<double>(outcome.returned)}, {0.0}};
    for (std::size_t j = 0; j < before.patches.size(); ++j) {
        const auto value = static_cast<double>(outcome.state.patches[j].formF);
        double slack = 3e-4 * std::abs(value);
        const MyPolygon &from = before.patches[static_cast<std::size_t>(step.shooter)], &to = before.patches[j];
        const Pair pair = pairOf(from, to);
        // What float rounding of the centres does to a cosine.
        if (pair.distance > 0.0)
            slack +=
                pair.areaTo / (std::numbers::pi * pair.distance * pair.distance) *
                (2e-6 + 5e-7 * static_cast<double>(glm::length(from.center) + glm::length(to.center)) / pair.distance);
        numbers.values.push_back(value);
        numbers.slack.push_back(slack);
    }
    return numbers;
}

std::string AnalyticalFF::name(const Step&, std::size_t k) const {
    if (k == 0) return "the patch returned";
    return "polygons[" + std::to_string(k - 1) + "]->formF";
}

std::string AnalyticalFF::show(const Step& step, std::size_t k, double value) const {
    if (k > 0) return Stage::show(step, k, value);
    if (value < 0) return value == -1 ? "nullptr" : "a patch that is not in `polygons` (a copy?)";
    return "polygons[" + std::to_string(static_cast<int>(value)) + "]";
}

std::optional<Diagnosis> AnalyticalFF::fit(const std::vector<Comparison>& comparisons) const {
    Factor from{"the shooter's cosine", {}}, to{"the receiver's cosine", {}}, areaTo{"the receiver's area", {}},
        areaFrom{"the shooter's area", {}, 0.0}, distance{"the distance", {}, -2.0, "r"};
    std::vector<double> ratios;
    for (const Comparison& comparison : comparisons)
        for (std::size_t j = 0; j < comparison.before.patches.size(); ++j) {
            if (static_cast<int>(j) == comparison.step.shooter) continue;
            const MyPolygon& shooter = comparison.before.patches[static_cast<std::size_t>(comparison.step.shooter)];
            const Pair pair = pairOf(shooter, comparison.before.patches[j]);
            if (!(pair.cosineFrom > 0.02 && pair.cosineTo > 0.02)) continue;
            const double ratio = comparison.found.values[j + 1] / pointToPoint(pair);
            if (!(ratio > 0.0)) return std::nullopt;
            ratios.push_back(std::log(ratio));
            from.logs.push_back(std::log(pair.cosineFrom));
            to.logs.push_back(std::log(pair.cosineTo));
            areaTo.logs.push_back(std::log(pair.areaTo));
            areaFrom.logs.push_back(std::log(pair.areaFrom));
            distance.logs.push_back(std::log(pair.distance));
        }
    return fitExponents(ratios, {from, to, areaTo, areaFrom, distance});
}

}  // namespace

std::unique_ptr<Stage> analyticalStage() { return std::make_unique<AnalyticalFF>(); }

}  // namespace radlab::grader

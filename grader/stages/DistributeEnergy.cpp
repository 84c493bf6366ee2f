// Stage 3, distributeEnergy: one shot, from one patch to all others.

#include <algorithm>
#include <cmath>
#include <limits>

#include "grader/stages/DistributeCases.h"
#include "grader/stages/DistributeMistakes.h"
#include "grader/stages/ExponentFit.h"

namespace radlab::grader {

namespace {

class DistributeEnergy : public Stage {
public:
    std::string function() const override { return "distributeEnergy"; }
    std::vector<Check> checks(std::uint64_t seed) const override { return distributeChecks(seed); }
    std::vector<Computation> right() const override { return {distributes()}; }
    Numbers numbers(const Step& step, const State& before, const Outcome& outcome) const override;
    std::string name(const Step& step, std::size_t k) const override;
    std::string show(const Step& step, std::size_t k, double value) const override;
    std::string tolerance() const override {
        return "0.002 % of what was there and what is added: float arithmetic in any order";
    }
    std::vector<Mistake> mistakes() const override { return distributeMistakes(); }
    std::optional<Diagnosis> fit(const std::vector<Comparison>& comparisons) const override;
    std::vector<std::string> inputs() const override {
        return {"diffuse", "emissive", "area", "formF", "rad", "unshot_rad"};
    }
};

constexpr double anything = std::numeric_limits<double>::infinity();

bool wants(const Step& step, const std::string& member) {
    return std::find(step.wanted.begin(), step.wanted.end(), "patch." + member) != step.wanted.end();
}

// The numbers of a patch, one after the other.
struct PatchNumber {
    const char* member;
    Vec3f MyPolygon::*color;  // either this or the next
    float MyPolygon::*number;
    int channels;
};

const std::vector<PatchNumber> patchNumbers = {
    {"rad", &MyPolygon::rad, nullptr, 3},         {"unshot_rad", &MyPolygon::unshot_rad, nullptr, 3},
    {"diffuse", &MyPolygon::diffuse, nullptr, 3}, {"emissive", &MyPolygon::emissive, nullptr, 3},
    {"area", nullptr, &MyPolygon::area, 1},       {"formF", nullptr, &MyPolygon::formF, 1},
};
constexpr std::size_t numbersOfPatch = 14;

double valueOf(const MyPolygon& patch, const PatchNumber& number, int channel) {
    return double(number.color ? (patch.*number.color)[channel] : patch.*number.number);
}

Numbers DistributeEnergy::numbers(const Step& step, const State& before, const Outcome& outcome) const {
    // What is returned is compared only where it is asked for: one mistake costs its own marks.
    const bool compared = step.shooter < 0 || step.wanted.empty();
    Numbers numbers{{static_cast<double>(outcome.returned)}, {compared ? 0.0 : anything}};
    for (std::size_t j = 0; j < before.patches.size(); ++j)
        for (const PatchNumber& number : patchNumbers)
            for (int c = 0; c < number.channels; ++c) {
                const double value = valueOf(outcome.state.patches[j], number, c);
                const double was = valueOf(before.patches[j], number, c);
                numbers.values.push_back(value);
                numbers.slack.push_back(wants(step, number.member) ? 2e-5 * (std::abs(was) + std::abs(value - was))
                                                                   : anything);
            }
    return numbers;
}

std::string DistributeEnergy::name(const Step& step, std::size_t k) const {
    if (k == 0) return "what is returned";
    std::size_t place = (k - 1) % numbersOfPatch;
    const std::size_t patch = (k - 1) / numbersOfPatch;
    std::string text = "polygons[" + std::to_string(patch) + "]->";
    for (const PatchNumber& number : patchNumbers) {
        const auto channelCount = static_cast<std::size_t>(number.channels);
        if (place < channelCount) {
            text += number.member + (number.color ? "[" + std::to_string(place) + "]" : std::string());
            break;
        }
        place -= channelCount;
    }
    return static_cast<int>(patch) == step.shooter ? text + " (the shooter)" : text;
}

std::string DistributeEnergy::show(const Step& step, std::size_t k, double value) const {
    if (k == 0) return value == 0.0 ? "false" : "true";
    return Stage::show(step, k, value);
}

// The fit on what dark patches have gained: there the gain is known to full precision.
std::optional<Diagnosis> fitGains(const std::vector<Comparison>& comparisons, std::size_t member) {
    Factor reflectance{"the reflectance"}, shooters{"the shooter's reflectance", {}, 0.0},
        formFactor{"the form factor"}, areaFrom{"the shooter's area"}, areaTo{"the receiver's area", {}, -1.0},
        light{"the shooter's unshot_rad"};
    std::vector<double> ratios;
    for (const Comparison& comparison : comparisons) {
        if (comparison.step.shooter < 0 || !wants(comparison.step, patchNumbers[member].member)) continue;
        const MyPolygon& from = comparison.before.patches[static_cast<std::size_t>(comparison.step.shooter)];
        for (std::size_t j = 0; j < comparison.before.patches.size(); ++j)
            for (int c = 0; c < 3; ++c) {
                const MyPolygon& to = comparison.before.patches[j];
                const std::size_t k = 1 + numbersOfPatch * j + 3 * member + static_cast<std::size_t>(c);
                const double expected = comparison.expected.values[k], found = comparison.found.values[k];
                if (valueOf(to, patchNumbers[member], c) != 0.0 || !(expected > 0.0)) continue;
                if (!(found > 0.0)) return std::nullopt;
                ratios.push_back(std::log(found / expected));
                reflectance.logs.push_back(std::log(double(to.diffuse[c])));
                shooters.logs.push_back(std::log(double(from.diffuse[c])));
                formFactor.logs.push_back(std::log(double(to.formF)));
                areaFrom.logs.push_back(std::log(double(from.area)));
                areaTo.logs.push_back(std::log(double(to.area)));
                light.logs.push_back(std::log(double(from.unshot_rad[c])));
            }
    }
    return fitExponents(ratios, {reflectance, shooters, formFactor, areaFrom, areaTo, light});
}

std::optional<Diagnosis> DistributeEnergy::fit(const std::vector<Comparison>& comparisons) const {
    for (const std::size_t member : {std::size_t{0}, std::size_t{1}})
        if (std::optional<Diagnosis> found = fitGains(comparisons, member)) return found;
    return std::nullopt;
}

}  // namespace

std::unique_ptr<Stage> distributeStage() { return std::make_unique<DistributeEnergy>(); }

}  // namespace radlab::grader

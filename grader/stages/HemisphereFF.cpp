// Extension 1, hemisphereFF: form factors by rays over the hemisphere.

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "grader/stages/HemisphereCases.h"
#include "grader/stages/HemisphereMistakes.h"
#include "grader/stages/HemisphereRays.h"

namespace radlab::grader {

namespace {

constexpr int enoughRays = 64;  // for several patches to be met by some

// The patch returned, formF of all patches, their sum, and whether they are shares of rays.
class HemisphereFF : public Stage {
public:
    std::string function() const override { return "hemisphereFF"; }
    std::vector<Check> checks(std::uint64_t seed) const override { return hemisphereChecks(seed); }
    std::vector<Computation> right() const override;
    Numbers numbers(const Step& step, const State& before, const Outcome& outcome) const override;
    std::string name(const Step& step, std::size_t k) const override;
    std::string show(const Step& step, std::size_t k, double value) const override;
    std::string tolerance() const override { return "what chance takes it to once in 10¹² times"; }
    std::vector<Mistake> mistakes() const override;
    std::optional<Diagnosis> fit(const std::vector<Comparison>& comparisons) const override;
    std::vector<std::string> inputs() const override {
        return {"corners", "positions", "center", "normal", "area", "formF", "unshot_rad"};
    }

private:
    RayShooter shooter;
};

// From the centre, as the hemicube looks; from all over the patch is the better form factor.
std::vector<Computation> HemisphereFF::right() const {
    RayUse fromArea;
    fromArea.name = "from the area";
    fromArea.fromArea = true;
    return {shooter.shoots({}), shooter.shoots(fromArea)};
}

Numbers HemisphereFF::numbers(const Step& step, const State& before, const Outcome& outcome) const {
    const bool computed = !outcome.pixels.empty();
    Numbers numbers{{static_cast<double>(outcome.returned)}, {0.0}};
    double sum = 0.0;
    for (std::size_t j = 0; j < before.patches.size(); ++j) {
        numbers.values.push_back(static_cast<double>(outcome.state.patches[j].formF));
        numbers.slack.push_back(computed ? outcome.slack[j] : 0.0);
        sum += numbers.values.back();
    }
    numbers.values.push_back(sum);
    numbers.slack.push_back(computed ? outcome.pixels[1] : 0.0);
    const bool counted = step.samples <= fewRays && !(computed && std::isnan(outcome.pixels[0]));
    numbers.values.push_back(computed ? outcome.pixels[0] : areShares(outcome.state, step.samples) ? 0.0 : 1.0);
    numbers.slack.push_back(counted ? 0.5 : std::numeric_limits<double>::infinity());
    return numbers;
}

std::string HemisphereFF::name(const Step& step, std::size_t k) const {
    if (k == 0) return "the patch returned";
    const std::size_t patches = step.unshot.size();
    if (k == patches + 1) return "the sum of all formF";
    if (k == patches + 2) return "every formF times " + std::to_string(step.samples) + " rays";
    const std::string patch = "polygons[" + std::to_string(k - 1) + "]->formF";
    return static_cast<int>(k) - 1 == step.shooter ? patch + " (the shooter's own)" : patch;
}

std::string HemisphereFF::show(const Step& step, std::size_t k, double value) const {
    if (k == step.unshot.size() + 2) return value == 0.0 ? "a whole number" : "not a whole number";
    if (k > 0) return Stage::show(step, k, value);
    if (value < 0) return value == -1 ? "nullptr" : "a patch that is not in `polygons` (a copy?)";
    return "polygons[" + std::to_string(static_cast<int>(value)) + "]";
}

std::vector<Mistake> HemisphereFF::mistakes() const {
    std::vector<Mistake> all;
    for (const RayMistake& mistake : rayMistakes())
        all.push_back({mistake.id, mistake.text, mistake.hint, shooter.shoots(mistake.use)});
    return all;
}

// Where all rays go the same way, chance says whom they meet, so that no computation could.
std::optional<Diagnosis> HemisphereFF::fit(const std::vector<Comparison>& comparisons) const {
    int shots = 0;
    for (const Comparison& comparison : comparisons) {
        const auto patches = static_cast<std::ptrdiff_t>(comparison.before.patches.size());
        if (patches == 0 || comparison.step.samples < enoughRays) continue;
        const auto begin = comparison.found.values.begin() + 1, end = begin + patches;
        if (std::count(begin, end, 0.0) + std::count_if(begin, end, [](double f) { return std::abs(f - 1) < 1e-3; }) <
            patches)
            return std::nullopt;
        if (std::accumulate(begin, end, 0.0) > 0.5) ++shots;
    }
    if (shots < 3) return std::nullopt;
    return Diagnosis{
        "one-direction",
        "All rays of a shot go the same way: whatever patch they meet gets them all. Random numbers that are "
        "drawn once, before the loop, or from a generator that starts anew for each ray, are always the same.",
        "Where is random.next called: for each ray, or once?"};
}

}  // namespace

std::unique_ptr<Stage> hemisphereStage() { return std::make_unique<HemisphereFF>(); }

}  // namespace radlab::grader

// Stage 6, calcFF: form factors by hemicube.

#include "grader/stages/HemicubeFFCases.h"
#include "grader/stages/HemicubeFFWays.h"
#include "grader/stages/HemicubeShot.h"

namespace radlab::grader {

namespace {

class HemicubeFF : public Stage {
public:
    std::string function() const override { return "calcFF"; }
    std::vector<Check> checks(std::uint64_t seed) const override { return hemicubeChecks(seed); }
    std::vector<Computation> right() const override { return {shooter.shoots({})}; }
    Numbers numbers(const Step& step, const State& before, const Outcome& outcome) const override;
    std::string name(const Step& step, std::size_t k) const override;
    std::string show(const Step& step, std::size_t k, double value) const override;
    std::string tolerance() const override { return "the pixels at the patch's edges, and float sums"; }
    std::vector<Mistake> mistakes() const override;
    std::vector<std::string> inputs() const override {
        return {"corners", "positions", "center", "normal", "area", "formF", "unshot_rad"};
    }

private:
    HemicubeShooter shooter;
};

Numbers HemicubeFF::numbers(const Step&, const State& before, const Outcome& outcome) const {
    Numbers numbers{{static_cast<double>(outcome.returned)}, {0.0}};
    for (std::size_t j = 0; j < before.patches.size(); ++j) {
        numbers.values.push_back(static_cast<double>(outcome.state.patches[j].formF));
        numbers.slack.push_back(outcome.slack.empty() ? 0.0 : outcome.slack[j]);
    }
    return numbers;
}

std::string HemicubeFF::name(const Step& step, std::size_t k) const {
    if (k == 0) return "the patch returned";
    const std::string patch = "polygons[" + std::to_string(k - 1) + "]->formF";
    return static_cast<int>(k) - 1 == step.shooter ? patch + " (the shooter's own)" : patch;
}

std::string HemicubeFF::show(const Step& step, std::size_t k, double value) const {
    if (k > 0) return Stage::show(step, k, value);
    if (value < 0) return value == -1 ? "nullptr" : "a patch that is not in `polygons` (a copy?)";
    return "polygons[" + std::to_string(static_cast<int>(value)) + "]";
}

// Special ones before general ones.
std::vector<Mistake> HemicubeFF::mistakes() const {
    const Ways ways(shooter);
    std::vector<Mistake> all;
    for (const std::vector<Mistake>& some : {cameraMistakes(ways), pixelMistakes(ways), resultMistakes(ways)})
        all.insert(all.end(), some.begin(), some.end());
    return all;
}

}  // namespace

std::unique_ptr<Stage> hemicubeStage() { return std::make_unique<HemicubeFF>(); }

}  // namespace radlab::grader

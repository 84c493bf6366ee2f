// Stage 4, colorReconstruction: radiosities turned into colours, flat and smooth.

#include <algorithm>
#include <cmath>

#include "grader/stages/ColorCases.h"
#include "grader/stages/ColorMistakes.h"

namespace radlab::grader {

namespace {

class ColorReconstruction : public Stage {
public:
    std::string function() const override { return "colorReconstruction"; }
    std::vector<Check> checks(std::uint64_t seed) const override { return colorChecks(seed); }
    std::vector<Computation> right() const override { return {reconstructs()}; }
    Numbers numbers(const Step& step, const State& before, const Outcome& outcome) const override;
    std::string name(const Step& step, std::size_t k) const override;
    std::string show(const Step& step, std::size_t k, double value) const override;
    std::string tolerance() const override { return "0.03 %: π to 4 digits, float sums; counts exactly"; }
    std::vector<Mistake> mistakes() const override { return colorMistakes(); }
    std::vector<std::string> inputs() const override { return {"corners", "rad"}; }
};

bool wants(const Step& step, const std::string& member) {
    return std::find(step.wanted.begin(), step.wanted.end(), member) != step.wanted.end();
}

// The numbers of one step: those of the vertices if it asks for them, else those of the patches.
Numbers ColorReconstruction::numbers(const Step& step, const State&, const Outcome& outcome) const {
    Numbers numbers;
    const auto add = [&](double value, double tolerance) {
        numbers.values.push_back(value);
        numbers.slack.push_back(std::isfinite(value) ? tolerance * std::abs(value) : 0.0);
    };
    const auto addColor = [&](const Vec3f& color) {
        for (int c = 0; c < 3; ++c) add(double(color[c]), 3e-4);
    };
    if (wants(step, "patch.color"))
        for (const MyPolygon& patch : outcome.state.patches) addColor(patch.color);
    for (const MyVertex& corner : outcome.state.corners) {
        if (wants(step, "corner.color")) addColor(corner.color);
        if (wants(step, "corner.rad")) addColor(corner.rad);
        if (wants(step, "corner.colorcount")) add(corner.colorcount, 0.0);
    }
    return numbers;
}

std::string ColorReconstruction::name(const Step& step, std::size_t k) const {
    if (wants(step, "corner.colorcount")) return "vertices[" + std::to_string(k) + "]->colorcount";
    const std::string channel = "[" + std::to_string(k % 3) + "]", index = "[" + std::to_string(k / 3) + "]";
    if (wants(step, "patch.color")) return "polygons" + index + "->color" + channel;
    return "vertices" + index + (wants(step, "corner.rad") ? "->rad" : "->color") + channel;
}

std::string ColorReconstruction::show(const Step& step, std::size_t k, double value) const {
    return wants(step, "corner.colorcount") ? std::to_string(static_cast<long long>(value))
                                            : Stage::show(step, k, value);
}

}  // namespace

std::unique_ptr<Stage> colorStage() { return std::make_unique<ColorReconstruction>(); }

}  // namespace radlab::grader

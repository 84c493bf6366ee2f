// Extension 2, antialias: a picture of mean radiances.

#include <algorithm>
#include <cmath>
#include <limits>

#include "display/RayView.h"
#include "grader/stages/AntiAliasCases.h"
#include "grader/stages/AntiAliasMistakes.h"
#include "grader/stages/PicturePatches.h"

namespace radlab::grader {

namespace {

constexpr double slack = 1e-3;      // of a display value: float sums through a tone curve
constexpr float nearEdge = 1e-3f;   // pixels: a sample nearer to an edge may see either side
constexpr Vec3f heldBefore(0.25f);  // by the picture

// Notes whether any sample lay so near an edge that rounding decides what it sees.
class CarefulView : public PictureView {
public:
    explicit CarefulView(const RayView& shown) : view(shown) {}

    Vec3f radiance(float x, float y) const override {
        const Vec3f here = view.radiance(x, y);
        for (const float dx : {-nearEdge, nearEdge})
            for (const float dy : {-nearEdge, nearEdge}) unsure = unsure || view.radiance(x + dx, y + dy) != here;
        return here;
    }
    Vec3f display(const Vec3f& radiance) const override { return view.display(radiance); }

    mutable bool unsure = false;

private:
    const RayView& view;
};

Computation shows(const PixelRule& rule, bool upsideDown = false) {
    return [rule, upsideDown](const Situation& at) {
        PicturePatches patches(at.before);
        const RayCaster caster(patches.polygons, patches.corners);
        const RayView plain(caster, at.step.view, at.step.width, at.step.height, 1.0f);
        CarefulView view(plain);
        Outcome outcome;
        outcome.state = at.before;
        for (int row = 0; row < at.step.height; ++row)
            for (int column = 0; column < at.step.width; ++column) {
                const int y = upsideDown ? at.step.height - 1 - row : row;
                view.unsure = false;
                const Vec3f shown =
                    rule(view, static_cast<float>(column), static_cast<float>(y), at.step.samples, heldBefore);
                for (int channel = 0; channel < 3; ++channel) {
                    outcome.pixels.push_back(static_cast<double>(shown[channel]));
                    outcome.slack.push_back(view.unsure ? std::numeric_limits<double>::infinity() : slack);
                }
            }
        return outcome;
    };
}

class AntiAlias : public Stage {
public:
    std::string function() const override { return "antialias"; }
    std::vector<Check> checks(std::uint64_t seed) const override { return antialiasChecks(seed); }
    std::vector<Computation> right() const override { return {shows(antialiasedPixel)}; }
    Numbers numbers(const Step&, const State&, const Outcome& outcome) const override {
        return pictureNumbers(outcome);
    }
    std::string name(const Step& step, std::size_t k) const override { return pixelName(step, k); }
    std::string tolerance() const override { return "0.001 of white"; }
    std::vector<Mistake> mistakes() const override {
        std::vector<Mistake> all;
        for (const PixelMistake& mistake : samplingMistakes())
            all.push_back({mistake.id, mistake.text, mistake.hint, shows(mistake.rule, mistake.upsideDown)});
        return all;
    }
    std::vector<std::string> inputs() const override { return {"corners", "positions", "color"}; }
};

}  // namespace

std::unique_ptr<Stage> antialiasStage() { return std::make_unique<AntiAlias>(); }

}  // namespace radlab::grader

// Extension 3, mirrorScene: a mirror by a second pass.

#include <limits>

#include "display/RayMirrorPass.h"
#include "grader/stages/MirrorCases.h"
#include "grader/stages/MirrorMistakes.h"
#include "grader/stages/PicturePatches.h"

namespace radlab::grader {

namespace {

constexpr double slack = 1e-4;      // of a radiance
constexpr float nearEdge = 0.005f;  // pixels: a ray nearer to an edge may see either side

// Whether rounding may decide what is seen in a pixel, for each of them.
std::vector<bool> unsurePixels(const RayMirrorPass& pass, const glm::mat4& world, const glm::vec4& clip, bool clockwise,
                               const Image& centre) {
    std::vector<bool> unsure(centre.data().size());
    for (const float dx : {-nearEdge, nearEdge})
        for (const float dy : {-nearEdge, nearEdge}) {
            const Image near = pass.drawAt(Vec3f(0.5f + dx, 0.5f + dy, 0.0f), world, clip, clockwise);
            for (std::size_t i = 0; i < unsure.size(); ++i) unsure[i] = unsure[i] || near.data()[i] != centre.data()[i];
        }
    return unsure;
}

Computation shows(const MirrorWay& way) {
    return [way](const Situation& at) {
        PicturePatches patches(at.before);
        const MyPolygon* mirror = patches.polygons[static_cast<std::size_t>(at.step.shooter)];
        const RayMirrorPass pass(
            patches.polygons, patches.corners, [=](const MyPolygon* patch) { return patch == mirror; }, at.step.view,
            at.step.width, at.step.height);
        const MirrorPlane plane{at.step.mirror[0], at.step.mirror[1], at.step.mirror[2]};
        const glm::mat4 world = way.worldFor(plane);
        const glm::vec4 clip = way.clipFor(plane);
        const Image held = pass.first(), seen = pass.draw(world, clip, way.clockwise);
        const std::vector<bool> unsure = unsurePixels(pass, world, clip, way.clockwise, seen);
        Outcome outcome;
        outcome.state = at.before;
        for (int y = 0; y < at.step.height; ++y)
            for (int x = 0; x < at.step.width; ++x) {
                const bool changed = way.everywhere || pass.showsMirror(x, y);
                const Vec3f value = changed ? way.combine(plane, held.at(x, y), seen.at(x, y)) : held.at(x, y);
                const bool open = changed && unsure[static_cast<std::size_t>(y * at.step.width + x)];
                for (int channel = 0; channel < 3; ++channel) {
                    outcome.pixels.push_back(static_cast<double>(value[channel]));
                    outcome.slack.push_back(open ? std::numeric_limits<double>::infinity() : slack);
                }
            }
        return outcome;
    };
}

class Mirror : public Stage {
public:
    std::string function() const override { return "mirrorScene"; }
    std::vector<Check> checks(std::uint64_t seed) const override { return mirrorChecks(seed); }
    std::vector<Computation> right() const override { return {shows({})}; }
    Numbers numbers(const Step&, const State&, const Outcome& outcome) const override {
        return pictureNumbers(outcome);
    }
    std::string name(const Step& step, std::size_t k) const override { return pixelName(step, k); }
    std::string tolerance() const override { return "0.0001 of a radiance of 1"; }
    std::vector<Mistake> mistakes() const override {
        std::vector<Mistake> all;
        for (const MirrorMistake& mistake : mirrorMistakes())
            all.push_back({mistake.id, mistake.text, mistake.hint, shows(mistake.way)});
        return all;
    }
    std::vector<std::string> inputs() const override { return {"corners", "positions", "color"}; }
};

}  // namespace

std::unique_ptr<Stage> mirrorStage() { return std::make_unique<Mirror>(); }

}  // namespace radlab::grader

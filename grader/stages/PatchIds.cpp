// Stage 5, renderPatchIDs: patches drawn in the colours of their IDs.

#include "grader/stages/IdDrawing.h"
#include "grader/stages/PatchIdCases.h"
#include "grader/stages/PatchIdMistakes.h"

namespace radlab::grader {

namespace {

class PatchIds : public Stage {
public:
    std::string function() const override { return "renderPatchIDs"; }
    std::vector<Check> checks(std::uint64_t seed) const override { return patchIdChecks(seed); }
    std::vector<Computation> right() const override { return {drawer.draws({})}; }
    Numbers numbers(const Step&, const State&, const Outcome& outcome) const override {
        return {outcome.pixels, outcome.slack};
    }
    std::string name(const Step& step, std::size_t k) const override;
    std::string show(const Step& step, std::size_t k, double value) const override;
    std::string tolerance() const override { return "none; pixels at the edges of patches are not judged"; }
    std::vector<Mistake> mistakes() const override { return patchIdMistakes(drawer); }
    std::vector<std::string> inputs() const override { return {"corners", "positions"}; }

private:
    IdDrawer drawer;
};

std::string PatchIds::name(const Step& step, std::size_t k) const {
    const auto width = static_cast<std::size_t>(step.width);
    return "pixel (" + std::to_string(k % width) + ", " + std::to_string(k / width) + ")";
}

std::string PatchIds::show(const Step&, std::size_t, double value) const {
    const auto id = static_cast<int>(value);
    const std::string bytes =
        "(" + std::to_string(id >> 16) + ", " + std::to_string(id >> 8 & 255) + ", " + std::to_string(id & 255) + ")";
    return bytes + (id == 0 ? ", the background" : ", the ID " + std::to_string(id));
}

}  // namespace

std::unique_ptr<Stage> patchIdStage() { return std::make_unique<PatchIds>(); }

}  // namespace radlab::grader

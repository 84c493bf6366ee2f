#include "grader/stages/Pictures.h"

#include <algorithm>
#include <cmath>

#include "base/Error.h"
#include "course/PatchMesh.h"
#include "display/FalseColor.h"
#include "display/ToneMap.h"
#include "grader/stages/Meshes.h"
#include "grader/stages/PictureDraw.h"
#include "grader/stages/Stage.h"
#include "scene/X3dReader.h"

namespace radlab::grader {

namespace {

using Steps = std::vector<Step>;
using Answers = std::vector<StepAnswer>;

constexpr float patchSize = 50.0f;  // about 700 patches
constexpr int shotsInOrder = 60;    // of the picture of who shoots when
constexpr int shotsToSolve = 150;
constexpr int hemicubeSize = 128;
constexpr double energyTolerance = 0.01;

// The Cornell box, as it is before the first shot, and solved by formula.
struct Box {
    State state;
    Camera camera;
    State solved;
};

// What a right program leaves behind after a step.
State after(const Stage& stage, const Step& step) {
    const StepAnswer nobody;
    return stage.right().front()({*step.state, step, nobody, nullptr}).state;
}

int brightest(const State& state) {
    const auto power = [](const MyPolygon& p) {
        return glm::length(glm::dvec3(p.unshot_rad)) * static_cast<double>(p.area);
    };
    const auto found = std::max_element(state.patches.begin(), state.patches.end(),
                                        [&](const MyPolygon& a, const MyPolygon& b) { return power(a) < power(b); });
    return static_cast<int>(found - state.patches.begin());
}

Step stepOn(const std::string& function, const State& state, const std::vector<std::string>& wanted) {
    Step step;
    step.function = function;
    step.state = state;
    step.shooter = brightest(state);
    step.wanted = wanted;
    return step;
}

// Shoots by formula, and shows the state before each shot.
template <class Visit>
State shoot(State state, int shots, const Visit& visit) {
    const auto formFactors = analyticalStage(), distribute = distributeStage();
    for (int i = 0; i < shots; ++i) {
        visit(state);
        const Step step = stepOn("", state, {});
        Step next = step;
        next.state = after(*formFactors, step);
        state = after(*distribute, next);
    }
    return state;
}

Box boxOf(const std::string& scene) {
    const Scene read = readX3d(RADLAB_SOURCE_DIR "/resources/scenes/" + scene);
    PatchMesh mesh(read.vertices, read.faces, patchSize, 1e4f);
    mesh.reset();
    // Walls that mirror each other would shoot at the same moment: which one first, rounding would decide.
    Random random(7);
    for (MyPolygon& patch : mesh.patches) patch.diffuse *= static_cast<float>(random.between(0.9, 1.0));
    const State state = {mesh.patches, mesh.corners};
    return {state, read.cameras.at(0), shoot(state, shotsToSolve, [](const State&) {})};
}

const Box& emptyBox() {
    static const Box box = boxOf("cornell_1.x3d");
    return box;
}

const Box& furnishedBox() {
    static const Box box = boxOf("cornell_2.x3d");
    return box;
}

// Toned like the reference: the exposure comes from what is right.
Image tonedLike(const Image& right, const Image& radiance) { return toneMap(radiance, autoExposure(right)); }

// White hot is the largest form factor that the formula gives for the light.
Image heatPicture(const Box& box, const State& found) {
    const State right = after(*analyticalStage(), stepOn("", box.state, {}));
    float largest = 0.0f;
    for (const MyPolygon& patch : right.patches) largest = std::max(largest, patch.formF);
    return drawFlat(box.state, box.camera, [&](std::size_t i) { return heatColor(found.patches[i].formF / largest); });
}

PictureCase orderPicture() {
    const auto steps = [] {
        Steps all;
        shoot(emptyBox().state, shotsInOrder, [&](const State& state) {
            Step step = stepOn("maxenergy_patch", state, {});
            if (!all.empty()) {
                step.state.reset();
                for (const MyPolygon& patch : state.patches) step.unshot.push_back(patch.unshot_rad);
            }
            all.push_back(std::move(step));
        });
        return all;
    };
    const auto draw = [](const Steps&, const Answers& answers) {
        std::vector<glm::vec3> colors(emptyBox().state.patches.size(), glm::vec3(0.15f));
        for (std::size_t k = answers.size(); k-- > 0;)
            if (answers[k].returned >= 0)
                colors[static_cast<std::size_t>(answers[k].returned)] =
                    heatColor(1.0f - 0.8f * static_cast<float>(k) / static_cast<float>(answers.size()));
        return drawFlat(emptyBox().state, emptyBox().camera, [&](std::size_t i) { return colors[i]; });
    };
    return {"max.picture", steps, draw, {}};
}

PictureCase formFactorPicture() {
    return {"ff.picture",
            [] { return Steps{stepOn("calcAnalyticalFF", emptyBox().state, {"patch.formF"})}; },
            [](const Steps&, const Answers& answers) { return heatPicture(emptyBox(), answers[0].state); },
            {}};
}

Image reflectedLight(const State& state) {
    const State& box = emptyBox().state;
    return drawFlat(box, emptyBox().camera, [&](std::size_t i) {
        return (state.patches[i].rad - box.patches[i].emissive) * static_cast<float>(M_1_PI);
    });
}

PictureCase shotPicture() {
    const auto steps = [] {
        const Step row = stepOn("", emptyBox().state, {});
        return Steps{stepOn("distributeEnergy", after(*analyticalStage(), row), {"patch.rad", "patch.unshot_rad"})};
    };
    const auto draw = [](const Steps& asked, const Answers& answers) {
        return tonedLike(reflectedLight(after(*distributeStage(), asked[0])), reflectedLight(answers[0].state));
    };
    return {"dist.picture", steps, draw, {}};
}

Image smoothBox(const State& state, const Box& box) {
    return drawSmooth(box.state, box.camera, [&](std::size_t k) { return state.corners[k].color; });
}

PictureCase smoothPicture() {
    const auto steps = [] {
        return Steps{stepOn("colorReconstruction", emptyBox().solved, {"patch.color", "corner.color"})};
    };
    const auto draw = [](const Steps& asked, const Answers& answers) {
        return tonedLike(smoothBox(after(*colorStage(), asked[0]), emptyBox()),
                         smoothBox(answers[0].state, emptyBox()));
    };
    return {"color.picture", steps, draw, {}};
}

PictureCase idPicture() {
    const auto steps = [] {
        Step step = stepOn("renderPatchIDs", furnishedBox().state, {});
        step.width = step.height = pictureSize;
        step.view = glm::mat4(clipFromWorld(furnishedBox().state, furnishedBox().camera));
        return Steps{step};
    };
    const auto draw = [](const Steps&, const Answers& answers) {
        Image image(pictureSize, pictureSize);
        const std::vector<std::uint8_t>& bytes = answers[0].pixels;
        for (int y = 0; y < pictureSize; ++y)
            for (int x = 0; x < pictureSize; ++x) {
                const std::size_t at = 3 * (static_cast<std::size_t>(y) * pictureSize + static_cast<std::size_t>(x));
                image.at(x, pictureSize - 1 - y) =
                    idColor(static_cast<std::size_t>(bytes[at]) << 16 | static_cast<std::size_t>(bytes[at + 1]) << 8 |
                            bytes[at + 2]);
            }
        return image;
    };
    return {"ids.picture", steps, draw, {}};
}

PictureCase hemicubePicture() {
    const auto steps = [] {
        Step step = stepOn("calcFF", furnishedBox().state, {"patch.formF"});
        step.hemicubeSize = 2 * hemicubeSize;
        return Steps{step};
    };
    return {"hemi.picture",
            steps,
            [](const Steps&, const Answers& answers) { return heatPicture(furnishedBox(), answers[0].state); },
            {}};
}

// Where the emitted power is: on the way still, absorbed, or out of the open front.
struct Balance {
    double emitted = 0.0, absorbed = 0.0, unshot = 0.0;
};

Balance balanceOf(const State& state) {
    Balance sum;
    for (const MyPolygon& patch : state.patches)
        for (int c = 0; c < 3; ++c) {
            const auto area = static_cast<double>(patch.area), reflectance = static_cast<double>(patch.diffuse[c]);
            const double reflected = static_cast<double>(patch.rad[c]) - static_cast<double>(patch.emissive[c]);
            sum.emitted += area * static_cast<double>(patch.emissive[c]);
            sum.unshot += area * static_cast<double>(patch.unshot_rad[c]);
            sum.absorbed += area * reflected * (1.0 - reflectance) / reflectance;
        }
    return sum;
}

std::string energyProblem(const Balance& found, const Balance& right) {
    const double share = (found.absorbed + found.unshot) / found.emitted,
                 expected = (right.absorbed + right.unshot) / right.emitted;
    if (std::abs(share - expected) <= energyTolerance * expected) return "";
    char text[200];
    std::snprintf(text, sizeof text,
                  "after %d shots, %.1f %% of the emitted power is absorbed or unshot, expected %.1f %% (within 1 %%): "
                  "light is lost or made somewhere between the functions",
                  shotsToSolve, 100.0 * share, 100.0 * expected);
    return text;
}

PictureCase solvedPicture(const std::string& check, const Box& (*box)(), bool analytic) {
    const auto steps = [=] {
        Step step = stepOn("solve", box().state, {"patch.rad", "patch.unshot_rad", "patch.color", "corner.color"});
        step.standIns = false;
        step.analytic = analytic;
        step.shots = shotsToSolve;
        step.hemicubeSize = analytic ? 0 : hemicubeSize;
        return Steps{step};
    };
    const auto draw = [=](const Steps&, const Answers& answers) {
        const State shown = after(*colorStage(), stepOn("", box().solved, {}));
        return tonedLike(smoothBox(shown, box()), smoothBox(answers[0].state, box()));
    };
    const auto problem = [=](const Steps&, const Answers& answers) -> std::string {
        if (answers[0].shots < shotsToSolve)
            return "shooting ended after " + std::to_string(answers[0].shots) + " of " + std::to_string(shotsToSolve) +
                   " shots, with light unshot";
        const Balance found = balanceOf(answers[0].state);
        if (analytic) return energyProblem(found, balanceOf(box().solved));
        // Some leaves through the open front; none comes from nowhere.
        const double share = (found.absorbed + found.unshot) / found.emitted;
        return share > 0.5 && share < 1.0 + energyTolerance ? "" : energyProblem(found, {1.0, 1.0, 0.0});
    };
    return {check, steps, draw, problem};
}

}  // namespace

std::string referenceFolder() { return RADLAB_SOURCE_DIR "/resources/reference"; }

std::vector<PictureCase> pictureCases() {
    return {orderPicture(),
            formFactorPicture(),
            shotPicture(),
            smoothPicture(),
            idPicture(),
            hemicubePicture(),
            solvedPicture("together.analytic", emptyBox, true),
            solvedPicture("together.hemicube", furnishedBox, false)};
}

Image differencePicture(const Image& reference, const Image& found) {
    RADLAB_CHECK(reference.width() == found.width());
    RADLAB_CHECK(reference.height() == found.height());
    Image picture(reference.width(), reference.height());
    for (std::size_t i = 0; i < picture.data().size(); ++i) {
        const glm::vec3 apart = glm::abs(reference.data()[i] - found.data()[i]);
        picture.data()[i] = heatColor(std::sqrt(std::max({apart.r, apart.g, apart.b})));
    }
    return picture;
}

}  // namespace radlab::grader

#include "apps/EffectRun.h"

#include <doctest/doctest.h>

#include "base/Warning.h"

using namespace radlab;

namespace {

constexpr double about = 150.0;  // patches

double largestOf(const std::vector<engine::Point>& radiosity) {
    double most = 0.0;
    for (const engine::Point& b : radiosity) most = std::max({most, b.x, b.y, b.z});
    return most;
}

double largestDifference(const std::vector<engine::Point>& a, const std::vector<engine::Point>& b) {
    double most = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i)
        for (int c = 0; c < 3; ++c) most = std::max(most, std::abs(a[i][c] - b[i][c]));
    return most;
}

std::string forced(Effect effect, bool on) { return std::string(nameOf(effect)) + (on ? "=on" : "=off"); }

}  // namespace

TEST_CASE("in every scene, an unneeded effect that is forced on changes nothing") {
    for (const std::string& file : projectScenes()) {
        CAPTURE(file);
        const EffectRun plain(file, about, {});
        for (const Effect effect : allEffects) {
            if (plain.input.effects[effect].needed) continue;
            CAPTURE(nameOf(effect));
            const EffectRun more(file, about, {forced(effect, true)});
            const double brightest = largestOf(plain.solution.radiosity);
            CHECK(largestDifference(more.solution.radiosity, plain.solution.radiosity) <= 1e-8 * brightest);
            CHECK(rmsDifference(more.picture.radiance, plain.picture.radiance) <= 1e-6 * brightest);
        }
    }
}

TEST_CASE("in every scene, what is off takes no rays, channels, iterations, gathers or samples") {
    for (const std::string& file : projectScenes()) {
        CAPTURE(file);
        const EffectRun run(file, about, {});
        const Effects& effects = run.input.effects;
        const SolutionCounts& counts = run.solution.counts;
        CHECK(counts.channels == (effects.has(Effect::indirect) ? effects.channels().count() : 0));
        if (!effects.has(Effect::occlusion)) CHECK(counts.shadowRays == 0);
        if (!effects.has(Effect::indirect)) CHECK(counts.iterations == 0);
        if (!effects.has(Effect::specular)) CHECK(counts.specularRays == 0);
        if (!effects.has(Effect::specular) && !effects.has(Effect::transparency))
            CHECK(run.picture.report.gathers == 0);
        if (!effects.has(Effect::antialias)) CHECK(run.picture.report.sampledMore == 0);
    }
}

TEST_CASE("a needed effect that is forced off changes the picture: forcing reaches what is simulated") {
    const std::string folder = RADLAB_SOURCE_DIR "/resources/scenes/";
    const WarningCapture quiet;
    for (const auto& needs :
         {std::pair{"cornell_2.x3d", Effect::occlusion}, std::pair{"cornell_2.x3d", Effect::indirect},
          std::pair{"cornell_2.x3d", Effect::colour}, std::pair{"mirror.x3d", Effect::specular},
          std::pair{"cornell_2.x3d", Effect::smooth}, std::pair{"cornell_2.x3d", Effect::antialias}}) {
        const std::string file = needs.first;
        const Effect effect = needs.second;
        CAPTURE(file);
        CAPTURE(nameOf(effect));
        const EffectRun plain(folder + file, about, {}), less(folder + file, about, {forced(effect, false)});
        CHECK(plain.input.effects[effect].needed);
        CHECK(rmsDifference(less.picture.radiance, plain.picture.radiance) > 1e-4);
    }
}

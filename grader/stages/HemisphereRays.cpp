#include "grader/stages/HemisphereRays.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "course/FacePolygon.h"
#include "course/RayCaster.h"
#include "grader/stages/PicturePatches.h"

namespace radlab::grader {

namespace {

constexpr std::uint32_t spread = 16384;  // rays for an expectation
constexpr double spreadError = 1e-3;     // of a share found with them
constexpr double floatSums = 2e-3;       // a share that is a sum of many small floats
constexpr double touching = 1e-3;        // share of rays that may start too near a wall to meet it
constexpr int surelyNotWhole = 100;
constexpr double logChance = 28.3;            // ln(2/10⁻¹²)
constexpr double wholeSlack = 0.05;           // rays
constexpr double golden = 1.61803398874989;   // root of x² = x + 1
constexpr double plastic = 1.32471795724475;  // root of x³ = x + 1

// Evenly over the unit square, as the points of a Fibonacci lattice; the other two coordinates follow an additive
// sequence.
double fraction(double x) { return x - std::floor(x); }
Draw evenDraw(std::uint32_t i) {
    const double n = i;
    return {(n + 0.5) / spread, fraction(n / golden), fraction(0.5 + n / plastic),
            fraction(0.5 + n / (plastic * plastic))};
}

// By Bernstein's inequality, for the mean of so many weights of 0 to `most`.
double chance(double mean, double most, int rays) {
    const double linear = logChance * most / (3.0 * rays), variance = std::max(mean * (most - mean), 0.0);
    return linear + std::sqrt(linear * linear + 2.0 * variance * logChance / rays);
}

double tolerance(double mean, const RayUse& use, int rays) {
    return chance(mean, use.most, rays) + spreadError * use.most + floatSums * mean;
}

// Where no ray can leave the scene, chance has no part in the sum.
double sumTolerance(const RayShares& shares, const RayUse& use, int rays) {
    if (shares.met > 1.0 - touching && !use.weight) return 0.5 / rays + (use.fromArea ? touching : 0.0);
    return tolerance(std::accumulate(shares.patches.begin(), shares.patches.end(), 0.0), use, rays);
}

Outcome withoutPatches(const Situation& at) {
    Outcome outcome;
    outcome.state = at.before;
    outcome.returned = -1;
    return outcome;
}

// A point of the patch, all places alike.
Vec3f pointOn(const State& state, const MyPolygon& patch, const Draw& draw) {
    const auto corner = [&](int k) { return state.corners[static_cast<std::size_t>(patch.vertex[k])].position; };
    auto u = static_cast<float>(draw.x), v = static_cast<float>(draw.y);
    if (patch.vertices == 3 && u + v > 1.0f) u = 1.0f - u, v = 1.0f - v;
    return corner(0) + u * (corner(1) - corner(0)) + v * (corner(patch.vertices - 1) - corner(0));
}

}  // namespace

glm::dvec3 cosineDirection(const Draw& draw) {
    const double r = std::sqrt(draw.x), turn = 2.0 * std::numbers::pi * draw.y;
    return {r * std::cos(turn), r * std::sin(turn), std::sqrt(1.0 - draw.x)};
}

glm::dmat3 orthonormalFrame(const glm::dvec3& normal) {
    const glm::dvec3 right = glm::normalize(glm::cross(axisAcross(normal), normal));
    return {right, glm::cross(normal, right), normal};
}

bool areShares(const State& state, int rays) {
    return std::all_of(state.patches.begin(), state.patches.end(), [&](const MyPolygon& patch) {
        const double count = static_cast<double>(patch.formF) * rays;
        return std::abs(count - std::round(count)) < wholeSlack;
    });
}

struct RayScene::Parts {
    explicit Parts(State scene) : patches(std::move(scene)), caster(patches.polygons, patches.corners) {}

    PicturePatches patches;
    RayCaster caster;
};

RayScene::RayScene(State scene) : parts(std::make_unique<Parts>(std::move(scene))) {}

RayScene::~RayScene() = default;

int RayScene::send(const RayUse& use, int shooter, const Draw& draw, const Draw& start, double& weight) const {
    const MyPolygon& from = parts->patches.state.patches[static_cast<std::size_t>(shooter)];
    const glm::dvec3 local = use.direction ? use.direction(draw) : cosineDirection(draw);
    const glm::dvec3 normal = glm::normalize(glm::dvec3(from.normal));
    const glm::dmat3 frame = use.frame ? use.frame(normal) : orthonormalFrame(normal);
    weight = use.weight ? use.weight(local.z / glm::length(local)) : 1.0;
    const Vec3f origin = use.fromArea ? pointOn(parts->patches.state, from, start) : from.center;
    const MyPolygon* met = parts->caster.hit(origin, Vec3f(frame * local), use.leavesOutShooter ? &from : nullptr);
    return met ? static_cast<int>(met - parts->patches.state.patches.data()) : -1;
}

std::shared_ptr<const RayShares> RayShooter::shares(const State& state, int shooter, const RayUse& use) const {
    Fingerprint key;
    key.addShape(state);
    key.add(shooter);
    for (const char letter : use.name) key.add(static_cast<int>(letter));
    return known->get(key, [&] {
        const RayScene scene(state);
        RayShares shares;
        shares.patches.resize(state.patches.size());
        for (std::uint32_t i = 0; i < spread; ++i) {
            const Draw draw = evenDraw(i);
            double weight = 0.0;
            const int met = scene.send(use, shooter, draw, {draw.z, draw.w, 0.0, 0.0}, weight);
            if (met < 0) continue;
            shares.patches[static_cast<std::size_t>(met)] += weight / spread;
            shares.met += 1.0 / spread;
        }
        return shares;
    });
}

Computation RayShooter::shoots(const RayUse& use) const {
    return [*this, use](const Situation& at) {
        if (at.step.shooter < 0) return withoutPatches(at);
        const std::shared_ptr<const RayShares> expected = shares(at.before, at.step.shooter, use);
        const double over = use.over(at.step.samples, expected->met);
        Outcome outcome;
        outcome.state = at.before;
        outcome.returned = use.returnsShooter ? at.step.shooter : -1;
        // By chance, the weight of a few rays may be whole.
        const bool open = use.whole == 1.0 && at.step.samples < surelyNotWhole;
        outcome.pixels = {open ? std::nan("") : use.whole, over * sumTolerance(*expected, use, at.step.samples)};
        for (std::size_t j = 0; j < expected->patches.size(); ++j) {
            float& formFactor = outcome.state.patches[j].formF;
            const auto share = static_cast<float>(expected->patches[j] * over);
            formFactor = use.addsToLast ? formFactor + share : share;
            // What is added to differs by chance, too, where it is an earlier shot's.
            outcome.slack.push_back((use.addsToLast ? 2.0 : 1.0) * over *
                                    tolerance(expected->patches[j], use, at.step.samples));
        }
        return outcome;
    };
}

}  // namespace radlab::grader

// Stage 2, calcAnalyticalFF: form factors by the point to point formula.

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "grader/stages/ExponentFit.h"
#include "grader/stages/Meshes.h"
#include "grader/stages/Stage.h"

namespace radlab::grader {

namespace {

constexpr double pi = std::numbers::pi;
constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();

// What the formula is made of, for one pair of patches.
struct Pair {
    double distance, cosineFrom, cosineTo;  // the cosines as they come, below 0 where turned away
    double areaFrom, areaTo, betweenNormals;
};

Pair pairOf(const MyPolygon& from, const MyPolygon& to) {
    const glm::dvec3 between = glm::dvec3(to.center) - glm::dvec3(from.center);
    const double distance = glm::length(between);
    const glm::dvec3 direction = between / distance;
    return {distance,
            glm::dot(glm::dvec3(from.normal), direction),
            -glm::dot(glm::dvec3(to.normal), direction),
            static_cast<double>(from.area),
            static_cast<double>(to.area),
            static_cast<double>(glm::dot(from.normal, to.normal))};
}

double clamped(double x) { return std::max(x, 0.0); }

double formula(const Pair& p) {
    return clamped(p.cosineFrom) * clamped(p.cosineTo) * p.areaTo / (pi * p.distance * p.distance);
}

using PairFormula = std::function<double(const Pair&)>;

// A way to fill in formF: a formula for pairs, and what becomes of the pairs that it cannot have.
struct Filling {
    PairFormula pair = formula;
    double self = 0.0;
    double coincident = 0.0;
    bool selfWritten = true, coincidentWritten = true;
    std::function<bool(const Pair&)> written = [](const Pair&) { return true; };  // the others keep what they had
    std::function<void(State&, const State& before, int shooter)> afterwards = [](State&, const State&, int) {};
    std::function<int(int shooter)> returned = [](int shooter) { return shooter; };
};

Computation fills(const Filling& filling) {
    return [filling](const Situation& at) {
        Outcome outcome;
        outcome.state = at.before;
        const int s = at.step.shooter;
        outcome.returned = filling.returned(s);
        if (s < 0) return outcome;
        const MyPolygon shooter = at.before.patches[static_cast<std::size_t>(s)];
        for (std::size_t j = 0; j < outcome.state.patches.size(); ++j) {
            MyPolygon& patch = outcome.state.patches[j];
            const Pair pair = pairOf(shooter, patch);
            const bool self = static_cast<int>(j) == s, coincident = pair.distance == 0.0;
            const bool written = self         ? filling.selfWritten
                                 : coincident ? filling.coincidentWritten
                                              : filling.written(pair);
            if (!written) continue;
            const double formFactor = self ? filling.self : coincident ? filling.coincident : filling.pair(pair);
            patch.formF = static_cast<float>(formFactor);
        }
        filling.afterwards(outcome.state, at.before, s);
        return outcome;
    };
}

Filling with(const PairFormula& pair) {
    Filling filling;
    filling.pair = pair;
    return filling;
}

// Right but for a factor.
Computation times(const std::function<double(const Pair&)>& factor) {
    return fills(with([factor](const Pair& p) { return formula(p) * factor(p); }));
}

// The formula with other cosines.
Computation cosines(const std::function<double(const Pair&)>& product) {
    return fills(with([product](const Pair& p) { return product(p) * p.areaTo / (pi * p.distance * p.distance); }));
}

Step shotFrom(int shooter, State state) {
    for (MyPolygon& patch : state.patches) patch.unshot_rad *= 1e-4f;  // the brightest by far, whoever looks
    if (shooter >= 0) state.patches[static_cast<std::size_t>(shooter)].unshot_rad = Vec3f(500.0f, 400.0f, 300.0f);
    Step step;
    step.function = "calcAnalyticalFF";
    step.state = std::move(state);
    step.shooter = shooter;
    step.wanted = {"patch.formF"};
    return step;
}

Step nextShot(int shooter, std::size_t patches) {
    Step step;
    step.function = "calcAnalyticalFF";
    step.unshot.assign(patches, Vec3f(1e-4f));
    step.unshot[static_cast<std::size_t>(shooter)] = Vec3f(500.0f, 400.0f, 300.0f);
    step.shooter = shooter;
    step.wanted = {"patch.formF"};
    return step;
}

Case oneShot(const std::string& what, int shooter, State state) {
    return {what, {shotFrom(shooter, std::move(state))}};
}

// A shooter and a receiver, in the order of the seed; returns the shooter's index.
int twoPatches(Random& random, State& state, const std::vector<Vec3f>& shooter, const std::vector<Vec3f>& receiver) {
    const bool first = random.index(2) == 0;
    addPatch(state, first ? shooter : receiver);
    addPatch(state, first ? receiver : shooter);
    randomLight(random, state);
    return first ? 0 : 1;
}

// In round numbers, so that the first case that fails for most mistakes is read at a glance.
Case simplest(Random& random) {
    State state;
    const auto edge = [&] { return 0.5f * static_cast<float>(1 + random.index(3)); };
    addPatch(state, rectangle(Vec3f(0.0f), Vec3f(0, 0, 1), edge(), edge()));
    addPatch(state, rectangle(Vec3f(0, 0, 2), Vec3f(0, 0, -1), edge(), edge()));
    Case asked = oneShot("two facing patches, 2 apart", 0, std::move(state));
    for (MyPolygon& patch : asked.steps[0].state->patches) patch.formF = 0.125f;
    return asked;
}

Case facing(Random& random, double distance) {
    State state;
    const Vec3f place = random.vector(-2, 2), normal = random.direction();
    const auto edge = [&] { return static_cast<float>(distance * random.between(0.2, 0.8)); };
    const Vec3f opposite = place + static_cast<float>(distance) * normal;
    const int shooter = twoPatches(random, state, rectangle(place, normal, edge(), edge()),
                                   rectangle(opposite, -normal, edge(), edge()));
    return oneShot("two facing patches", shooter, std::move(state));
}

// A unit vector at the given angle to another one.
Vec3f turned(Random& random, const Vec3f& axis, double angle) {
    const glm::dvec3 aside = glm::normalize(glm::cross(glm::dvec3(axis), glm::dvec3(random.direction())));
    return Vec3f(glm::normalize(std::cos(angle) * glm::dvec3(axis) + std::sin(angle) * aside));
}

Case tilted(Random& random, const std::string& what, double shooterAngle, double receiverAngle) {
    State state;
    const Vec3f place = random.vector(-2, 2), direction = random.direction();
    const auto distance = static_cast<float>(random.between(1, 4));
    const auto edge = [&] { return distance * static_cast<float>(random.between(0.1, 0.6)); };
    const int shooter =
        twoPatches(random, state, triangle(place, turned(random, direction, shooterAngle), edge(), edge()),
                   rectangle(place + distance * direction, turned(random, -direction, receiverAngle), edge(), edge()));
    return oneShot(what, shooter, std::move(state));
}

std::vector<double> rowOf(const State& state, int shooter) {
    std::vector<double> row;
    for (std::size_t j = 0; j < state.patches.size(); ++j)
        if (static_cast<int>(j) != shooter)
            row.push_back(formula(pairOf(state.patches[static_cast<std::size_t>(shooter)], state.patches[j])));
    return row;
}

// Sees something, but nothing so near that the formula exceeds 1: some people cut it off there.
bool suits(const State& state, int shooter) {
    const std::vector<double> row = rowOf(state, shooter);
    return std::count_if(row.begin(), row.end(), [](double f) { return f > 0.0; }) > 1 &&
           std::all_of(row.begin(), row.end(), [](double f) { return f < 0.8; });
}

Case many(Random& random, const std::string& what, int count, double scale) {
    for (;;) {
        State state = scattered(random, count);
        for (MyPolygon& patch : state.patches) {
            patch.center *= static_cast<float>(scale);
            patch.area *= static_cast<float>(scale * scale);
        }
        for (MyVertex& corner : state.corners) corner.position *= static_cast<float>(scale);
        const int shooter = random.index(state.patches.size());
        if (suits(state, shooter)) return oneShot(what, shooter, std::move(state));
    }
}

Case backToBack(Random& random, int shooter) {
    State state;
    const Vec3f place = random.vector(-2, 2), normal = random.direction();
    addPatch(state, rectangle(place, normal, 1.0f, 0.7f));
    addPatch(state, rectangle(place + 2.0f * normal, -normal, 0.5f, 0.6f));
    addPatch(state, rectangle(place, -normal, 0.7f, 1.0f));
    state.patches[2].center = state.patches[0].center;
    randomLight(random, state);
    return oneShot("a patch back to back with the shooter, at the same centre", shooter, std::move(state));
}

Case coplanar(Random& random) {
    State state;
    const Vec3f normal = random.direction();
    const std::vector<Vec3f> first = rectangle(Vec3f(0.0f), normal, 1.0f, 1.0f);
    addPatch(state, first);
    addPatch(state, rectangle(first[1] - first[0], normal, 1.0f, 1.0f));
    addPatch(state, rectangle(2.0f * (first[3] - first[0]), normal, 1.0f, 1.0f));
    randomLight(random, state);
    return oneShot("patches in the plane of the shooter", 0, std::move(state));
}

Case twoShots(Random& random) {
    for (;;) {
        Case shots = many(random, "two shots, one after the other", 20, 1.0);
        const State& state = *shots.steps[0].state;
        const int next = random.index(state.patches.size());
        if (next == shots.steps[0].shooter || !suits(state, next)) continue;
        shots.steps.push_back(nextShot(next, state.patches.size()));
        return shots;
    }
}

class AnalyticalFF : public Stage {
public:
    std::string function() const override { return "calcAnalyticalFF"; }
    std::vector<Check> checks(std::uint64_t seed) const override;
    std::vector<Computation> right() const override { return {fills({})}; }
    Numbers numbers(const Step& step, const State& before, const Outcome& outcome) const override;
    std::string name(const Step& step, std::size_t k) const override;
    std::string show(const Step& step, std::size_t k, double value) const override;
    std::string tolerance() const override { return "0.03 %, as π to 4 digits and float arithmetic need"; }
    std::vector<Mistake> mistakes() const override;
    std::optional<Diagnosis> fit(const std::vector<Comparison>& comparisons) const override;
    std::vector<std::string> inputs() const override { return {"center", "normal", "area", "unshot_rad"}; }
};

std::vector<Check> AnalyticalFF::checks(std::uint64_t seed) const {
    Random random(seed);
    Check face{"ff.facing", {}}, tilt{"ff.tilted", {}}, behind{"ff.behind", {}}, scale{"ff.scale", {}};
    face.cases.push_back(simplest(random));
    for (const double distance : {1.0, 2.0, 10.0}) face.cases.push_back(facing(random, distance));
    for (int i = 0; i < 3; ++i)
        tilt.cases.push_back(tilted(random, "two tilted patches", random.between(0.3, 1.2), random.between(0.3, 1.2)));
    for (const int count : {12, 40, 300})
        tilt.cases.push_back(many(random, std::to_string(count) + " patches, turned at random", count, 1.0));
    behind.cases = {tilted(random, "a receiver behind the shooter", random.between(2.0, 2.8), 0.4),
                    tilted(random, "a receiver that looks away", 0.4, random.between(2.0, 2.8)),
                    tilted(random, "both look away", random.between(2.0, 2.8), random.between(2.0, 2.8))};
    for (const double factor : {1e-4, 1e-2, 1e2, 1e4}) {
        char what[64];
        std::snprintf(what, sizeof what, "a scene of size %g", 20 * factor);
        scale.cases.push_back(many(random, what, 20, factor));
    }
    const Check self{"ff.self", {many(random, "the shooter among others", 30, 1.0), coplanar(random)}};
    const Check coincident{"ff.coincident", {backToBack(random, 0), backToBack(random, 2)}};
    const Check stale{"ff.stale", {twoShots(random), twoShots(random)}};
    const Check empty{"ff.empty", {oneShot("no patches", -1, State{})}};
    return {face, tilt, behind, scale, self, coincident, stale, empty};
}

Numbers AnalyticalFF::numbers(const Step& step, const State& before, const Outcome& outcome) const {
    Numbers numbers{{static_cast<double>(outcome.returned)}, {0.0}};
    for (std::size_t j = 0; j < before.patches.size(); ++j) {
        const auto value = static_cast<double>(outcome.state.patches[j].formF);
        double slack = 3e-4 * std::abs(value);
        const MyPolygon &from = before.patches[static_cast<std::size_t>(step.shooter)], &to = before.patches[j];
        const Pair pair = pairOf(from, to);
        // What float rounding of the centres does to a cosine.
        if (pair.distance > 0.0)
            slack +=
                pair.areaTo / (pi * pair.distance * pair.distance) *
                (2e-6 + 5e-7 * static_cast<double>(glm::length(from.center) + glm::length(to.center)) / pair.distance);
        numbers.values.push_back(value);
        numbers.slack.push_back(slack);
    }
    return numbers;
}

std::string AnalyticalFF::name(const Step&, std::size_t k) const {
    if (k == 0) return "the patch returned";
    return "polygons[" + std::to_string(k - 1) + "]->formF";
}

std::string AnalyticalFF::show(const Step& step, std::size_t k, double value) const {
    if (k > 0) return Stage::show(step, k, value);
    if (value < 0) return value == -1 ? "nullptr" : "a patch that is not in `polygons` (a copy?)";
    return "polygons[" + std::to_string(static_cast<int>(value)) + "]";
}

std::optional<Diagnosis> AnalyticalFF::fit(const std::vector<Comparison>& comparisons) const {
    Factor from{"the shooter's cosine", {}}, to{"the receiver's cosine", {}}, areaTo{"the receiver's area", {}},
        areaFrom{"the shooter's area", {}, 0.0}, distance{"the distance", {}, -2.0, "r"};
    std::vector<double> ratios;
    for (const Comparison& comparison : comparisons)
        for (std::size_t j = 0; j < comparison.before.patches.size(); ++j) {
            if (static_cast<int>(j) == comparison.step.shooter) continue;
            const MyPolygon& shooter = comparison.before.patches[static_cast<std::size_t>(comparison.step.shooter)];
            const Pair pair = pairOf(shooter, comparison.before.patches[j]);
            if (!(pair.cosineFrom > 0.02 && pair.cosineTo > 0.02)) continue;
            const double ratio = comparison.found.values[j + 1] / formula(pair);
            if (!(ratio > 0.0)) return std::nullopt;
            ratios.push_back(std::log(ratio));
            from.logs.push_back(std::log(pair.cosineFrom));
            to.logs.push_back(std::log(pair.cosineTo));
            areaTo.logs.push_back(std::log(pair.areaTo));
            areaFrom.logs.push_back(std::log(pair.areaFrom));
            distance.logs.push_back(std::log(pair.distance));
        }
    return fitExponents(ratios, {from, to, areaTo, areaFrom, distance});
}

std::vector<Mistake> constants() {
    return {
        {"missing-inverse-pi",
         "The factor 1/π is missing, so every form factor is π times too large. It is there because a diffuse patch "
         "spreads its power over a hemisphere: the cosine, summed over all directions, gives π.",
         "What does the formula divide by beside r²?", times([](const Pair&) { return pi; })},
        {"pi-multiplied",
         "The formula is multiplied by π where it should be divided by it: form factors are π² times too large.",
         "M_PI and M_1_PI are not the same.", times([](const Pair&) { return pi * pi; })},
        {"two-pi",
         "The formula is divided by 2π, the solid angle of a hemisphere. But a diffuse patch does not send the same in "
         "all "
         "directions: weighted by the cosine, the hemisphere counts π.",
         "Integrate the cosine over the hemisphere: what comes out?", times([](const Pair&) { return 0.5; })},
        {"four-pi",
         "The formula is divided by 4π, as for a point that shines in all directions alike. A patch shines into one "
         "hemisphere, weighted by the cosine: that makes π.",
         "Integrate the cosine over the hemisphere: what comes out?", times([](const Pair&) { return 0.25; })},
    };
}

std::vector<Mistake> distances() {
    const auto r = [](double power) { return times([power](const Pair& p) { return std::pow(p.distance, power); }); };
    return {
        {"distance-not-squared",
         "The form factor falls as 1/r, not 1/r². The solid angle of a patch becomes a quarter when its distance is "
         "doubled.",
         "sqr_length and length are not the same.", r(1)},
        {"distance-cubed", "The form factor falls as 1/r³, not 1/r²: one power of r too many.",
         "Follow each r through your code: where is one divided out?", r(-1)},
        {"distance-fourth-power", "The form factor falls as 1/r⁴: what is squared already is squared again.",
         "What does sqr_length return?", r(-2)},
        {"distance-missing",
         "The form factor does not depend on the distance at all. A far patch covers less of the hemisphere.",
         "A direction that is not normalised brings its length into each cosine.", r(2)},
    };
}

std::vector<Mistake> cosineMistakes() {
    const auto from = [](const Pair& p) { return clamped(p.cosineFrom); };
    const auto to = [](const Pair& p) { return clamped(p.cosineTo); };
    return {
        {"cosine-shooter-missing",
         "The angle at the shooter plays no part. A diffuse patch sends less power to the side than straight ahead.",
         "How many cosines has the formula, and with which normals?", cosines([=](const Pair& p) { return to(p); })},
        {"cosine-receiver-missing",
         "The angle at the receiver plays no part. A patch that is tilted away catches less.",
         "How many cosines has the formula, and with which normals?", cosines([=](const Pair& p) { return from(p); })},
        {"cosine-receiver-missing",
         "The angle at the receiver plays no part, but for which side it is seen from. A patch that is tilted catches "
         "less.",
         "How many cosines has the formula, and with which normals?",
         cosines([=](const Pair& p) { return p.cosineTo > 0 ? from(p) : 0.0; })},
        {"cosine-shooter-missing", "The angle at the shooter plays no part, but for the side that it shines to.",
         "How many cosines has the formula, and with which normals?",
         cosines([=](const Pair& p) { return p.cosineFrom > 0 ? to(p) : 0.0; })},
        {"cosines-missing", "Neither angle plays a part: a patch seen edge-on gets as much as one seen face-on.",
         "How does the power that arrives depend on how the two patches are turned?",
         cosines([](const Pair&) { return 1.0; })},
        {"cosine-shooter-squared", "The cosine at the shooter is there twice.", "Count the cosines in your formula.",
         cosines([=](const Pair& p) { return from(p) * from(p) * to(p); })},
        {"cosine-receiver-squared", "The cosine at the receiver is there twice.", "Count the cosines in your formula.",
         cosines([=](const Pair& p) { return from(p) * to(p) * to(p); })},
        {"cosine-shooter-twice", "The shooter's cosine stands in for both: the receiver's normal is never looked at.",
         "Whose normal makes the second angle?", cosines([=](const Pair& p) { return from(p) * from(p); })},
        {"cosines-absolute",
         "The cosines are taken without their sign, so a patch shines and receives on its back, too.",
         "What is the cosine of an angle above 90°, and what should a patch behind the shooter get?",
         cosines([](const Pair& p) { return std::abs(p.cosineFrom * p.cosineTo); })},
        {"cosine-receiver-absolute",
         "The receiver's cosine is taken without its sign, so patches that look away receive on their backs.",
         "What should a patch get that shows the shooter its back?",
         cosines([=](const Pair& p) { return from(p) * std::abs(p.cosineTo); })},
        {"cosine-shooter-absolute",
         "The shooter's cosine is taken without its sign, so it shines out of its back, too.",
         "What should a patch behind the shooter get?",
         cosines([=](const Pair& p) { return std::abs(p.cosineFrom) * to(p); })},
        {"cosines-clamped-jointly",
         "Only the product of the two cosines is clamped. Where both are negative, the product is positive: two "
         "patches "
         "back to back light each other.",
         "What happens if both patches look away from each other?",
         cosines([](const Pair& p) { return clamped(p.cosineFrom * p.cosineTo); })},
        {"cosines-not-clamped",
         "Nothing is clamped: where one of the patches looks away, the form factor is negative, and light is taken "
         "away.",
         "A form factor is a share: which values may it have?",
         cosines([](const Pair& p) { return p.cosineFrom * p.cosineTo; })},
        {"cosine-receiver-not-clamped",
         "The receiver's cosine is not clamped: patches that look away get a negative form factor.",
         "A form factor is a share: which values may it have?",
         cosines([=](const Pair& p) { return from(p) * p.cosineTo; })},
        {"cosine-shooter-not-clamped",
         "The shooter's cosine is not clamped: patches behind it get a negative form factor.",
         "A form factor is a share: which values may it have?",
         cosines([=](const Pair& p) { return p.cosineFrom * to(p); })},
        {"receiver-direction-reversed",
         "At the receiver, too, the direction from the shooter is used. There the line leads back, to the shooter: as "
         "it "
         "is, patches that face the shooter get nothing, and those that look away get light.",
         "Draw both normals and both angles. Where does the line of each point to?",
         cosines([=](const Pair& p) { return from(p) * clamped(-p.cosineTo); })},
        {"shooter-direction-reversed",
         "At the shooter the direction is the one that leads to it, not away from it: it lights what is behind it.",
         "Draw both normals and both angles. Where does the line of each point to?",
         cosines([=](const Pair& p) { return clamped(-p.cosineFrom) * to(p); })},
        {"directions-reversed",
         "The direction has the wrong sign at both ends: only patches that look away from each other exchange light.",
         "Which way does `b - a` point?",
         cosines([](const Pair& p) { return clamped(-p.cosineFrom) * clamped(-p.cosineTo); })},
        {"cosine-between-normals",
         "The angle between the two normals is used. What counts are the angles between each normal and the line that "
         "joins the centres.",
         "Two patches side by side can have opposite normals and still not see each other.",
         cosines([](const Pair& p) { return clamped(-p.betweenNormals); })},
        {"culled-by-normals",
         "Patches whose normal is within 90° of the shooter's are left out. But two patches of one floor and a slope "
         "can "
         "see each other: what decides are the angles with the line between them.",
         "Must two patches have opposite normals to see each other?",
         cosines([=](const Pair& p) { return p.betweenNormals >= 0 ? 0.0 : from(p) * to(p); })},
    };
}

std::vector<Mistake> areas() {
    return {
        {"reciprocal",
         "This is the form factor the other way round, F(j→s), with the shooter's area: by reciprocity, AjF(j→s) = "
         "AsF(s→j). A "
         "distributeEnergy without the ratio of areas would go with it, but not with the hemicube, which gives F(s→j).",
         "A form factor F(s→j) is the share of the shooter's power that arrives at j: whose size makes that share "
         "larger?",
         times([](const Pair& p) { return p.areaFrom / p.areaTo; })},
        {"area-receiver-missing",
         "The receiver's area is missing: a large patch gets the same share as a small one at its place.",
         "Cut a patch in two: what should happen to the form factor of each half?",
         times([](const Pair& p) { return 1.0 / p.areaTo; })},
        {"area-inverted",
         "The receiver's area divides where it should multiply: the larger a patch, the less it would catch.",
         "Cut a patch in two: what should happen to the form factor of each half?",
         times([](const Pair& p) { return 1.0 / (p.areaTo * p.areaTo); })},
        {"areas-both",
         "Both areas are factors. The share of the shooter's power that arrives does not grow with the shooter.",
         "Which of the two areas does the solid angle that the shooter sees depend on?",
         times([](const Pair& p) { return p.areaFrom; })},
        {"area-ratio",
         "The ratio of areas is in the form factor already. It belongs to the shooting, in distributeEnergy.",
         "Which of the two areas does the solid angle that the shooter sees depend on?",
         times([](const Pair& p) { return 1.0 / p.areaFrom; })},
        {"disc-approximation",
         "This is the form factor of a disc of the receiver's area, A/(πr² + A). It is a fine formula for near "
         "patches, but "
         "not the point to point formula that the task asks for.",
         "Which formula does the task give?", fills(with([](const Pair& p) {
             return clamped(p.cosineFrom) * clamped(p.cosineTo) * p.areaTo / (pi * p.distance * p.distance + p.areaTo);
         }))},
    };
}

Filling filling(const std::function<void(Filling&)>& change) {
    Filling made;
    change(made);
    return made;
}

void normalizeRow(State& state, const State&, int) {
    double sum = 0.0;
    for (const MyPolygon& patch : state.patches) sum += static_cast<double>(patch.formF);
    if (sum > 0.0)
        for (MyPolygon& patch : state.patches) patch.formF = static_cast<float>(static_cast<double>(patch.formF) / sum);
}

void addBefore(State& state, const State& before, int) {
    for (std::size_t j = 0; j < state.patches.size(); ++j) state.patches[j].formF += before.patches[j].formF;
}

std::vector<Mistake> bookkeeping() {
    const std::string finite =
        "Dividing by a distance of 0 gives a number that is none (NaN), and with the first shot it spreads to "
        "every patch.";
    return {
        {"self-not-a-number", "The form factor of the shooter itself is computed with a distance of 0. " + finite,
         "What is the distance from a patch to itself?",
         fills(filling([](Filling& f) { f.self = f.coincident = notANumber; }))},
        {"coincident-not-a-number",
         "A patch whose centre lies where the shooter's does, such as the back of the same wall, is computed with a "
         "distance of 0. " +
             finite,
         "Which patches have the distance 0 to the shooter, beside itself?",
         fills(filling([](Filling& f) { f.coincident = notANumber; }))},
        {"self-illumination", "The shooter gets a form factor to itself of 1. A flat patch does not see itself.",
         "What share of its power does a flat patch send to itself?", fills(filling([](Filling& f) { f.self = 1.0; }))},
        {"self-left-stale", "The shooter's own form factor keeps the value of an earlier shot.",
         "Every patch needs its formF set, the shooter's too.",
         fills(filling([](Filling& f) { f.selfWritten = false; }))},
        {"form-factors-added-up", "The form factor is added to the one of the shot before, not put in its place.",
         "What is formF at the start of a shot?", fills(filling([](Filling& f) { f.afterwards = addBefore; }))},
        {"row-normalised",
         "The form factors are divided by their sum, so that they add up to 1. They do so in a closed scene; in an "
         "open "
         "one, the rest leaves it.",
         "What happens to the power that hits nothing?",
         fills(filling([](Filling& f) { f.afterwards = normalizeRow; }))},
        {"shooter-not-returned", "nullptr is returned, so that nobody knows who shoots.",
         "What does distributeEnergy get as its argument?",
         fills(filling([](Filling& f) { f.returned = [](int) { return -1; }; }))},
        {"first-patch-returned", "The first patch is returned, not the shooter.",
         "What does distributeEnergy get as its argument?",
         fills(filling([](Filling& f) { f.returned = [](int s) { return s < 0 ? -1 : 0; }; }))},
        {"nothing-written", "No form factor is set at all.", "Which member of MyPolygon holds the form factor?",
         fills(filling(
             [](Filling& f) { f.afterwards = [](State& state, const State& before, int) { state = before; }; }))},
    };
}

// Patches out of sight are skipped; with the shooter, and one at its centre, among them or not.
std::vector<Mistake> stale() {
    std::vector<Mistake> all;
    for (const bool self : {true, false})
        for (const bool coincident : {true, false})
            all.push_back({"stale-form-factors",
                           "A patch that the shooter does not see keeps its form factor of an earlier shot: it is lit "
                           "though it faces away.",
                           "What has formF of a patch been set to that you skip?", fills(filling([&](Filling& f) {
                               f.written = [](const Pair& p) { return p.cosineFrom > 0.0 && p.cosineTo > 0.0; };
                               f.selfWritten = self;
                               f.coincidentWritten = coincident;
                           }))});
    return all;
}

std::vector<Mistake> AnalyticalFF::mistakes() const {
    std::vector<Mistake> all;
    for (const std::vector<Mistake>& some :
         {constants(), distances(), cosineMistakes(), areas(), stale(), bookkeeping()})
        all.insert(all.end(), some.begin(), some.end());
    return all;
}

}  // namespace

std::unique_ptr<Stage> analyticalStage() { return std::make_unique<AnalyticalFF>(); }

}  // namespace radlab::grader

#include "grader/stages/AnalyticalMistakes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "grader/stages/PairFormula.h"

namespace radlab::grader {

namespace {

constexpr double pi = std::numbers::pi;
constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();

double clamped(double x) { return std::max(x, 0.0); }

using PairFormula = std::function<double(const Pair&)>;

// A way to fill in formF: a formula for pairs, and what becomes of the pairs that it cannot have.
struct Filling {
    PairFormula pair = pointToPoint;
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
    return fills(with([factor](const Pair& p) { return pointToPoint(p) * factor(p); }));
}

// The formula with other cosines.
Computation cosines(const std::function<double(const Pair&)>& product) {
    return fills(with([product](const Pair& p) { return product(p) * p.areaTo / (pi * p.distance * p.distance); }));
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

}  // namespace

Computation fillsFormFactors() { return fills({}); }

std::vector<Mistake> analyticalMistakes() {
    std::vector<Mistake> all;
    for (const std::vector<Mistake>& some :
         {constants(), distances(), cosineMistakes(), areas(), stale(), bookkeeping()})
        all.insert(all.end(), some.begin(), some.end());
    return all;
}

}  // namespace radlab::grader

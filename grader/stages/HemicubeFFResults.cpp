#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "grader/stages/HemicubeFFWays.h"

namespace radlab::grader {

namespace {

constexpr double pi = std::numbers::pi;

// What is done with the row ---------------------------------------------------------------------

void keepUnseen(Shot& shot) {
    for (std::size_t j = 0; j < shot.row.values.size(); ++j) {
        if (shot.row.values[j] > 0.0) continue;
        shot.row.values[j] = shot.stale.values[j];
        shot.row.slack[j] = shot.row.slack[j] > 0.0 ? unknown : shot.stale.slack[j];
    }
}

void normalize(Shot& shot) {
    double sum = 0.0, slack = 0.0;
    const IdImage& image = shot.buffer.image;
    for (std::size_t pixel = 0; pixel < image.patch.size(); ++pixel) {
        const auto candidates = image.candidatesOf(pixel);
        if (std::find(candidates.begin(), candidates.end(), -1) != candidates.end())
            slack += static_cast<double>(shot.weights[pixel]);
    }
    for (const double value : shot.row.values) sum += value;
    if (sum <= 0.0) return;
    for (std::size_t j = 0; j < shot.row.values.size(); ++j) {
        // The sum may be smaller by the slack of the pixels that may be background.
        shot.row.slack[j] =
            sum > slack ? (shot.row.slack[j] + shot.row.values[j] * slack / sum) / (sum - slack) : unknown;
        shot.row.values[j] /= sum;
    }
}

double cosineAt(const MyPolygon& to, const MyPolygon& from) {
    const glm::dvec3 between = glm::dvec3(from.center) - glm::dvec3(to.center);
    const double distance = glm::length(between);
    return distance > 0.0 ? std::max(glm::dot(glm::dvec3(to.normal), between / distance), 0.0) : 0.0;
}

// At right angles, rounding decides.
void keepOpposite(Shot& shot) {
    for (std::size_t j = 0; j < shot.row.values.size(); ++j) {
        const float cosine = dot(shot.from().normal, shot.at.before.patches[j].normal);
        if (std::abs(cosine) < 1e-6f) shot.row.slack[j] = unknown;
        if (cosine >= 0.0f) shot.row.values[j] = 0.0;
    }
}

std::vector<Mistake> factors(const Ways& ways) {
    const std::string whole =
        "The sum of the delta form factors is the form factor already: cosines, distance and 1/π are in it.";
    const std::string share = "The area is in it already, as the pixels that the patch covers.";
    const std::string areaHint = "What does a patch that is twice as large cover on the hemicube?";
    const auto area = [](const MyPolygon& p) { return static_cast<double>(p.area); };
    return {
        {"pi-multiplied", "The form factors are multiplied by π. " + whole,
         "What should they add up to in a closed scene?",
         ways.times([](const MyPolygon&, const MyPolygon&) { return pi; })},
        {"pi-divided", "The form factors are divided by π. " + whole, "What should they add up to in a closed scene?",
         ways.times([](const MyPolygon&, const MyPolygon&) { return 1.0 / pi; })},
        {"area-multiplied", "The form factor is multiplied by the receiver's area. " + share, areaHint,
         ways.times([=](const MyPolygon&, const MyPolygon& to) { return area(to); })},
        {"area-divided", "The form factor is divided by the receiver's area. " + share, areaHint,
         ways.times([=](const MyPolygon&, const MyPolygon& to) { return 1.0 / area(to); })},
        {"reciprocal",
         "This is the form factor the other way round, F(j→s) = F(s→j) · As/Aj. The hemicube stands on the shooter and "
         "gives "
         "F(s→j); the areas come in when the power is shot.",
         "In which function does the ratio of areas belong?",
         ways.times([=](const MyPolygon& from, const MyPolygon& to) { return area(from) / area(to); })},
        {"area-ratio", "The form factor is multiplied by Aj/As. " + share, areaHint,
         ways.times([=](const MyPolygon& from, const MyPolygon& to) { return area(to) / area(from); })},
        {"cosine-again", "The form factor is multiplied by the cosine at the shooter. " + whole,
         "What does the delta form factor of a pixel contain?",
         ways.times([](const MyPolygon& from, const MyPolygon& to) { return cosineAt(from, to); })},
        {"cosine-again", "The form factor is multiplied by the cosine at the receiver. " + whole,
         "What does the delta form factor of a pixel contain?",
         ways.times([](const MyPolygon& from, const MyPolygon& to) { return cosineAt(to, from); })},
        {"backs-left-out",
         "Patches that show the shooter their back get nothing. The hemicube says what each pixel shows, whichever "
         "side it "
         "is; that no light is lost in closed scenes is the modeller's part.",
         "Which pixels does the task tell you to leave out?",
         ways.times([](const MyPolygon& from, const MyPolygon& to) { return cosineAt(to, from) > 0.0 ? 1.0 : 0.0; })},
        {"culled-by-normals",
         "Patches whose normal is within 90° of the shooter's are left out. But two slopes can see each other: what "
         "the "
         "hemicube shows is seen.",
         "Must two patches have opposite normals to see each other?", ways.finish(keepOpposite)},
        {"row-normalised",
         "The form factors are divided by their sum, so that they add up to 1. They do so in a closed scene; in an "
         "open "
         "one, the rest leaves it.",
         "What happens to the power that hits nothing?", ways.finish(normalize)},
        {"stale-form-factors",
         "A patch that no pixel shows keeps its form factor of an earlier shot: it is lit through what stands in "
         "between.",
         "What is formF of a patch that is not seen?", ways.finish(keepUnseen)},
    };
}

// Other methods ---------------------------------------------------------------------------------

double pointToPoint(const MyPolygon& from, const MyPolygon& to) {
    const glm::dvec3 between = glm::dvec3(to.center) - glm::dvec3(from.center);
    const double distance2 = glm::dot(between, between);
    return distance2 > 0.0 ? cosineAt(from, to) * cosineAt(to, from) * static_cast<double>(to.area) / (pi * distance2)
                           : 0.0;
}

// By formula; where a pixel may be a patch's only one, it is left open whether it is seen.
void byFormula(Shot& shot, bool onlyWhereSeen) {
    for (std::size_t j = 0; j < shot.row.values.size(); ++j) {
        const bool seen = shot.row.values[j] > 0.0, maybe = shot.row.slack[j] >= shot.row.values[j];
        const MyPolygon& to = shot.at.before.patches[j];
        const double value = static_cast<int>(j) == shot.shooter ? 0.0 : pointToPoint(shot.from(), to);
        shot.row.values[j] = seen || !onlyWhereSeen ? value : 0.0;
        shot.row.slack[j] = onlyWhereSeen && maybe && (seen || shot.row.slack[j] > 0.0) ? unknown : 1e-3 * value + 1e-9;
    }
}

void onesWhereSeen(Shot& shot) {
    for (std::size_t j = 0; j < shot.row.values.size(); ++j) {
        const bool seen = shot.row.values[j] > 0.0, maybe = shot.row.slack[j] >= shot.row.values[j];
        shot.row.slack[j] = maybe && (seen || shot.row.slack[j] > 0.0) ? unknown : 0.0;
        shot.row.values[j] = seen ? 1.0 : 0.0;
    }
}

std::vector<Mistake> otherMethods(const Ways& ways) {
    const std::string sum = "The form factor is the sum of the delta form factors of the pixels that show the patch.";
    return {
        {"formula-where-seen",
         "The hemicube only says which patches are seen; how much of them, the formula of stage 2. " + sum,
         "What does a patch get of which only a corner is seen?",
         ways.finish([](Shot& shot) { byFormula(shot, true); })},
        {"formula", "The form factors are those of stage 2, by formula: nothing that stands in between is seen.",
         "What do you get from the hemicube?", ways.finish([](Shot& shot) { byFormula(shot, false); })},
        {"ones-where-seen", "Every patch that is seen has the form factor 1. " + sum,
         "A form factor is a share of the shooter's power: what may all of them add up to?",
         ways.finish(onesWhereSeen)},
    };
}

// What comes out --------------------------------------------------------------------------------

void selfLit(Shot& shot) { shot.row.values[static_cast<std::size_t>(shot.shooter)] = 1.0; }

void selfStale(Shot& shot) {
    const auto self = static_cast<std::size_t>(shot.shooter);
    shot.row.values[self] += shot.stale.values[self];
    shot.row.slack[self] += shot.stale.slack[self];
}

std::vector<Mistake> results(const Ways& ways) {
    const std::string argument = "What does distributeEnergy get as its argument?";
    const auto returning = [&](const std::function<int(int)>& returned) {
        return ways.with([&](ShotWay& way) { way.returned = returned; });
    };
    const auto shooting = [&](const std::function<int(const Situation&)>& chosen) {
        return ways.with([&](ShotWay& way) { way.shooter = chosen; });
    };
    return {
        {"shooter-not-returned", "nullptr is returned, so that nobody knows who shoots.", argument,
         returning([](int) { return -1; })},
        {"first-patch-returned", "The first patch is returned, not the shooter.", argument,
         returning([](int s) { return s < 0 ? -1 : 0; })},
        {"copy-returned", "A copy of the shooter is returned: what happens to it, the patch in `polygons` never sees.",
         argument, returning([](int s) { return s < 0 ? -1 : -2; })},
        {"first-patch-shoots", "The first patch shoots, not the brightest one.", "Which function finds the shooter?",
         shooting([](const Situation& at) { return at.step.shooter < 0 ? -1 : 0; })},
        {"last-patch-shoots", "The last patch shoots, not the brightest one.", "Which function finds the shooter?",
         shooting([](const Situation& at) {
             return at.step.shooter < 0 ? -1 : static_cast<int>(at.before.patches.size()) - 1;
         })},
        {"self-illumination", "The shooter gets a form factor to itself of 1. A flat patch does not see itself.",
         "What share of its power does a flat patch send to itself?", ways.finish(selfLit)},
        {"self-left-stale", "The shooter's own form factor keeps the value of an earlier shot.",
         "Every patch needs its formF set, the shooter's too.", ways.finish(selfStale)},
        {"nothing-added", "All form factors are 0: no pixel is added to any patch.",
         "Follow one pixel: which ID does it show, and whose formF does it change?",
         ways.with([](ShotWay& way) { way.collect = nothing; })},
    };
}

}  // namespace

std::vector<Mistake> resultMistakes(const Ways& ways) {
    std::vector<Mistake> all;
    for (const std::vector<Mistake>& some : {factors(ways), otherMethods(ways), results(ways)})
        all.insert(all.end(), some.begin(), some.end());
    return all;
}

}  // namespace radlab::grader

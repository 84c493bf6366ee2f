#include "grader/stages/HemisphereMistakes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace radlab::grader {

namespace {

constexpr double pi = std::numbers::pi;
constexpr double either = std::numeric_limits<double>::quiet_NaN();  // whole or not

glm::dvec3 atAngle(double cosine, double turn) {
    const double sine = std::sqrt(std::max(1.0 - cosine * cosine, 0.0));
    return {sine * std::cos(turn), sine * std::sin(turn), cosine};
}

glm::dvec3 lifted(double x, double y) { return {x, y, std::sqrt(std::max(1.0 - x * x - y * y, 0.0))}; }

glm::dvec3 evenDirection(const Draw& draw) { return atAngle(draw.x, 2.0 * pi * draw.y); }

RayUse drawing(const std::string& name, const LocalDirection& direction) {
    RayUse use;
    use.name = name;
    use.direction = direction;
    return use;
}

RayUse weighted(RayUse use, const std::string& name, const std::function<double(double cosine)>& weight, double most) {
    use.name = name;
    use.weight = weight;
    use.most = most;
    use.whole = 1.0;
    return use;
}

RayUse dividedBy(const std::function<double(int rays, double met)>& over, double whole) {
    RayUse use;
    use.over = over;
    use.whole = whole;
    return use;
}

std::vector<RayMistake> densities() {
    const std::string where =
        "How much of the sky lies within one degree of the pole, and how much within one of the horizon?";
    return {
        {"uniform-directions",
         "The directions are spread evenly over the hemisphere, and each ray counts the same. But the patch sends less "
         "to the side "
         "than straight ahead: by the cosine of the angle.",
         "Lift points of the disc straight up. Where does the hemisphere get fewer of them?",
         drawing("uniform", evenDirection)},
        {"theta-uniform",
         "The angle θ is drawn evenly from 0 to π/2, so that rays crowd round the normal: a ring of the hemisphere at "
         "a small θ "
         "is small, but gets as many rays as one near the horizon.",
         where, drawing("theta", [](const Draw& d) { return atAngle(std::cos(d.x * pi / 2), 2.0 * pi * d.y); })},
        {"radius-uniform",
         "The radius on the disc is drawn evenly from 0 to 1, so that points crowd round the centre. A ring twice as "
         "far out has "
         "twice the area and should get twice as many.",
         "Which function of an even random number makes the area within the radius even?",
         drawing("radius",
                 [](const Draw& d) { return lifted(d.x * std::cos(2 * pi * d.y), d.x * std::sin(2 * pi * d.y)); })},
        {"radius-uniform",
         "The radius on the disc is the random number itself, not its root, so that points crowd round the centre. A "
         "ring twice as far out "
         "has twice the area and should get twice as many.",
         "Which function of an even random number makes the area within the radius even?",
         drawing("radius of no root",
                 [](const Draw& d) {
                     return glm::dvec3(d.x * std::cos(2 * pi * d.y), d.x * std::sin(2 * pi * d.y), std::sqrt(1 - d.x));
                 })},
        {"lift-without-root",
         "The point is lifted to 1 - r² instead of √(1 - r²): that is a paraboloid, and its directions lean too far to "
         "the side.",
         "x² + y² + z² = 1 on the sphere: what is z?",
         drawing("paraboloid",
                 [](const Draw& d) {
                     const glm::dvec3 right = cosineDirection(d);
                     return glm::dvec3(right.x, right.y, right.z * right.z);
                 })},
        {"square-not-disc",
         "The points come from the whole square round the disc, and those outside the disc are kept. They all end up "
         "at the horizon.",
         "What is √(1 - x² - y²) for a point in the square's corner, and what should be done with such a point?",
         drawing("square", [](const Draw& d) { return lifted(2 * d.x - 1, 2 * d.y - 1); })},
        {"cube-not-hemisphere",
         "The directions are random points of a box, made to length 1. More of them point to the box's corners, and "
         "none of that "
         "follows the cosine.",
         "Begin with a point of the unit disc.",
         drawing("box", [](const Draw& d) { return glm::dvec3(2 * d.x - 1, 2 * d.y - 1, d.z); })},
        {"cosine-cubed",
         "The directions lean too much towards the normal: they follow cos³θ. That happens where a point from inside "
         "the unit ball is added "
         "to the normal, which should be one of its surface, or where the cosine is brought in twice.",
         "Normal plus a point of the unit sphere: which length does that point need?",
         drawing(
             "ball",
             [](const Draw& d) { return glm::dvec3(0, 0, 1) + std::cbrt(d.z) * atAngle(2 * d.x - 1, 2 * pi * d.y); })},
        {"same-number-twice",
         "The radius and the turn come from one random number, so that all rays lie along one spiral.",
         "How many independent numbers does a point of a disc need?",
         drawing("spiral",
                 [](const Draw& d) {
                     return cosineDirection({d.x, d.x, 0, 0});
                 })},
    };
}

std::vector<RayMistake> parts() {
    const std::string text =
        "The rays cover a part of the hemisphere only. Random numbers are from 0 to 1; a full turn is 2π, and "
        "coordinates on the disc go "
        "from -1 to 1.";
    const std::string hint = "Which x and y, or which angles, do the rays of yours take?";
    const auto turning = [](const std::string& name, double most) {
        return drawing(name, [most](const Draw& d) { return cosineDirection({d.x, most * d.y, 0, 0}); });
    };
    return {{"part-of-the-hemisphere", text, hint, turning("half", 0.5)},
            {"part-of-the-hemisphere", text, hint, turning("quarter", 0.25)},
            {"part-of-the-hemisphere", text, hint, turning("one radian", 0.5 / pi)},
            {"whole-sphere", "The directions are spread over the whole sphere: half of them go down through the patch.",
             "On which side of the patch must all rays lie? What does the dot product with the normal tell?",
             drawing("sphere", [](const Draw& d) { return atAngle(2 * d.x - 1, 2 * pi * d.y); })}};
}

RayUse framed(const std::string& name, const Frame& frame) {
    RayUse use;
    use.name = name;
    use.frame = frame;
    return use;
}

using Across = std::function<glm::dvec3(const glm::dvec3& normal)>;

// With axes as they come out of the cross products, or with the first one normalised though it may be 0.
RayUse crossed(const std::string& name, const Across& across, bool normalised) {
    return framed(name, [across, normalised](const glm::dvec3& normal) {
        glm::dvec3 right = glm::cross(across(normal), normal);
        if (normalised) right = glm::normalize(right);
        return glm::dmat3(right, glm::cross(normal, right), normal);
    });
}

std::vector<RayMistake> frames() {
    std::vector<RayMistake> all = {
        {"hemisphere-behind",
         "The hemisphere lies behind the patch: rays go where it neither sends nor gets any light.",
         "Which way does the normal point, and which way the pole of your hemisphere?",
         framed("behind",
                [](const glm::dvec3& normal) {
                    glm::dmat3 frame = orthonormalFrame(normal);
                    frame[2] = -frame[2];
                    return frame;
                })},
        {"not-turned", "The hemisphere is always over the z axis, whichever way the patch looks.",
         "Take three axes at right angles, the normal the third: what are the direction's coordinates along them?",
         framed("unturned", [](const glm::dvec3&) { return glm::dmat3(1.0); })},
        {"axes-swapped",
         "The direction's coordinates are multiplied by the wrong axes: the one along the pole belongs to the normal.",
         "Which coordinate of your direction is the height over the disc?",
         framed("swapped",
                [](const glm::dvec3& normal) {
                    const glm::dmat3 frame = orthonormalFrame(normal);
                    return glm::dmat3(frame[2], frame[0], frame[1]);
                })},
    };
    struct Choice {
        const char* name;
        Across across;
    };
    const glm::dvec3 x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
    const std::vector<Choice> choices = {
        {"x", [=](const glm::dvec3&) { return x; }},
        {"y", [=](const glm::dvec3&) { return y; }},
        {"z", [=](const glm::dvec3&) { return z; }},
        {"x or y", [=](const glm::dvec3& n) { return std::abs(n.x) < 0.5 ? x : y; }},
        {"y unless x", [=](const glm::dvec3& n) { return std::abs(n.x) > 0.9 ? y : x; }},
        {"x unless y", [=](const glm::dvec3& n) { return std::abs(n.y) > 0.9 ? x : y; }},
        {"z unless x", [=](const glm::dvec3& n) { return std::abs(n.z) > 0.9 ? x : z; }},
    };
    for (std::size_t i = 0; i < choices.size(); ++i) {
        all.push_back({"axes-not-of-length-1",
                       "The axes that the hemisphere is turned by are not all of length 1: a cross product is as long "
                       "as the sine of the "
                       "angle between its factors. So the hemisphere is squeezed towards the normal.",
                       "How long is cross(a, b) where a and b are not at right angles?",
                       crossed(std::string("unnormalised ") + choices[i].name, choices[i].across, false)});
        if (i < 3)
            all.push_back({"parallel-axis",
                           "Where the normal lies along the fixed axis that it is crossed with, the cross product is "
                           "0, and normalised "
                           "it is no number: those shooters' rays meet nothing.",
                           "Which vector can be crossed with the normal whichever way it points?",
                           crossed(std::string("fixed ") + choices[i].name, choices[i].across, true)});
    }
    return all;
}

std::vector<RayMistake> weights() {
    const RayUse cosine, uniform = drawing("uniform", evenDirection);
    return {
        {"uniform-weighted",
         "The directions are spread evenly, and each ray is weighted by its cosine. That is right on average, but "
         "noisier: the "
         "task is to draw more rays where more light goes, so that all of them count the same.",
         "If the density of the rays has the cosine already, what is left for the weight?",
         weighted(
             uniform, "uniform by 2 cos", [](double c) { return 2.0 * c; }, 2.0)},
        {"uniform-weighted-wrongly",
         "The directions are spread evenly, and each ray is weighted by its cosine, but not divided by the density "
         "1/(2π) that they were "
         "drawn with.",
         "Draw with the density cosθ/π instead: then every ray has the same weight.",
         weighted(
             uniform, "uniform by cos", [](double c) { return c; }, 1.0)},
        {"uniform-weighted-wrongly",
         "The directions are spread evenly, and each ray is weighted by its cosine over π, but not divided by the "
         "density 1/(2π) that they "
         "were drawn with.",
         "Draw with the density cosθ/π instead: then every ray has the same weight.",
         weighted(
             uniform, "uniform by cos over pi", [](double c) { return c / pi; }, 1.0 / pi)},
        {"cosine-twice",
         "The cosine counts twice: the directions are drawn with it, and each ray is weighted by it again.",
         "Each ray stands for the same share of the power. What is its weight?",
         weighted(
             cosine, "cosine by cos", [](double c) { return c; }, 1.0)},
        {"cosine-twice",
         "The cosine counts twice: the directions are drawn with the density cosθ/π, and each ray is weighted by that "
         "again.",
         "Each ray stands for the same share of the power. What is its weight?",
         weighted(
             cosine, "cosine by cos over pi", [](double c) { return c / pi; }, 1.0 / pi)},
        {"extra-inverse-pi",
         "Each ray is divided by π. The π of the formula is in the density of the directions already.",
         "All rays together carry all the power: what is the sum over a closed room?",
         weighted(
             cosine, "cosine over pi", [](double) { return 1.0 / pi; }, 1.0 / pi)},
        {"extra-pi", "Each ray is multiplied by π. The π of the formula is in the density of the directions already.",
         "All rays together carry all the power: what is the sum over a closed room?",
         weighted(
             cosine, "cosine by pi", [](double) { return pi; }, pi)},
    };
}

std::vector<RayMistake> counts() {
    RayUse self, stale, silent;
    self.name = "self";
    self.leavesOutShooter = false;
    stale.addsToLast = true;
    stale.whole = either;
    silent.returnsShooter = false;
    return {
        {"self-hit", "The rays meet the patch that they start on, at the distance 0, and go no further.",
         "Which patch does scene.hit need to be told of, so that it leaves it out?", self},
        {"stale", "The rays are added to what formF held before, from an earlier shot.",
         "What must formF be before the first ray is counted, and of which patches?", stale},
        {"shooter-not-returned", "The form factors are right, but the function does not return the shooter.",
         "Who shoots? The caller needs to know.", silent},
        {"not-divided-by-rays",
         "The rays are counted, but the count is not divided by how many there are: a form factor is a share.",
         "What should the form factors of a closed room sum to, however many rays there are?",
         dividedBy([](int rays, double) { return rays; }, 0.0)},
        {"integer-division",
         "1 / rays is 0: both are whole numbers, so C++ drops the fraction. Nothing is left unless there is one ray.",
         "Which type does 1 / rays have, and which one does 1.0f / rays have?",
         dividedBy([](int rays, double) { return rays == 1 ? 1.0 : 0.0; }, 0.0)},
        {"divided-by-hits",
         "The counts are divided by the number of rays that meet anything. The light of the others leaves the scene, "
         "and is lost: the "
         "form factors of an open scene sum to less than 1.",
         "Which rays carry power?", dividedBy([](int, double met) { return met > 0.0 ? 1.0 / met : 0.0; }, either)},
        {"one-ray-short", "One ray too few is sent, or the sum is divided by one too many.",
         "With rays = 1, how often does your loop run?",
         dividedBy([](int rays, double) { return (rays - 1.0) / rays; }, either)},
        {"one-ray-short", "One ray too few is sent, or the sum is divided by one too many.",
         "With rays = 1, how often does your loop run, and what do you divide by?",
         dividedBy([](int rays, double) { return rays / (rays + 1.0); }, either)},
        {"one-ray-more", "One ray too many is sent, or the sum is divided by one too few.",
         "With rays = 1, how often does your loop run?",
         dividedBy([](int rays, double) { return (rays + 1.0) / rays; }, either)},
    };
}

}  // namespace

std::vector<RayMistake> rayMistakes() {
    std::vector<RayMistake> all;
    for (const std::vector<RayMistake>& some : {counts(), weights(), parts(), densities(), frames()})
        all.insert(all.end(), some.begin(), some.end());
    return all;
}

}  // namespace radlab::grader

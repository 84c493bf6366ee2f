// Stage 1, maxenergy_patch: which patch is the brightest.

#include <cmath>
#include <limits>
#include <utility>

#include "grader/stages/Meshes.h"
#include "grader/stages/Stage.h"

namespace radlab::grader {

namespace {

using Brightness = std::function<double(const MyPolygon&)>;

double lengthOf(const Vec3f& v) { return glm::length(glm::dvec3(v)); }
double radiosity(const MyPolygon& p) { return lengthOf(p.unshot_rad); }
double power(const MyPolygon& p) { return radiosity(p) * double(p.area); }

// How a patch is chosen.
struct Choice {
    Brightness brightness = power;
    std::size_t from = 0, dropped = 0;                        // patches passed over at both ends
    double above = -std::numeric_limits<double>::infinity();  // what the comparison starts from
    bool elseFirst = false;                                   // where none is above: the first patch, not nullptr
};

int best(const State& state, const Choice& choice) {
    int found = choice.elseFirst && !state.patches.empty() ? 0 : -1;
    double most = choice.above;
    for (std::size_t i = choice.from; i + choice.dropped < state.patches.size(); ++i) {
        const double value = choice.brightness(state.patches[i]);
        if (!(value > most)) continue;
        most = value;
        found = static_cast<int>(i);
    }
    return found;
}

int brightestIn(const State& state) { return best(state, Choice{}); }

Case caseOf(const std::string& what, State state) {
    Step step;
    step.function = "maxenergy_patch";
    step.state = std::move(state);
    step.wanted = {"patch.unshot_rad", "patch.rad"};
    return {what, {step}};
}

// What a patch has to shoot, before chance changes it by up to 2 %: so little that whatever "length" people take of a
// colour, the order remains.
struct Light {
    double radiosity, area;
    Vec3f reflectance;
    double before = 0.01;  // what was emitted, and has been shot: emission, and rad beside what is unshot
};

const Vec3f black(0.02f), grey(0.5f), white(0.9f), red(0.95f, 0.02f, 0.02f);

void give(Random& random, MyPolygon& patch, const Light& light, double unit) {
    const auto near = [&](double value) { return static_cast<float>(value) * random.vector(0.98, 1.02); };
    patch.unshot_rad = near(unit * light.radiosity);
    patch.area = near(light.area).x;
    patch.diffuse = light.reflectance;
    patch.rad = patch.unshot_rad + near(unit * light.before);
    patch.emissive = near(unit * light.before);
}

// Patches with the given light, and then dimmer ones.
State scene(Random& random, const std::vector<Light>& lights, int count, double unit) {
    State state = scattered(random, count);
    for (std::size_t i = 0; i < state.patches.size(); ++i) {
        const Light dim{random.between(0.05, 0.2), random.between(0.2, 0.5), random.vector(0.05, 0.9)};
        give(random, state.patches[i], i < lights.size() ? lights[i] : dim, unit);
    }
    return state;
}

// The brightest stand neither first nor last, which has its own check, and among many not where a byte can count to.
bool wellPlaced(const State& state) {
    const int from = state.patches.size() > 256 ? 256 : 1, last = static_cast<int>(state.patches.size()) - 1;
    for (const int brightest : {brightestIn(state), best(state, {radiosity})})
        if (brightest < from || brightest >= last) return false;
    return true;
}

State shuffled(Random& random, State state) {
    do shuffle(random, state);
    while (!wellPlaced(state));
    return state;
}

constexpr double bright = 100.0;  // a unit in which it plays no part what a comparison starts from

// The brightest by power and by radiosity are other patches, and reflectance, rad and emission lead elsewhere, too.
State contested(Random& random, int count) {
    return shuffled(random, scene(random, {{1, 5, black}, {4, 0.5, black}, {0.5, 0.5, white, 1e5}}, count, bright));
}

// Every rule that people believe in, B·A, B, A, B·A², B²·A, B/A, or reflected light, chooses another patch.
State rivals(Random& random, int count) {
    const std::vector<Light> lights = {
        {1, 1, black},    {9, 0.02, black}, {0.02, 8, black},  {0.16, 5, black},     {5, 0.12, red},
        {4, 0.005, grey}, {0.9, 0.9, red},  {0.89, 0.9, grey}, {0, 0.2, white, 1e5}, {0.01, 0.9, white, 5e4}};
    return shuffled(random, scene(random, lights, count, bright));
}

// The same patch by power and by radiosity: the first.
State uncontested(Random& random, int count) {
    return scene(random, {{5, 2, black}, {0.9, 0.9, white, 1e5}}, count, bright);
}

// One channel of one patch is the largest there is, but not its light as a whole.
State colored(Random& random, int channel) {
    State state = scene(random, {{5, 1, black}, {0.02, 0.9, white, 1e5}}, 6, bright);
    state.patches[0].unshot_rad[channel] *= 0.1f;
    state.patches[1].unshot_rad[channel] *= 55.0f;
    return shuffled(random, std::move(state));
}

// The highest power and the highest radiosity, of two patches, are both 3 units.
State ofBrightness(Random& random, double unit) {
    return shuffled(random, scene(random, {{0.5, 6, black}, {3, 0.25, black}, {0.3, 0.5, white, 1e5}}, 6, unit));
}

// Radiosities in one mesh that are spread over twelve orders of magnitude.
State spread(Random& random) {
    State state = scene(random, {{2e6, 1, black}, {1e6, 0.9, white, 1e5}}, 10, 1.0);
    for (std::size_t i = 2; i < state.patches.size(); ++i)
        state.patches[i].unshot_rad *= static_cast<float>(random.magnitude(1e-5, 1e5));
    return shuffled(random, std::move(state));
}

State dark(Random& random) {
    State state = scattered(random, 4);
    for (MyPolygon& patch : state.patches) patch.unshot_rad = Vec3f(0.0f);
    return state;
}

class MaxEnergy : public Stage {
public:
    std::string function() const override { return "maxenergy_patch"; }
    std::vector<Check> checks(std::uint64_t seed) const override;
    std::vector<Computation> right() const override;
    Numbers numbers(const Step& step, const State& before, const Outcome& outcome) const override;
    std::string name(const Step& step, std::size_t k) const override;
    std::string show(const Step& step, std::size_t k, double value) const override;
    std::string tolerance() const override { return "none; power or radiosity as the rule, as long as it is one"; }
    std::vector<Mistake> mistakes() const override;
    std::vector<std::string> inputs() const override { return {"area", "rad", "unshot_rad"}; }
};

Check rangeCheck(Random& random) {
    Check range{"max.range", {}};
    for (int exponent = -6; exponent <= 6; ++exponent)
        range.cases.push_back(caseOf("radiosities and powers up to 3e" + std::to_string(exponent),
                                     ofBrightness(random, std::pow(10.0, exponent))));
    range.cases.push_back(caseOf("radiosities over twelve orders of magnitude", spread(random)));
    return range;
}

Check placeCheck(Random& random) {
    State last = uncontested(random, 2);
    std::swap(last.patches[0], last.patches[1]);
    return {
        "max.place",
        {caseOf("the first patch is the brightest", uncontested(random, 2)),
         caseOf("the last patch is the brightest", std::move(last)), caseOf("a single patch", uncontested(random, 1))}};
}

std::vector<Check> MaxEnergy::checks(std::uint64_t seed) const {
    Random random(seed);
    Check brightest{"max.brightest", {}}, colors{"max.colors", {}};
    for (const int count : {4, 5})
        brightest.cases.push_back(
            caseOf(std::to_string(count) + " patches of unequal areas", contested(random, count)));
    for (const int count : {11, 20, 500})
        brightest.cases.push_back(
            caseOf(std::to_string(count) + " patches, large dim ones among small bright ones", rivals(random, count)));
    const std::vector<std::string> names = {"red", "green", "blue"};
    for (int channel = 0; channel < 3; ++channel)
        colors.cases.push_back(
            caseOf("much " + names[static_cast<std::size_t>(channel)] + " on one patch, more light on another",
                   colored(random, channel)));
    // First in its process: what is not there must not be found in memory that an earlier case has left.
    const Check none{"max.none", {caseOf("no patches", State{}), caseOf("nothing is unshot", dark(random))}};
    return {brightest, placeCheck(random), colors, rangeCheck(random), none};
}

// Returns a patch and leaves all as it was.
Computation returns(const std::function<int(const State&)>& index) {
    return [=](const Situation& at) {
        Outcome outcome;
        outcome.state = at.before;
        outcome.returned = index(at.before);
        return outcome;
    };
}

Computation chooses(const Choice& choice) {
    return returns([=](const State& state) { return best(state, choice); });
}

std::vector<Computation> MaxEnergy::right() const { return {chooses({power}), chooses({radiosity})}; }

Numbers MaxEnergy::numbers(const Step&, const State& before, const Outcome& outcome) const {
    double light = 0.0;
    for (const MyPolygon& patch : before.patches) light += power(patch);
    // Where nothing is unshot, every patch is as bright as the others, and nullptr says so, too.
    const bool any = !before.patches.empty() && light == 0.0;
    Numbers numbers{{static_cast<double>(outcome.returned)}, {any ? std::numeric_limits<double>::infinity() : 0.0}};
    for (const MyPolygon& patch : outcome.state.patches)
        for (const Vec3f* member : {&patch.unshot_rad, &patch.rad})
            for (int c = 0; c < 3; ++c) numbers.values.push_back(double((*member)[c]));
    numbers.slack.resize(numbers.values.size(), 0.0);
    return numbers;
}

std::string MaxEnergy::name(const Step&, std::size_t k) const {
    if (k == 0) return "the patch returned";
    const std::size_t value = (k - 1) % 6;
    return "polygons[" + std::to_string((k - 1) / 6) + "]->" + (value < 3 ? "unshot_rad[" : "rad[") +
           std::to_string(value % 3) + "]";
}

std::string MaxEnergy::show(const Step& step, std::size_t k, double value) const {
    if (k > 0) return Stage::show(step, k, value);
    if (value == -1) return "nullptr";
    if (value < -1) return "a patch that is not in `polygons` (a copy?)";
    return "polygons[" + std::to_string(static_cast<int>(value)) + "]";
}

// People weigh by area, or not, whatever else they believe.
Brightness weighed(const Brightness& light, bool timesArea) {
    return [=](const MyPolygon& p) { return light(p) * (timesArea ? double(p.area) : 1.0); };
}

std::vector<Mistake> wrongLight(bool timesArea) {
    const auto by = [=](const Brightness& light) { return chooses({weighed(light, timesArea)}); };
    const std::string albedo =
        "The reflectance is a factor in the comparison. It has done its part when the light arrived: what a patch has "
        "still to shoot is unshot_rad as it is.";
    const std::string albedoHint = "Does a black lamp shoot less light than a white one with the same unshot_rad?";
    std::vector<Mistake> all = {
        {"rad-for-unshot",
         "The patch with the most radiosity is returned, whether or not that light has been shot already. After its "
         "shot a patch keeps its radiosity, so the same one would be chosen for ever.",
         "Which member of MyPolygon becomes 0 when a patch has shot?",
         by([](const MyPolygon& p) { return lengthOf(p.rad); })},
        {"emission-for-unshot",
         "The patch that emits the most is returned. That is right for the first shot; later on, patches shoot what "
         "they reflect, and lamps have nothing left.",
         "Which member of MyPolygon changes from shot to shot?",
         by([](const MyPolygon& p) { return lengthOf(p.emissive); })},
        {"reflectance-as-factor", albedo, albedoHint,
         by([](const MyPolygon& p) { return lengthOf(p.diffuse * p.unshot_rad); })},
        {"reflectance-as-factor", albedo, albedoHint,
         by([](const MyPolygon& p) { return static_cast<double>(glm::dot(p.diffuse, p.unshot_rad)); })},
    };
    const std::vector<std::string> names = {"red", "green", "blue"};
    for (int c = 0; c < 3; ++c)
        all.push_back({"one-channel",
                       "Only the " + names[static_cast<std::size_t>(c)] +
                           " channel is compared, so a lamp of another colour counts for nothing.",
                       "A colour has three channels; which number says how much light it is as a whole?",
                       by([=](const MyPolygon& p) { return double(p.unshot_rad[c]); })});
    return all;
}

std::vector<Mistake> wrongWeight() {
    return {
        {"area-alone",
         "The largest patch is returned, whatever its light. One way to get there: v.length() of a Vec3f is the number "
         "of its channels, always 3; its length is length(v).",
         "Print what you compare, patch by patch. Does it change when unshot_rad does?",
         chooses({[](const MyPolygon& p) { return double(p.area); }})},
        {"area-squared", "The area is a factor twice. Power is radiosity times area: watts are W/m² times m².",
         "Which unit has what you compare?", chooses({[](const MyPolygon& p) { return power(p) * double(p.area); }})},
        {"light-squared",
         "The squared length of unshot_rad is multiplied by the area, which is not squared: bright small patches win "
         "over dim large ones of more power.",
         "sqr_length and length order patches alike as long as nothing else is a factor. What is the other factor?",
         chooses({[](const MyPolygon& p) { return radiosity(p) * power(p); }})},
        {"divided-by-area",
         "The radiosity is divided by the area. Radiosity is power per area already: power is radiosity times area.",
         "Of two patches with the same radiosity, which sends out more light, the small or the large one?",
         chooses({[](const MyPolygon& p) { return radiosity(p) / double(p.area); }})},
    };
}

constexpr double none = std::numeric_limits<double>::infinity();

std::vector<Mistake> wrongComparison(const Brightness& rule) {
    const Brightness least = [=](const MyPolygon& p) { return -rule(p); };
    const Brightness leastLit = [=](const MyPolygon& p) { return rule(p) > 0.0 ? -rule(p) : -none; };
    const std::string darkest =
        "The patch with the least unshot light is returned, not the one with the most: the comparison is the wrong "
        "way round.";
    const std::string darkestHint = "Which way does your comparison point when a brighter patch comes along?";
    std::vector<Mistake> all = {
        {"minimum", darkest, darkestHint, chooses({least})},
        {"minimum-above-zero", darkest + " Only patches with nothing to shoot are passed over.", darkestHint,
         chooses({leastLit})},
        {"first-patch-skipped", "The first patch is never looked at: indices start at 0.",
         "Try your loop by hand with a single patch.", chooses({rule, 1})},
        {"brightest-loses-its-light",
         "The right patch is chosen, but its unshot_rad is set to 0 on the way. distributeEnergy needs it: this "
         "function only looks.",
         "What shall the shooter shoot when you have taken its light?",
         [=](const Situation& at) {
             Outcome outcome = chooses({rule})(at);
             if (outcome.returned >= 0)
                 outcome.state.patches[static_cast<std::size_t>(outcome.returned)].unshot_rad = Vec3f(0.0f);
             return outcome;
         }},
    };
    for (const bool elseFirst : {false, true})
        all.push_back({"last-patch-skipped",
                       "The last patch is never looked at: indices go up to polygons.size() - 1, and that one counts.",
                       "Try your loop by hand with two patches, the second one brighter.",
                       chooses({rule, 0, 1, -none, elseFirst})});
    return all;
}

std::vector<Mistake> fixedStart(const Brightness& rule) {
    std::vector<Mistake> all;
    for (const double start : {1.0, 0.1, 0.01, 0.001, 0.0001, 0.00001})
        for (const bool elseFirst : {false, true})
            all.push_back({"fixed-start",
                           std::string("The comparison starts from a fixed brightness above 0. In a scene where all "
                                       "patches are dimmer, none is found, and ") +
                               (elseFirst ? "the first is" : "nullptr is") +
                               " returned. Scenes are lit in any unit, from moonlight to the sun.",
                           "What does your comparison start from? No brightness may be too small for it.",
                           chooses({rule, 0, 0, start, elseFirst})});
    return all;
}

std::vector<Mistake> wrongAnswer() {
    return {
        {"copy-returned",
         "A copy of the brightest patch is returned, which is no member of `polygons`. What others do to a copy, the "
         "scene never sees.",
         "`polygons` holds pointers. Which of them belongs to the brightest patch?",
         returns([](const State& state) { return state.patches.empty() ? -1 : -2; })},
        {"always-nullptr",
         "nullptr is returned, always. Either nothing is ever remembered, or it is the address of a local variable, "
         "which is gone when the function ends and which compilers turn into nullptr.",
         "Where do you keep the brightest patch found so far, and is that what you return?",
         returns([](const State&) { return -1; })},
        {"always-first",
         "The first patch is returned, always: no later one is ever found to be brighter. v.length() of a Vec3f, "
         "which is 3 for every colour, does that, and so does a comparison of a patch with itself.",
         "Print both sides of your comparison, patch by patch.",
         returns([](const State& state) { return state.patches.empty() ? -1 : 0; })},
        {"maximum-not-kept",
         "The last patch that has any light is returned: every patch is compared with where the search began, not with "
         "the brightest found so far.",
         "When a brighter patch is found, two things must be remembered.", returns([](const State& state) {
             int last = -1;
             for (std::size_t i = 0; i < state.patches.size(); ++i)
                 if (power(state.patches[i]) > 0.0) last = static_cast<int>(i);
             return last;
         })},
    };
}

// A patch made to begin the search with.
Mistake newPatch(const Brightness& rule) {
    return {"new-patch-for-none",
            "Where there are no patches, one is returned that is not in `polygons`: the one that the search began "
            "with. Callers take nullptr for an answer, and nothing else.",
            "What do you return where `polygons` is empty?",
            returns([=](const State& state) { return state.patches.empty() ? -2 : best(state, {rule}); })};
}

std::vector<Mistake> MaxEnergy::mistakes() const {
    std::vector<Mistake> all = wrongAnswer();
    const auto add = [&](const std::vector<Mistake>& some) { all.insert(all.end(), some.begin(), some.end()); };
    for (const bool timesArea : {true, false}) add(wrongLight(timesArea));
    add(wrongWeight());
    for (const Brightness& rule : {Brightness(power), Brightness(radiosity)}) {
        add(wrongComparison(rule));
        add(fixedStart(rule));
        all.push_back(newPatch(rule));
    }
    return all;
}

}  // namespace

std::unique_ptr<Stage> maxenergyStage() { return std::make_unique<MaxEnergy>(); }

}  // namespace radlab::grader

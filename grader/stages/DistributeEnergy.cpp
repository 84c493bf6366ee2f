// Stage 3, distributeEnergy: one shot, from one patch to all others.

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "grader/stages/ExponentFit.h"
#include "grader/stages/Meshes.h"
#include "grader/stages/Stage.h"

namespace radlab::grader {

namespace {

using Color = glm::dvec3;
using Gain = std::function<Color(const MyPolygon& from, const MyPolygon& to)>;

constexpr double pi = std::numbers::pi;

Color formula(const MyPolygon& from, const MyPolygon& to) {
    return Color(to.diffuse) * Color(from.unshot_rad) * double(to.formF) * double(from.area) / double(to.area);
}

void brighten(Vec3f& radiosity, const Color& gain) { radiosity = Vec3f(Color(radiosity) + gain); }

void toBoth(MyPolygon& patch, const Color& gain) {
    brighten(patch.rad, gain);
    brighten(patch.unshot_rad, gain);
}

// A way to shoot: the right one, but for what the mistakes change.
struct Shooting {
    Gain gain = formula;
    std::function<void(MyPolygon&, const Color& gain)> receive = toBoth;
    bool toItself = false;  // the loop does not pass over the shooter
    std::function<bool(std::size_t patch, std::size_t shooter, std::size_t count)> reached =
        [](std::size_t, std::size_t, std::size_t) { return true; };
    std::function<void(State&, const State& before, std::size_t shooter)> afterwards =
        [](State& state, const State&, std::size_t shooter) { state.patches[shooter].unshot_rad = Vec3f(0.0f); };
};

Computation shoots(const Shooting& shooting) {
    return [shooting](const Situation& at) {
        Outcome outcome;
        outcome.state = at.before;
        if (at.step.shooter < 0) return outcome;
        outcome.returned = 1;
        std::vector<MyPolygon>& patches = outcome.state.patches;
        const auto s = static_cast<std::size_t>(at.step.shooter);
        for (std::size_t j = 0; j < patches.size(); ++j)
            if ((j != s || shooting.toItself) && shooting.reached(j, s, patches.size()))
                shooting.receive(patches[j], shooting.gain(patches[s], patches[j]));
        shooting.afterwards(outcome.state, at.before, s);
        return outcome;
    };
}

Step shotOf(int shooter, const std::vector<std::string>& wanted) {
    Step step;
    step.function = "distributeEnergy";
    step.shooter = shooter;
    for (const std::string& member : wanted) step.wanted.push_back("patch." + member);
    return step;
}

Case oneShot(const std::string& what, State state, int shooter, const std::vector<std::string>& wanted) {
    Step step = shotOf(shooter, wanted);
    step.state = std::move(state);
    return {what, {step}};
}

// The shooter is bright, so that gains can be told from what is there already, and does not see itself.
State lit(Random& random, State state, int shooter) {
    MyPolygon& patch = state.patches[static_cast<std::size_t>(shooter)];
    patch.unshot_rad = random.vector(10.0, 100.0);
    patch.rad = patch.unshot_rad + random.vector(10.0, 100.0);
    patch.formF = 0.0f;
    return state;
}

State laterShot(Random& random, int count, int shooter) { return lit(random, scattered(random, count), shooter); }

// All is dark but for the lamp that shoots: any gain is seen in full.
State firstShot(Random& random, int count, int shooter) {
    State state = laterShot(random, count, shooter);
    for (MyPolygon& patch : state.patches)
        if (patch.formF > 0.0f) patch.rad = patch.unshot_rad = patch.emissive = Vec3f(0.0f);
    MyPolygon& lamp = state.patches[static_cast<std::size_t>(shooter)];
    lamp.rad = lamp.emissive = lamp.unshot_rad;
    return state;
}

Check radiosities(Random& random) {
    Check check{"dist.rad", {}};
    const int lamp = random.index(2), third = random.index(12), many = random.index(40);
    check.cases = {
        oneShot("a lamp and one patch", firstShot(random, 2, lamp), lamp, {"rad"}),
        oneShot("the shooter is the first of three patches", laterShot(random, 3, 0), 0, {"rad"}),
        oneShot("the shooter is the second of three patches", laterShot(random, 3, 1), 1, {"rad"}),
        oneShot("the shooter is the last of three patches", laterShot(random, 3, 2), 2, {"rad"}),
        oneShot("the first shot, 12 patches", firstShot(random, 12, third), third, {"rad"}),
        oneShot("the first shot, 40 patches", firstShot(random, 40, many), many, {"rad"}),
        oneShot("a later shot, 40 patches", laterShot(random, 40, many), many, {"rad"}),
    };
    return check;
}

// Reflectances that differ much by channel, a black patch and a mirror of one colour among them; a coloured lamp.
State colorful(Random& random, State state, int shooter) {
    for (MyPolygon& patch : state.patches) patch.diffuse[random.index(3)] = static_cast<float>(random.between(0, 0.05));
    state.patches.front().diffuse = Vec3f(0.0f);
    state.patches.back().diffuse = Vec3f(0.0f, 0.9f, 0.0f);
    state.patches[static_cast<std::size_t>(shooter)].diffuse = random.vector(0.1, 0.9);
    state.patches[static_cast<std::size_t>(shooter)].unshot_rad *= Vec3f(3.0f, 0.5f, 1.0f);
    return state;
}

Check channels(Random& random) {
    Check check{"dist.channels", {}};
    for (const int count : {3, 10}) {
        const int shooter = 1 + random.index(static_cast<std::size_t>(count) - 2);
        const std::string patches = std::to_string(count) + " patches of bright colours, one of them black";
        check.cases.push_back(
            oneShot(patches, colorful(random, firstShot(random, count, shooter), shooter), shooter, {"rad"}));
        check.cases.push_back(oneShot(patches + ", a later shot",
                                      colorful(random, laterShot(random, count, shooter), shooter), shooter, {"rad"}));
    }
    return check;
}

Check areas(Random& random) {
    Check check{"dist.areas", {}};
    for (const double size : {0.001, 1.0, 1000.0}) {
        const int shooter = random.index(8);
        State state = firstShot(random, 8, shooter);
        for (MyPolygon& patch : state.patches) patch.area = static_cast<float>(random.magnitude(0.001, 1000.0));
        state.patches[static_cast<std::size_t>(shooter)].area = static_cast<float>(size * random.between(1.0, 2.0));
        check.cases.push_back(oneShot("areas that differ up to a million times", state, shooter, {"rad"}));
    }
    return check;
}

Check unshot(Random& random) {
    Check check{"dist.unshot", {}};
    const int lamp = random.index(2), shooter = random.index(12);
    check.cases = {
        oneShot("a lamp and one patch", firstShot(random, 2, lamp), lamp, {"unshot_rad"}),
        oneShot("the shooter is the first of three patches", laterShot(random, 3, 0), 0, {"unshot_rad"}),
        oneShot("the shooter is the second of three patches", laterShot(random, 3, 1), 1, {"unshot_rad"}),
        oneShot("the shooter is the last of three patches", laterShot(random, 3, 2), 2, {"unshot_rad"}),
        oneShot("the first shot, 12 patches", firstShot(random, 12, shooter), shooter, {"unshot_rad"}),
        oneShot("a later shot, 12 patches", laterShot(random, 12, shooter), shooter, {"unshot_rad"}),
    };
    return check;
}

// Two patches shoot in turn, and the first once more; form factors stay, so both have none. Of many, neither stands first
// or last.
Case severalShots(Random& random, const std::string& what, int count) {
    const int first = count > 3 ? 1 + random.index(static_cast<std::size_t>(count) - 3) : 0, second = first + 1;
    const std::vector<std::string> wanted = {"rad", "unshot_rad"};
    State state = lit(random, laterShot(random, count, first), second);
    Case shots = oneShot(what, std::move(state), first, wanted);
    for (const int shooter : {second, first}) shots.steps.push_back(shotOf(shooter, wanted));
    return shots;
}

Check range(Random& random) {
    Check check{"dist.range", {}};
    for (const int exponent : {-6, -3, 3, 6}) {
        const int shooter = random.index(5);
        State state = laterShot(random, 5, shooter);
        for (MyPolygon& patch : state.patches)
            for (Vec3f* light : {&patch.rad, &patch.unshot_rad, &patch.emissive})
                *light *= static_cast<float>(std::pow(10.0, exponent));
        check.cases.push_back(
            oneShot("radiosities times 1e" + std::to_string(exponent), std::move(state), shooter, {"rad"}));
    }
    const int shooter = 256 + random.index(44);
    State state = firstShot(random, 300, shooter);
    for (MyPolygon& patch : state.patches)
        if (patch.formF > 0.0f) patch.rad = random.vector(1.0, 2.0) * static_cast<float>(random.magnitude(1e-6, 1e6));
    check.cases.push_back(
        oneShot("300 patches, radiosities over twelve orders of magnitude", std::move(state), shooter, {"rad"}));
    return check;
}

Check leftAlone(Random& random) {
    const int shooter = 1 + random.index(3);
    State dark = laterShot(random, 6, shooter), unseen = laterShot(random, 6, shooter);
    for (MyPolygon& patch : dark.patches) patch.unshot_rad = Vec3f(0.0f);
    for (std::size_t i = 0; i < 6; i += 2) unseen.patches[i].formF = 0.0f;
    return {"dist.alone",
            {oneShot("nothing is unshot", std::move(dark), shooter, {"rad", "unshot_rad"}),
             oneShot("some patches have the form factor 0", std::move(unseen), shooter, {"rad"}),
             oneShot("form factors, areas and materials after a shot", laterShot(random, 6, shooter), shooter,
                     {"diffuse", "emissive", "area", "formF"})}};
}

Check answers(Random& random) {
    const int shooter = random.index(3);
    const std::vector<std::string> wanted = {"rad", "unshot_rad"};
    return {"dist.null",
            {oneShot("what is returned after a shot", laterShot(random, 3, shooter), shooter, {}),
             oneShot("nullptr among patches", scattered(random, 3), -1, wanted),
             oneShot("nullptr where there are no patches", State{}, -1, wanted)}};
}

class DistributeEnergy : public Stage {
public:
    std::string function() const override { return "distributeEnergy"; }
    std::vector<Check> checks(std::uint64_t seed) const override;
    std::vector<Computation> right() const override { return {shoots(Shooting{})}; }
    Numbers numbers(const Step& step, const State& before, const Outcome& outcome) const override;
    std::string name(const Step& step, std::size_t k) const override;
    std::string show(const Step& step, std::size_t k, double value) const override;
    std::string tolerance() const override {
        return "0.002 % of what was there and what is added: float arithmetic in any order";
    }
    std::vector<Mistake> mistakes() const override;
    std::optional<Diagnosis> fit(const std::vector<Comparison>& comparisons) const override;
    std::vector<std::string> inputs() const override {
        return {"diffuse", "emissive", "area", "formF", "rad", "unshot_rad"};
    }
};

std::vector<Check> DistributeEnergy::checks(std::uint64_t seed) const {
    Random random(seed);
    Check twice{"dist.twice", {}};
    for (const int count : {3, 20})
        twice.cases.push_back(
            severalShots(random, "three shots, one after the other, " + std::to_string(count) + " patches", count));
    return {radiosities(random), channels(random),  areas(random),  unshot(random), twice,
            range(random),       leftAlone(random), answers(random)};
}

constexpr double anything = std::numeric_limits<double>::infinity();

bool wants(const Step& step, const std::string& member) {
    return std::find(step.wanted.begin(), step.wanted.end(), "patch." + member) != step.wanted.end();
}

// The numbers of a patch, one after the other.
struct PatchNumber {
    const char* member;
    Vec3f MyPolygon::*color;  // either this or the next
    float MyPolygon::*number;
    int channels;
};

const std::vector<PatchNumber> patchNumbers = {
    {"rad", &MyPolygon::rad, nullptr, 3},         {"unshot_rad", &MyPolygon::unshot_rad, nullptr, 3},
    {"diffuse", &MyPolygon::diffuse, nullptr, 3}, {"emissive", &MyPolygon::emissive, nullptr, 3},
    {"area", nullptr, &MyPolygon::area, 1},       {"formF", nullptr, &MyPolygon::formF, 1},
};
constexpr std::size_t numbersOfPatch = 14;

double valueOf(const MyPolygon& patch, const PatchNumber& number, int channel) {
    return double(number.color ? (patch.*number.color)[channel] : patch.*number.number);
}

Numbers DistributeEnergy::numbers(const Step& step, const State& before, const Outcome& outcome) const {
    // What is returned is compared only where it is asked for: one mistake costs its own marks.
    const bool compared = step.shooter < 0 || step.wanted.empty();
    Numbers numbers{{static_cast<double>(outcome.returned)}, {compared ? 0.0 : anything}};
    for (std::size_t j = 0; j < before.patches.size(); ++j)
        for (const PatchNumber& number : patchNumbers)
            for (int c = 0; c < number.channels; ++c) {
                const double value = valueOf(outcome.state.patches[j], number, c);
                const double was = valueOf(before.patches[j], number, c);
                numbers.values.push_back(value);
                numbers.slack.push_back(wants(step, number.member) ? 2e-5 * (std::abs(was) + std::abs(value - was))
                                                                   : anything);
            }
    return numbers;
}

std::string DistributeEnergy::name(const Step& step, std::size_t k) const {
    if (k == 0) return "what is returned";
    std::size_t place = (k - 1) % numbersOfPatch;
    const std::size_t patch = (k - 1) / numbersOfPatch;
    std::string text = "polygons[" + std::to_string(patch) + "]->";
    for (const PatchNumber& number : patchNumbers) {
        const auto channelCount = static_cast<std::size_t>(number.channels);
        if (place < channelCount) {
            text += number.member + (number.color ? "[" + std::to_string(place) + "]" : std::string());
            break;
        }
        place -= channelCount;
    }
    return static_cast<int>(patch) == step.shooter ? text + " (the shooter)" : text;
}

std::string DistributeEnergy::show(const Step& step, std::size_t k, double value) const {
    if (k == 0) return value == 0.0 ? "false" : "true";
    return Stage::show(step, k, value);
}

// The fit on what dark patches have gained: there the gain is known to full precision.
std::optional<Diagnosis> fitGains(const std::vector<Comparison>& comparisons, std::size_t member) {
    Factor reflectance{"the reflectance"}, shooters{"the shooter's reflectance", {}, 0.0},
        formFactor{"the form factor"}, areaFrom{"the shooter's area"}, areaTo{"the receiver's area", {}, -1.0},
        light{"the shooter's unshot_rad"};
    std::vector<double> ratios;
    for (const Comparison& comparison : comparisons) {
        if (comparison.step.shooter < 0 || !wants(comparison.step, patchNumbers[member].member)) continue;
        const MyPolygon& from = comparison.before.patches[static_cast<std::size_t>(comparison.step.shooter)];
        for (std::size_t j = 0; j < comparison.before.patches.size(); ++j)
            for (int c = 0; c < 3; ++c) {
                const MyPolygon& to = comparison.before.patches[j];
                const std::size_t k = 1 + numbersOfPatch * j + 3 * member + static_cast<std::size_t>(c);
                const double expected = comparison.expected.values[k], found = comparison.found.values[k];
                if (valueOf(to, patchNumbers[member], c) != 0.0 || !(expected > 0.0)) continue;
                if (!(found > 0.0)) return std::nullopt;
                ratios.push_back(std::log(found / expected));
                reflectance.logs.push_back(std::log(double(to.diffuse[c])));
                shooters.logs.push_back(std::log(double(from.diffuse[c])));
                formFactor.logs.push_back(std::log(double(to.formF)));
                areaFrom.logs.push_back(std::log(double(from.area)));
                areaTo.logs.push_back(std::log(double(to.area)));
                light.logs.push_back(std::log(double(from.unshot_rad[c])));
            }
    }
    return fitExponents(ratios, {reflectance, shooters, formFactor, areaFrom, areaTo, light});
}

std::optional<Diagnosis> DistributeEnergy::fit(const std::vector<Comparison>& comparisons) const {
    for (const std::size_t member : {std::size_t{0}, std::size_t{1}})
        if (std::optional<Diagnosis> found = fitGains(comparisons, member)) return found;
    return std::nullopt;
}

Computation gains(const Gain& gain, bool toItself = false) {
    Shooting shooting;
    shooting.gain = gain;
    shooting.toItself = toItself;
    return shoots(shooting);
}

// Right but for a factor.
Computation times(const Gain& factor) {
    return gains([factor](const MyPolygon& from, const MyPolygon& to) { return formula(from, to) * factor(from, to); });
}

Computation timesNumber(const std::function<double(const MyPolygon& from, const MyPolygon& to)>& factor) {
    return times([factor](const MyPolygon& from, const MyPolygon& to) { return Color(factor(from, to)); });
}

// Reflects with something else than the receiver's reflectance.
Computation reflects(const std::function<Color(const MyPolygon& from, const MyPolygon& to)>& reflectance) {
    return gains([reflectance](const MyPolygon& from, const MyPolygon& to) {
        MyPolygon white = to;
        white.diffuse = Vec3f(1.0f);
        return formula(from, white) * reflectance(from, to);
    });
}

std::vector<Mistake> reflectances() {
    const std::string missingHint = "How much light does a black patch send on?";
    std::vector<Mistake> all = {
        {"reflectance-missing",
         "All that arrives is sent on, as if every patch were perfectly white. A patch reflects the share that diffuse "
         "says, and swallows the rest; without that, the light in a closed room never ends.",
         missingHint, reflects([](const MyPolygon&, const MyPolygon&) { return Color(1.0); })},
        {"reflectance-squared", "The reflectance is a factor twice: light is reflected once as it arrives.",
         "Follow diffuse through your code: where does it come in, and how often?",
         reflects([](const MyPolygon&, const MyPolygon& to) { return Color(to.diffuse) * Color(to.diffuse); })},
        {"reflectance-of-shooter",
         "The reflectance of the shooter is used. What decides how much light a patch sends on is its own.",
         "The shooter's unshot_rad has left it already. Which patch does the light meet now?",
         reflects([](const MyPolygon& from, const MyPolygon&) { return Color(from.diffuse); })},
        {"reflectance-of-both",
         "The reflectances of both patches are factors. The shooter's has done its part when the light arrived "
         "there: its unshot_rad is light on its way out.",
         "At how many surfaces is the light reflected on its way from unshot_rad to a patch?",
         reflects([](const MyPolygon& from, const MyPolygon& to) { return Color(from.diffuse) * Color(to.diffuse); })},
    };
    const auto scalar = [&](const std::string& which, const std::function<double(const Vec3f&)>& of) {
        all.push_back({"reflectance-scalar",
                       "One number stands in for the reflectance, " + which +
                           ", so that red and blue patches reflect like grey ones.",
                       "What colour has white light after a red wall has reflected it?",
                       reflects([of](const MyPolygon&, const MyPolygon& to) { return Color(of(to.diffuse)); })});
    };
    scalar("its red channel", [](const Vec3f& v) { return double(v.x); });
    scalar("its green channel", [](const Vec3f& v) { return double(v.y); });
    scalar("its blue channel", [](const Vec3f& v) { return double(v.z); });
    scalar("the mean of its channels", [](const Vec3f& v) { return (double(v.x) + double(v.y) + double(v.z)) / 3; });
    scalar("its luminance", [](const Vec3f& v) { return glm::dot(Color(v), Color(0.2126, 0.7152, 0.0722)); });
    scalar("its length", [](const Vec3f& v) { return glm::length(Color(v)); });
    return all;
}

std::vector<Mistake> areaMistakes() {
    const auto from = [](const MyPolygon& p) { return double(p.area); };
    const std::string hint =
        "unshot_rad is power per area. How much power leaves the shooter, how much of it arrives, and on which area?";
    return {
        {"areas-missing",
         "The ratio of the areas is missing. That would be right with form factors the other way round: "
         "F(j→s) = F(s→j)·As/Aj by reciprocity. Here formF is F(s→j), the share of the shooter's power, as the "
         "hemicube gives it.",
         hint, timesNumber([=](const MyPolygon& s, const MyPolygon& j) { return from(j) / from(s); })},
        {"areas-inverted",
         "The ratio of the areas is upside down: light that falls on a small patch is dense, on a large one thin.",
         hint,
         timesNumber([=](const MyPolygon& s, const MyPolygon& j) { return from(j) * from(j) / (from(s) * from(s)); })},
        {"area-receiver-missing",
         "The receiver's area is missing: what is added is power, in watts. Radiosity is power per area of the patch "
         "that has it.",
         hint, timesNumber([=](const MyPolygon&, const MyPolygon& j) { return from(j); })},
        {"area-shooter-missing",
         "The shooter's area is missing: a large lamp would give no more light than a small one of the same "
         "radiosity.",
         hint, timesNumber([=](const MyPolygon& s, const MyPolygon&) { return 1.0 / from(s); })},
        {"areas-multiplied", "Both areas multiply. The larger a receiver, the thinner is the light spread on it.", hint,
         timesNumber([=](const MyPolygon&, const MyPolygon& j) { return from(j) * from(j); })},
    };
}

// Without the form factor, a loop that does not pass over the shooter lights it, too.
Color withoutFormFactor(const MyPolygon& from, const MyPolygon& to) {
    MyPolygon seen = to;
    seen.formF = 1.0f;
    return formula(from, seen);
}

std::vector<Mistake> factors() {
    std::vector<Mistake> all = {
        {"form-factor-squared", "The form factor is a factor twice.",
         "Follow formF through your code: where does it come in, and how often?",
         timesNumber([](const MyPolygon&, const MyPolygon& to) { return double(to.formF); })},
        {"divided-by-pi",
         "What arrives is divided by π. The π of diffuse surfaces is in the form factors already; radiosity is divided "
         "by it only to get the radiance that is displayed.",
         "In which stage does the task ask for 1/π?",
         timesNumber([](const MyPolygon&, const MyPolygon&) { return 1.0 / pi; })},
        {"multiplied-by-pi",
         "What arrives is multiplied by π. Shooting goes from radiosity to radiosity: no π comes in.",
         "In which stages does the task speak of π?",
         timesNumber([](const MyPolygon&, const MyPolygon&) { return pi; })},
        {"gain-doubled", "What arrives is added twice.", "How often is rad changed in one turn of your loop?",
         timesNumber([](const MyPolygon&, const MyPolygon&) { return 2.0; })},
    };
    for (const bool toItself : {false, true})
        all.push_back({"form-factor-missing",
                       "The form factor is missing: every patch gets all the light that leaves the shooter, whether or "
                       "not it can see it.",
                       "What share of the shooter's power arrives at one patch, and which member of it says so?",
                       gains(withoutFormFactor, toItself)});
    return all;
}

// Shoots something else than the shooter's unshot radiosity.
Mistake shootsInstead(const std::string& id, const std::string& text, const std::string& hint,
                      const std::function<Color(const MyPolygon& from, const MyPolygon& to)>& light) {
    return {id, text, hint, gains([light](const MyPolygon& from, const MyPolygon& to) {
                MyPolygon shooter = from;
                shooter.unshot_rad = Vec3f(1.0f);
                return formula(shooter, to) * light(from, to);
            })};
}

std::vector<Mistake> sources() {
    using Patch = const MyPolygon&;
    const auto grey = [](const Vec3f& v) { return Color((double(v.x) + double(v.y) + double(v.z)) / 3.0); };
    return {
        shootsInstead("rad-for-unshot",
                      "The shooter's whole radiosity is shot. What it has shot before is counted again with every "
                      "shot, and the scene gets brighter for ever.",
                      "Which part of its radiosity has the shooter not sent out yet?",
                      [](Patch from, Patch) { return Color(from.rad); }),
        shootsInstead(
            "emission-for-unshot",
            "What the shooter emits by itself is shot. That is right for the first shot of a lamp; walls have "
            "no emission and would never pass light on.",
            "Which member of the shooter grows when light arrives, and becomes 0 when it has shot?",
            [](Patch from, Patch) { return Color(from.emissive); }),
        shootsInstead("receiver-for-shooter",
                      "The receiver's own unshot_rad is used. The light that arrives is what the shooter sends.",
                      "Whose light is on its way in this shot?", [](Patch, Patch to) { return Color(to.unshot_rad); }),
        shootsInstead("light-as-grey",
                      "The shooter's unshot_rad is turned into one number, the mean of its channels: light loses its "
                      "colour on the way.",
                      "What colour has a white wall in red light?",
                      [=](Patch from, Patch) { return grey(from.unshot_rad); }),
        shootsInstead("first-channel-for-all",
                      "The red channel of the shooter's unshot_rad is shot in all three channels.",
                      "What colour has a white wall in red light?",
                      [](Patch from, Patch) { return Color(double(from.unshot_rad.x)); }),
        shootsInstead("first-channel-only", "Only the red channel is shot; green and blue arrive nowhere.",
                      "How many channels has a Vec3f?",
                      [](Patch from, Patch) { return Color(double(from.unshot_rad.x), 0.0, 0.0); }),
    };
}

using Receive = std::function<void(MyPolygon&, const Color& gain)>;

Computation receives(const Receive& receive, bool toItself = false) {
    Shooting shooting;
    shooting.receive = receive;
    shooting.toItself = toItself;
    return shoots(shooting);
}

// The same mistake in a loop that passes over the shooter, and in one that does not.
void addBoth(std::vector<Mistake>& all, const Mistake& mistake, const Receive& receive) {
    for (const bool toItself : {false, true})
        all.push_back({mistake.id, mistake.text, mistake.hint, receives(receive, toItself)});
}

std::vector<Mistake> assignments() {
    const std::string text =
        " A patch is lit in many shots, by many others: each adds to what is there (+=), none replaces it (=).";
    const std::string hint = "What becomes of the light of the shot before?";
    std::vector<Mistake> all;
    addBoth(all, {"rad-assigned", "What arrives replaces rad." + text, hint, {}},
            [](MyPolygon& patch, const Color& gain) {
                patch.rad = Vec3f(gain);
                brighten(patch.unshot_rad, gain);
            });
    addBoth(all, {"unshot-assigned", "What arrives replaces unshot_rad." + text, hint, {}},
            [](MyPolygon& patch, const Color& gain) {
                brighten(patch.rad, gain);
                patch.unshot_rad = Vec3f(gain);
            });
    addBoth(all, {"both-assigned", "What arrives replaces rad and unshot_rad." + text, hint, {}},
            [](MyPolygon& patch, const Color& gain) { patch.rad = patch.unshot_rad = Vec3f(gain); });
    return all;
}

std::vector<Mistake> receivers() {
    std::vector<Mistake> all = {
        {"only-rad",
         "What arrives is added to rad alone. What a patch has received it must shoot on in its turn: without that, "
         "there is no indirect light.",
         "From which member does a patch shoot when its turn comes?",
         receives([](MyPolygon& patch, const Color& gain) { brighten(patch.rad, gain); })},
        {"only-unshot",
         "What arrives is added to unshot_rad alone. It is passed on, but never seen: the picture is made of rad.",
         "From which member is the picture made?",
         receives([](MyPolygon& patch, const Color& gain) { brighten(patch.unshot_rad, gain); })},
        {"gain-doubled-in-rad", "What arrives is added to rad twice, and to unshot_rad once.",
         "How often is rad changed in one turn of your loop?", receives([](MyPolygon& patch, const Color& gain) {
             brighten(patch.rad, 2.0 * gain);
             brighten(patch.unshot_rad, gain);
         })},
    };
    const std::string emission =
        "The emission of a patch is added again with every shot. It is in rad and unshot_rad from the start.";
    const std::string emissionHint = "How often may a lamp be switched on?";
    addBoth(all, {"emission-added", emission, emissionHint, {}}, [](MyPolygon& patch, const Color& gain) {
        toBoth(patch, gain);
        brighten(patch.rad, Color(patch.emissive));
    });
    addBoth(all, {"emission-added", emission, emissionHint, {}},
            [](MyPolygon& patch, const Color& gain) { toBoth(patch, gain + Color(patch.emissive)); });
    addBoth(all,
            {"unshot-added-to-rad",
             "All of unshot_rad is added to rad, not only what has arrived in this shot: what came earlier counts "
             "again and again.",
             "What is in unshot_rad beside the light of this shot?",
             {}},
            [](MyPolygon& patch, const Color& gain) {
                brighten(patch.unshot_rad, gain);
                brighten(patch.rad, Color(patch.unshot_rad));
            });
    addBoth(all,
            {"unshot-is-rad",
             "unshot_rad is set to rad: what the patch has shot before is to be shot again, and the light never ends.",
             "Which part of rad is unshot, and is it all of it?",
             {}},
            [](MyPolygon& patch, const Color& gain) {
                brighten(patch.rad, gain);
                patch.unshot_rad = patch.rad;
            });
    return all;
}

using Afterwards = std::function<void(State&, const State& before, std::size_t shooter)>;

Computation ends(const Afterwards& afterwards) {
    Shooting shooting;
    shooting.afterwards = afterwards;
    return shoots(shooting);
}

// Right but for what becomes of the shooter.
Computation leaves(const std::function<void(MyPolygon& shooter, const MyPolygon& before)>& change) {
    return ends([change](State& state, const State& before, std::size_t s) {
        state.patches[s].unshot_rad = Vec3f(0.0f);
        change(state.patches[s], before.patches[s]);
    });
}

std::vector<Mistake> shooterMistakes() {
    const std::string nothingLeft =
        " After a shot nothing is left to shoot, whatever was hit or missed: unshot_rad is 0.";
    const std::string keepsHint = "Which patch will be the brightest in the next shot?";
    const std::string radHint = "Does a lamp go dark because its light has been counted?";
    return {
        {"unshot-kept",
         "The shooter keeps its unshot_rad, and so remains the brightest: the same patch shoots the same light for "
         "ever.",
         keepsHint, leaves([](MyPolygon& shooter, const MyPolygon& was) { shooter.unshot_rad = was.unshot_rad; })},
        {"unshot-decays",
         "The shooter's unshot_rad is multiplied by 1 - ρ, as if it swallowed its own light." + nothingLeft, keepsHint,
         leaves([](MyPolygon& shooter, const MyPolygon& was) {
             shooter.unshot_rad = was.unshot_rad * (Vec3f(1.0f) - was.diffuse);
         })},
        {"unshot-decays", "The shooter's unshot_rad is multiplied by its reflectance." + nothingLeft, keepsHint,
         leaves([](MyPolygon& shooter, const MyPolygon& was) { shooter.unshot_rad = was.unshot_rad * was.diffuse; })},
        {"unshot-decays", "The shooter's unshot_rad is halved, not emptied." + nothingLeft, keepsHint,
         leaves([](MyPolygon& shooter, const MyPolygon& was) { shooter.unshot_rad = was.unshot_rad * 0.5f; })},
        {"unshot-is-emission",
         "The shooter's unshot_rad is set back to its emission, so a lamp shoots its first light again and again." +
             nothingLeft,
         "How often may a lamp be switched on?",
         leaves([](MyPolygon& shooter, const MyPolygon& was) { shooter.unshot_rad = was.emissive; })},
        {"shooter-loses-rad",
         "The shooter's rad is set to 0, too. It has sent its light out, but it still looks as bright as before: rad "
         "is what one sees of it.",
         radHint, leaves([](MyPolygon& shooter, const MyPolygon&) { shooter.rad = Vec3f(0.0f); })},
        {"shooter-loses-rad",
         "What is shot is taken from the shooter's rad. It has sent its light out, but it still looks as bright as "
         "before: rad is what one sees of it.",
         radHint, leaves([](MyPolygon& shooter, const MyPolygon& was) { shooter.rad = was.rad - was.unshot_rad; })},
        {"shooter-gains-rad",
         "The shooter's unshot_rad is added to its own rad. It is in there already, since the light arrived.",
         "When light arrives at a patch, which members grow?",
         leaves([](MyPolygon& shooter, const MyPolygon& was) { shooter.rad = was.rad + was.unshot_rad; })},
        {"all-unshot-zeroed",
         "unshot_rad of every patch is set to 0, not that of the shooter alone: what the others have received is lost "
         "before they could send it on.",
         "Which patches have shot in this call?", ends([](State& state, const State&, std::size_t) {
             for (MyPolygon& patch : state.patches) patch.unshot_rad = Vec3f(0.0f);
         })},
        {"wrong-unshot-zeroed",
         "unshot_rad of the receivers is set to 0, and the shooter keeps its own: the other way round.",
         "Which patches have shot in this call?", ends([](State& state, const State&, std::size_t s) {
             for (std::size_t j = 0; j < state.patches.size(); ++j)
                 if (j != s) state.patches[j].unshot_rad = Vec3f(0.0f);
         })},
    };
}

Computation reaches(const std::function<bool(std::size_t patch, std::size_t shooter, std::size_t count)>& reached) {
    Shooting shooting;
    shooting.reached = reached;
    return shoots(shooting);
}

std::vector<Mistake> zeroedEarly() {
    const std::string hint = "What does the next patch of the loop find in the shooter's unshot_rad?";
    const std::string text = " It may become 0 only when all patches have got their share.";
    return {
        {"zeroed-first",
         "Nothing arrives at any patch. Either the shooter's unshot_rad is set to 0 before the loop has used it, or "
         "the "
         "loop changes copies of the patches.",
         hint, reaches([](std::size_t, std::size_t, std::size_t) { return false; })},
        {"zeroed-in-loop",
         "The shooter's unshot_rad is set to 0 in the loop, when its turn comes: patches after it get nothing." + text,
         hint, reaches([](std::size_t j, std::size_t s, std::size_t) { return j < s; })},
        {"zeroed-in-loop",
         "The shooter's unshot_rad is set to 0 in the first turn of the loop: only one patch gets light." + text, hint,
         reaches([](std::size_t j, std::size_t s, std::size_t) { return j == (s == 0 ? 1u : 0u); })},
        {"zeroed-in-loop",
         "The shooter's unshot_rad is set to 0 in the first turn of the loop: only the first patch gets light." + text,
         hint, reaches([](std::size_t j, std::size_t, std::size_t) { return j == 0; })},
        {"last-patch-skipped",
         "The last patch never gets any light: indices go up to polygons.size() - 1, and that one counts.",
         "Try your loop by hand with two patches.",
         reaches([](std::size_t j, std::size_t, std::size_t count) { return j + 1 < count; })},
        {"first-patch-skipped", "The first patch never gets any light: indices start at 0.",
         "Try your loop by hand with two patches.",
         reaches([](std::size_t j, std::size_t, std::size_t) { return j > 0; })},
        {"shooter-receives",
         "What the others reflect is added to the shooter: the light is counted into the parameter, not into the patch "
         "of the loop.",
         "Which of the two patches in your loop is the one that gets brighter?",
         [](const Situation& at) {
             Outcome outcome;
             outcome.state = at.before;
             if (at.step.shooter < 0) return outcome;
             outcome.returned = 1;
             MyPolygon& shooter = outcome.state.patches[static_cast<std::size_t>(at.step.shooter)];
             for (const MyPolygon& patch : at.before.patches) toBoth(shooter, formula(shooter, patch));
             shooter.unshot_rad = Vec3f(0.0f);
             return outcome;
         }},
    };
}

Computation returns(const std::function<int(int shooter)>& answer) {
    return [answer](const Situation& at) {
        Outcome outcome = shoots(Shooting{})(at);
        outcome.returned = answer(at.step.shooter);
        return outcome;
    };
}

std::vector<Mistake> wrongAnswers() {
    const std::string hint =
        "Who calls distributeEnergy goes on as long as it returns true. When is there no more to do?";
    return {
        {"returns-false", "false is returned after a shot, too: whoever calls takes it for the end.", hint,
         returns([](int) { return 0; })},
        {"returns-true-for-nullptr", "true is returned for nullptr, too: whoever calls would go on for ever.", hint,
         returns([](int) { return 1; })},
        {"answers-swapped", "true is returned for nullptr and false after a shot: the other way round.", hint,
         returns([](int shooter) { return shooter < 0 ? 1 : 0; })},
        {"nothing-done", "Nothing changes: neither the shooter nor any other patch.",
         "Does your loop change the patches of `polygons`, or copies of them?",
         [](const Situation& at) {
             Outcome outcome;
             outcome.state = at.before;
             outcome.returned = at.step.shooter < 0 ? 0 : 1;
             return outcome;
         }},
    };
}

std::vector<Mistake> DistributeEnergy::mistakes() const {
    std::vector<Mistake> all;
    for (const std::vector<Mistake>& some : {reflectances(), areaMistakes(), factors(), sources(), assignments(),
                                             receivers(), shooterMistakes(), zeroedEarly(), wrongAnswers()})
        all.insert(all.end(), some.begin(), some.end());
    return all;
}

}  // namespace

std::unique_ptr<Stage> distributeStage() { return std::make_unique<DistributeEnergy>(); }

}  // namespace radlab::grader

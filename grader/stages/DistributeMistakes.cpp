#include "grader/stages/DistributeMistakes.h"

#include <cmath>
#include <numbers>

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
             // In floats: what is added grows with what was added, perhaps beyond all of them.
             for (std::size_t j = 0; j < at.before.patches.size(); ++j) {
                 if (static_cast<int>(j) == at.step.shooter) continue;
                 const MyPolygon& patch = at.before.patches[j];
                 const Vec3f gain = patch.diffuse * shooter.unshot_rad * (patch.formF * shooter.area / patch.area);
                 shooter.rad += gain;
                 shooter.unshot_rad += gain;
             }
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

}  // namespace

Computation distributes() { return shoots(Shooting{}); }

std::vector<Mistake> distributeMistakes() {
    std::vector<Mistake> all;
    for (const std::vector<Mistake>& some : {reflectances(), areaMistakes(), factors(), sources(), assignments(),
                                             receivers(), shooterMistakes(), zeroedEarly(), wrongAnswers()})
        all.insert(all.end(), some.begin(), some.end());
    return all;
}

}  // namespace radlab::grader

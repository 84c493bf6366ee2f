#include "grader/stages/ColorMistakes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace radlab::grader {

namespace {

using Color = glm::dvec3;

constexpr double pi = std::numbers::pi;

// What a vertex has got when the patches are gone through.
struct Sum {
    Color color{0.0}, rad{0.0};
    double weight = 0.0;
    int count = 0;
};

void addPlainly(Sum& sum, const MyPolygon& patch) {
    sum.color += Color(patch.color);
    sum.rad += Color(patch.rad);
    ++sum.count;
}

MyVertex vertexOf(const MyVertex& before, const Color& color, const Color& rad, int count) {
    MyVertex vertex = before;
    vertex.color = Vec3f(color);
    vertex.rad = Vec3f(rad);
    vertex.colorcount = count;
    return vertex;
}

MyVertex mean(const MyVertex& before, const Sum& sum) {
    const double count = std::max(sum.count, 1);
    return vertexOf(before, sum.color / count, sum.rad / count, sum.count);
}

// A way to reconstruct colours: the right one, but for what the mistakes change.
struct Reconstruction {
    std::function<Color(const MyPolygon&)> radiance = [](const MyPolygon& patch) { return Color(patch.rad) / pi; };
    std::function<int(const MyPolygon&)> corners = [](const MyPolygon& patch) { return patch.vertices; };
    std::function<Sum(const MyVertex&)> start = [](const MyVertex&) { return Sum{}; };
    std::function<void(Sum&, const MyPolygon&)> add = addPlainly;
    std::function<MyVertex(const MyVertex& before, const Sum&)> finish = mean;
    std::function<void(State&, const State& before)> afterwards = [](State&, const State&) {};
};

Computation reconstructsSo(const Reconstruction& way) {
    return [way](const Situation& at) {
        Outcome outcome;
        outcome.state = at.before;
        State& state = outcome.state;
        std::vector<Sum> sums;
        for (const MyVertex& corner : state.corners) sums.push_back(way.start(corner));
        for (MyPolygon& patch : state.patches) patch.color = Vec3f(way.radiance(patch));
        for (const MyPolygon& patch : state.patches)
            for (int i = 0; i < way.corners(patch); ++i)
                if (patch.vertex[i] >= 0) way.add(sums[static_cast<std::size_t>(patch.vertex[i])], patch);
        for (std::size_t i = 0; i < sums.size(); ++i) state.corners[i] = way.finish(at.before.corners[i], sums[i]);
        way.afterwards(state, at.before);
        return outcome;
    };
}

Computation with(const std::function<void(Reconstruction&)>& change) {
    Reconstruction way;
    change(way);
    return reconstructsSo(way);
}

Computation displays(const std::function<Color(const MyPolygon&)>& radiance) {
    return with([&](Reconstruction& way) { way.radiance = radiance; });
}

// Right but for a factor.
Computation times(double factor) {
    return displays([factor](const MyPolygon& patch) { return factor / pi * Color(patch.rad); });
}

// The radiance, changed channel by channel.
Computation maps(const std::function<double(double)>& curve) {
    return displays([curve](const MyPolygon& patch) {
        const Color radiance = Color(patch.rad) / pi;
        return Color(curve(radiance.x), curve(radiance.y), curve(radiance.z));
    });
}

std::vector<Mistake> constants() {
    return {
        {"missing-inverse-pi",
         "The radiosity itself is displayed. Radiosity is what leaves a patch in all directions together; what one "
         "direction sees of a diffuse patch is the radiance, a πth of it.",
         "By what does the task divide rad?", times(pi)},
        {"multiplied-by-pi", "The radiosity is multiplied by π where it should be divided by it.",
         "M_PI and M_1_PI are not the same.", times(pi * pi)},
        {"divided-by-two-pi",
         "The radiosity is divided by 2π, the solid angle of the hemisphere. Weighted by the cosine, as light that "
         "leaves a surface is, the hemisphere counts π.",
         "Integrate the cosine over the hemisphere: what comes out?", times(0.5)},
        {"divided-by-four-pi",
         "The radiosity is divided by 4π, as for a point that shines all round. A patch shines into one hemisphere, "
         "weighted by the cosine: that makes π.",
         "Integrate the cosine over the hemisphere: what comes out?", times(0.25)},
        {"pi-too-rough", "π is taken to be 3.14, which is off by 0.05 %.", "ProgRef.h brings M_PI and M_1_PI.",
         times(pi / 3.14)},
        {"pi-too-rough", "1/π is taken to be 0.318, which is off by 0.1 %.", "ProgRef.h brings M_PI and M_1_PI.",
         times(pi * 0.318)},
        {"pi-integer", "π is taken to be 3.", "What type has the number that you divide by?", times(pi / 3.0)},
    };
}

std::vector<Mistake> displayed() {
    using Patch = const MyPolygon&;
    const auto light = [](const Vec3f& v) { return Color(v); };
    const std::string unshot =
        "What is still to be shot is displayed, not all that was found: lamps go black when they have shot.";
    const std::string unshotHint = "Which member grows with every shot, and is never set back?";
    const std::string albedo = "The reflectance is displayed, not the light: every scene looks evenly lit.";
    const std::string albedoHint = "What should a white wall look like where no light falls on it?";
    return {
        {"unshot-displayed", unshot, unshotHint, displays([=](Patch p) { return light(p.unshot_rad) / pi; })},
        {"unshot-displayed", unshot + " The factor 1/π is missing, too.", unshotHint,
         displays([=](Patch p) { return light(p.unshot_rad); })},
        {"reflectance-displayed", albedo, albedoHint, displays([=](Patch p) { return light(p.diffuse); })},
        {"reflectance-displayed", albedo, albedoHint, displays([=](Patch p) { return light(p.diffuse) / pi; })},
        {"reflectance-as-factor",
         "The radiosity is multiplied by the reflectance once more. rad is light that has left the patch: it is "
         "reflected already.",
         "In which stage is light reflected?", displays([=](Patch p) { return light(p.diffuse) * light(p.rad) / pi; })},
        {"emission-displayed", "Only what patches emit by themselves is displayed: all but the lamps are black.",
         "Which member holds emitted and reflected light together?",
         displays([=](Patch p) { return light(p.emissive) / pi; })},
        {"emission-displayed",
         "Only what patches emit by themselves is displayed, without 1/π: all but the lamps are black.",
         "Which member holds emitted and reflected light together?",
         displays([=](Patch p) { return light(p.emissive); })},
        {"emission-added", "The emission is added to rad. It is in there from the start.",
         "What is rad of a lamp before the first shot?",
         displays([=](Patch p) { return (light(p.rad) + light(p.emissive)) / pi; })},
        {"unshot-added", "unshot_rad is added to rad. It is a part of it already.",
         "When light arrives at a patch, which members grow?",
         displays([=](Patch p) { return (light(p.rad) + light(p.unshot_rad)) / pi; })},
        {"grey", "The three channels are averaged, so all colours are lost.", "How many channels has color?",
         displays([=](Patch p) { return Color(glm::dot(light(p.rad), Color(1.0)) / (3.0 * pi)); })},
    };
}

std::vector<Mistake> displayCurves() {
    const std::string hint = "The viewer does what a screen needs. What does the task ask for?";
    const std::string exposure =
        "An exposure curve, 1 - exp(-x), is baked in. color is radiance: how it gets onto a screen is the viewer's "
        "part.";
    return {
        {"gamma-baked-in",
         "A gamma curve is baked in. color is radiance, in W/(m² sr): the curve of the screen is the viewer's part, "
         "and a mean of curved values is not the mean.",
         hint, maps([](double x) { return std::pow(x, 1.0 / 2.2); })},
        {"gamma-baked-in",
         "A square root is baked in as a gamma curve. color is radiance: the curve of the screen is the viewer's part.",
         hint, maps([](double x) { return std::sqrt(x); })},
        {"exposure-baked-in", exposure, hint, maps([](double x) { return 1.0 - std::exp(-x); })},
        // In floats, 1 - exp(-x) of a small x is another number.
        {"exposure-baked-in", exposure, hint,
         maps([](double x) { return double(1.0f - std::exp(-static_cast<float>(x))); })},
        {"exposure-baked-in",
         "A tone curve, x/(1 + x), is baked in. color is radiance: how it gets onto a screen is the viewer's part.",
         hint, maps([](double x) { return x / (1.0 + x); })},
        {"clamped",
         "Colours are cut off at 1. Radiance has no upper end; what is too bright for a screen, the viewer decides.",
         hint, maps([](double x) { return std::min(x, 1.0); })},
        {"scaled-to-one",
         "All colours are divided by the brightest one. Then a dim room looks as bright as a lit one, and the picture "
         "changes its scale with every shot.",
         hint,
         [](const Situation& at) {
             float most = 0.0f;
             for (const MyPolygon& p : at.before.patches) most = std::max({most, p.rad.x, p.rad.y, p.rad.z});
             return displays([=](const MyPolygon& p) { return Color(p.rad) / double(most); })(at);
         }},
    };
}

// What becomes of the patches, where the vertices are right as far as they can be.
std::vector<Mistake> patchMistakes() {
    const std::string missing =
        "Only the vertices get a color, the patches keep an old one. Flat shading draws with patch->color.";
    const std::string missingHint = "Which of your lines sets patch->color?";
    const auto keepPatches = [](State& state, const State& before) {
        for (std::size_t i = 0; i < state.patches.size(); ++i) state.patches[i].color = before.patches[i].color;
    };
    const auto oldColor = [](const MyPolygon& patch) { return Color(patch.color); };
    return {
        {"patch-color-missing", missing, missingHint, with([&](Reconstruction& way) { way.afterwards = keepPatches; })},
        {"patch-color-missing", missing + " And the mean at the vertices is made of these old colours.", missingHint,
         displays(oldColor)},
        {"vertices-before-patches",
         "The vertices are averaged before the patches have got their new color: they show the picture of the call "
         "before.",
         "In which order must the two halves of the task be done?",
         [](const Situation& at) {
             Outcome outcome = displays([](const MyPolygon& patch) { return Color(patch.color); })(at);
             for (MyPolygon& patch : outcome.state.patches) patch.color = Vec3f(Color(patch.rad) / pi);
             return outcome;
         }},
        {"rad-overwritten",
         "rad itself is divided by π on the way. The next shot builds on rad: this function only reads it.",
         "What does rad hold after your function, and after a second call?", with([](Reconstruction& way) {
             way.add = [](Sum& sum, const MyPolygon& patch) {
                 sum.color += Color(patch.color);
                 sum.rad += Color(patch.color);
                 ++sum.count;
             };
             way.afterwards = [](State& state, const State&) {
                 for (MyPolygon& patch : state.patches) patch.rad = patch.color;
             };
         })},
        {"flat-blurred",
         "The patches get the mean of their vertices' colours. Flat shading shows each patch as it is; only smooth "
         "shading averages.",
         "Which number does patch->color depend on, and on which not?", with([](Reconstruction& way) {
             way.afterwards = [](State& state, const State&) {
                 for (MyPolygon& patch : state.patches) {
                     Color sum(0.0);
                     for (int i = 0; i < patch.vertices; ++i)
                         sum += Color(state.corners[static_cast<std::size_t>(patch.vertex[i])].color);
                     patch.color = Vec3f(sum / double(patch.vertices));
                 }
             };
         })},
        {"nothing-done", "Nothing changes: neither a patch nor a vertex gets a color.",
         "Does your loop change the patches of `polygons`, or copies of them?",
         [](const Situation& at) {
             Outcome outcome;
             outcome.state = at.before;
             return outcome;
         }},
    };
}

// Another sum at the vertices.
Computation adds(const std::function<void(Sum&, const MyPolygon&)>& add) {
    return with([&](Reconstruction& way) { way.add = add; });
}

// Another end, once the sums are there.
Computation finishes(const std::function<MyVertex(const MyVertex& before, const Sum&)>& finish) {
    return with([&](Reconstruction& way) { way.finish = finish; });
}

// What is not set to zero before the sums.
std::vector<Mistake> resets() {
    std::vector<Mistake> all;
    for (int kept = 1; kept < 8; ++kept) {
        const bool color = kept & 1, rad = kept & 2, count = kept & 4;
        std::string names;
        for (const auto& [isKept, name] : {std::pair(color, "color"), {rad, "rad"}, {count, "colorcount"}})
            if (isKept) names += (names.empty() ? "" : " and ") + std::string(name);
        all.push_back({kept == 1   ? "color-not-reset"
                       : kept == 2 ? "rad-not-reset"
                       : kept == 4 ? "count-not-reset"
                                   : "no-reset",
                       "The vertices keep " + names +
                           " of the call before, and the sums start from there. The function is called after every "
                           "shot: what was there before is counted in again each time.",
                       "What do the members of a vertex hold when your function is called for the second time?",
                       with([=](Reconstruction& way) {
                           way.start = [=](const MyVertex& vertex) {
                               Sum sum;
                               if (color) sum.color = Color(vertex.color);
                               if (rad) sum.rad = Color(vertex.rad);
                               if (count) sum.count = vertex.colorcount;
                               return sum;
                           };
                       })});
    }
    return all;
}

std::vector<Mistake> divisions() {
    const std::string four = "Not every vertex belongs to four patches: at an edge there are two, in a corner one.";
    const std::string hint = "How many patches share a vertex in the middle of a wall, at its edge, in its corner?";
    const auto over = [](double divisor) {
        return [divisor](const Sum& sum) { return sum.count == 0 ? 1.0 : divisor > 0.0 ? divisor : sum.count; };
    };
    const auto ends = [=](double ofColor, double ofRad) {
        return finishes([=](const MyVertex& before, const Sum& sum) {
            return vertexOf(before, sum.color / over(ofColor)(sum), sum.rad / over(ofRad)(sum), sum.count);
        });
    };
    return {
        {"division-missing",
         "At the vertices there are sums, not means: the more patches share a vertex, the brighter it gets.", hint,
         ends(1, 1)},
        {"division-missing", "color of the vertices is a sum, not a mean; only rad is divided.", hint, ends(1, 0)},
        {"rad-not-divided", "rad of the vertices is a sum, not a mean; only color is divided.", hint, ends(0, 1)},
        {"divided-by-four", "The sums at the vertices are divided by 4. " + four, hint, ends(4, 4)},
        {"divided-by-four", "color of the vertices is divided by 4. " + four, hint, ends(4, 0)},
        {"divided-by-corners",
         "The sums are divided by the number of corners of a patch. What counts is how many patches share the vertex.",
         hint, with([](Reconstruction& way) {
             way.add = [](Sum& sum, const MyPolygon& patch) {
                 sum.color += Color(patch.color) / double(patch.vertices);
                 sum.rad += Color(patch.rad) / double(patch.vertices);
                 ++sum.count;
             };
             way.finish = [](const MyVertex& before, const Sum& sum) {
                 return vertexOf(before, sum.color, sum.rad, sum.count);
             };
         })},
        {"divided-in-loop",
         "The sum is divided each time that a patch is added: the first patches are divided again and again.",
         "When do you know how many patches share a vertex?", with([](Reconstruction& way) {
             way.add = [](Sum& sum, const MyPolygon& patch) {
                 ++sum.count;
                 sum.color = (sum.color + Color(patch.color)) / double(sum.count);
                 sum.rad = (sum.rad + Color(patch.rad)) / double(sum.count);
             };
             way.finish = [](const MyVertex& before, const Sum& sum) {
                 return vertexOf(before, sum.color, sum.rad, sum.count);
             };
         })},
    };
}

// Ends with what the sums have come to.
Computation keeps(const std::function<Color(const Color& so, const Color& next, int count)>& merge) {
    return with([&](Reconstruction& way) {
        way.add = [merge](Sum& sum, const MyPolygon& patch) {
            sum.color = merge(sum.color, Color(patch.color), sum.count);
            sum.rad = merge(sum.rad, Color(patch.rad), sum.count);
            ++sum.count;
        };
        way.finish = [](const MyVertex& before, const Sum& sum) {
            return vertexOf(before, sum.color, sum.rad, sum.count);
        };
    });
}

std::vector<Mistake> merges() {
    const std::string last =
        "The last patch that has a vertex as a corner wins: its color replaces (=) those before, where it should be "
        "added (+=).";
    const std::string hint = "Two patches share a vertex, one is white, one black. What do you get, in either order?";
    const std::string pairwise =
        "Each patch is averaged with what is at the vertex so far. So the last one counts for a half, the one "
        "before for a quarter: that is no mean of all.";
    return {
        {"last-patch-wins", last, hint, keeps([](const Color&, const Color& next, int) { return next; })},
        {"last-patch-wins", last + " That is then divided, too.", hint, adds([](Sum& sum, const MyPolygon& patch) {
             sum.color = Color(patch.color);
             sum.rad = Color(patch.rad);
             ++sum.count;
         })},
        {"first-patch-wins", "A vertex takes the color of the first patch that has it as a corner, and of no other.",
         hint, keeps([](const Color& so, const Color& next, int count) { return count ? so : next; })},
        {"maximum-for-mean", "A vertex takes the brightest color of its patches, channel by channel, not their mean.",
         hint, keeps([](const Color& so, const Color& next, int) { return glm::max(so, next); })},
        {"pairwise-mean", pairwise, hint,
         keeps([](const Color& so, const Color& next, int) { return 0.5 * (so + next); })},
        {"pairwise-mean", pairwise, hint,
         keeps([](const Color& so, const Color& next, int count) { return count ? 0.5 * (so + next) : next; })},
        {"area-weighted",
         "The mean is weighted by the patches' areas. The task asks for the plain mean: all patches at a vertex count "
         "alike.",
         "Which mean does the task ask for?", with([](Reconstruction& way) {
             way.add = [](Sum& sum, const MyPolygon& patch) {
                 sum.color += double(patch.area) * Color(patch.color);
                 sum.rad += double(patch.area) * Color(patch.rad);
                 sum.weight += double(patch.area);
                 ++sum.count;
             };
             way.finish = [](const MyVertex& before, const Sum& sum) {
                 const double weight = sum.count ? sum.weight : 1.0;
                 return vertexOf(before, sum.color / weight, sum.rad / weight, sum.count);
             };
         })},
    };
}

Computation corners(const std::function<int(const MyPolygon&)>& count) {
    return with([&](Reconstruction& way) { way.corners = count; });
}

std::vector<Mistake> cornerMistakes() {
    const std::string hint = "How many corners has the patch at hand, and which member says so?";
    return {
        {"fourth-corner-lost", "Only three corners of each patch are looked at: quads have four.", hint,
         corners([](const MyPolygon&) { return 3; })},
        {"last-corner-lost", "The last corner of each patch is left out.", hint,
         corners([](const MyPolygon& patch) { return patch.vertices - 1; })},
        {"triangles-as-quads",
         "Every patch is taken to have four corners. vertex[3] of a triangle means nothing, and as an index it leads "
         "to some other vertex, or out of the vector.",
         hint, corners([](const MyPolygon&) { return 4; })},
    };
}

std::vector<Mistake> vertexColors() {
    const auto colors = [](const std::function<Color(const MyPolygon&)>& color) {
        return adds([color](Sum& sum, const MyPolygon& patch) {
            sum.color += color(patch);
            sum.rad += Color(patch.rad);
            ++sum.count;
        });
    };
    return {
        {"vertex-without-inverse-pi",
         "The patches get their radiance, but at the vertices the radiosity is averaged: smooth shading is π times "
         "brighter than flat shading.",
         "What is displayed is radiance, at a vertex as on a patch.",
         colors([](const MyPolygon& patch) { return Color(patch.rad); })},
        {"inverse-pi-twice",
         "At the vertices the factor 1/π comes in a second time: color of a patch is radiance already.",
         "Of what is color at a vertex the mean?",
         colors([](const MyPolygon& patch) { return Color(patch.color) / pi; })},
        {"vertex-of-unshot", "At the vertices, the unshot radiosity is averaged.",
         "Of what is color at a vertex the mean?",
         colors([](const MyPolygon& patch) { return Color(patch.unshot_rad) / pi; })},
    };
}

std::vector<Mistake> orphans() {
    const std::string hint = "What does your function do at a vertex that no patch uses?";
    return {
        {"orphans-not-a-number",
         "At a vertex that no patch uses, 0 is divided by 0: that gives a number that is none (NaN), and a hole in the "
         "picture.",
         hint, finishes([](const MyVertex& before, const Sum& sum) {
             const double count = sum.count;
             return vertexOf(before, sum.color / count, sum.rad / count, sum.count);
         })},
        {"orphans-left-stale",
         "A vertex that no patch uses keeps its old color and count: it is passed over before it is set to zero.", hint,
         finishes([](const MyVertex& before, const Sum& sum) { return sum.count ? mean(before, sum) : before; })},
        {"orphans-left-stale",
         "A vertex that no patch uses keeps its old color: it is passed over before it is set to 0.", hint,
         finishes([](const MyVertex& before, const Sum& sum) {
             return sum.count ? mean(before, sum) : vertexOf(before, Color(before.color), Color(before.rad), 0);
         })},
    };
}

// Right but for one member at the vertices.
std::vector<Mistake> vertexMembers() {
    const auto changes = [](const std::function<void(MyVertex & vertex, const MyVertex& before)>& change) {
        return finishes([change](const MyVertex& before, const Sum& sum) {
            MyVertex vertex = mean(before, sum);
            change(vertex, before);
            return vertex;
        });
    };
    const std::string count = "colorcount is not set: it is to say how many patches share the vertex.";
    const std::string rad = "rad of the vertices is not set: it is to be the mean radiosity of their patches.";
    const std::string hint = "Which three members of a vertex does the task name?";
    return {
        {"rad-missing", rad, hint, changes([](MyVertex& vertex, const MyVertex& before) { vertex.rad = before.rad; })},
        {"rad-missing", rad + " It is set to 0, and nothing is added.", hint,
         changes([](MyVertex& vertex, const MyVertex&) { vertex.rad = Vec3f(0.0f); })},
        {"radiance-in-rad", "rad of the vertices is the mean radiance, not the mean radiosity: 1/π has come in.",
         "Which member of the patches is it the mean of?",
         changes([](MyVertex& vertex, const MyVertex&) { vertex.rad = vertex.color; })},
        {"count-missing", count, hint,
         changes([](MyVertex& vertex, const MyVertex& before) { vertex.colorcount = before.colorcount; })},
        {"count-missing", count + " It is set to 0, and stays there.", hint,
         changes([](MyVertex& vertex, const MyVertex&) { vertex.colorcount = 0; })},
        {"count-not-incremented",
         "colorcount is never counted up, so that nothing is divided: at the vertices there are sums.", hint,
         finishes([](const MyVertex& before, const Sum& sum) { return vertexOf(before, sum.color, sum.rad, 0); })},
        {"count-not-incremented",
         "colorcount is never counted up, so that all is divided by 0: the vertices are infinitely bright.", hint,
         finishes([](const MyVertex& before, const Sum& sum) {
             return vertexOf(before, sum.color / 0.0, sum.rad / 0.0, 0);
         })},
    };
}

MyVertex untouched(const MyVertex& before, const Sum&) { return before; }

std::vector<Mistake> unfinished() {
    const std::string hint = "The second half of the task: what is color of a vertex that three patches share?";
    return {
        {"vertices-untouched",
         "The patches are right: flat shading works. The vertices are not averaged yet, which smooth shading needs.",
         hint, finishes(untouched)},
        {"vertices-black",
         "The patches are right: flat shading works. The vertices are set to zero, and nothing is added.", hint,
         finishes([](const MyVertex& before, const Sum&) { return vertexOf(before, Color(0.0), Color(0.0), 0); })},
    };
}

// The same mistake in a file that leaves something of the vertices as it was.
Mistake alsoLeaving(const Mistake& mistake, const std::string& text,
                    const std::function<void(MyVertex& vertex, const MyVertex& before)>& restore) {
    return {mistake.id, mistake.text + " " + text, mistake.hint, [=](const Situation& at) {
                Outcome outcome = mistake.computation(at);
                for (std::size_t i = 0; i < outcome.state.corners.size(); ++i)
                    restore(outcome.state.corners[i], at.before.corners[i]);
                return outcome;
            }};
}

Mistake withoutRad(const Mistake& mistake) {
    return alsoLeaving(mistake, "Beside that, rad of the vertices is never set.",
                       [](MyVertex& vertex, const MyVertex& before) { vertex.rad = before.rad; });
}

Mistake withoutVertices(const Mistake& mistake) {
    return alsoLeaving(mistake, "The vertices are not averaged yet.",
                       [](MyVertex& vertex, const MyVertex& before) { vertex = before; });
}

}  // namespace

Computation reconstructs() { return reconstructsSo({}); }

std::vector<Mistake> colorMistakes() {
    std::vector<Mistake> all = unfinished();
    const auto add = [&](const std::vector<Mistake>& some) { all.insert(all.end(), some.begin(), some.end()); };
    for (const std::vector<Mistake>& some : {constants(), displayed(), displayCurves()}) {
        add(some);
        for (const Mistake& mistake : some) {
            all.push_back(withoutVertices(mistake));
            all.push_back(withoutRad(mistake));
        }
    }
    for (const std::vector<Mistake>& some : {merges(), cornerMistakes(), vertexColors(), orphans()}) {
        add(some);
        for (const Mistake& mistake : some) all.push_back(withoutRad(mistake));
    }
    for (const std::vector<Mistake>& some : {patchMistakes(), resets(), divisions(), vertexMembers()}) add(some);
    return all;
}

}  // namespace radlab::grader

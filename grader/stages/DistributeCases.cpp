#include "grader/stages/DistributeCases.h"

#include <cmath>

#include "grader/stages/Meshes.h"

namespace radlab::grader {

namespace {

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

}  // namespace

std::vector<Check> distributeChecks(std::uint64_t seed) {
    Random random(seed);
    Check twice{"dist.twice", {}};
    for (const int count : {3, 20})
        twice.cases.push_back(
            severalShots(random, "three shots, one after the other, " + std::to_string(count) + " patches", count));
    return {radiosities(random), channels(random),  areas(random),  unshot(random), twice,
            range(random),       leftAlone(random), answers(random)};
}

}  // namespace radlab::grader

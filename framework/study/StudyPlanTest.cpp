#include "study/StudyPlan.h"

#include <set>

#include <doctest/doctest.h>

using namespace radlab::study;
using doctest::Approx;

TEST_CASE("seconds are expected to go on growing as they did, or by the exponent given") {
    CHECK(expectedSeconds({}, 100, 1) == 0.0);
    CHECK(expectedSeconds({{10, 2}}, 40, 1) == Approx(8));
    CHECK(expectedSeconds({{10, 2}}, 40, 2) == Approx(32));
    CHECK(expectedSeconds({{1, 9}, {10, 2}, {20, 4}}, 40, 2) == Approx(8));
    CHECK(expectedSeconds({{10, 4}, {20, 2}}, 40, 1) == Approx(2));
}

TEST_CASE("a plan goes from coarse meshes to fine ones and from cheap levels to dear ones") {
    for (const StudyPlan& plan : {fullPlan(), quickPlan(), smallPlan(60)}) {
        CAPTURE(plan.name);
        const std::vector<StudyMethod> methods = studyMethods(true);
        const std::vector<Step> steps = stepsOf(plan, methods);
        REQUIRE(!steps.empty());
        for (std::size_t i = 0; i + 1 < steps.size(); ++i) {
            REQUIRE(steps[i].patches <= steps[i + 1].patches);
            if (steps[i].patches == steps[i + 1].patches && steps[i].method == steps[i + 1].method)
                REQUIRE(steps[i].level < steps[i + 1].level);
        }
    }
}

TEST_CASE("every setting has a name of its own") {
    for (const bool occlusion : {false, true}) {
        std::set<std::string> names;
        for (const StudyMethod& method : studyMethods(occlusion))
            for (const double level : method.full)
                REQUIRE(names.insert(method.name + ", " + settingName(method, level)).second);
        CHECK(names.count("hemisphere, 65,536 rays") == 1);
        CHECK(names.count("hemicube, size 2,048") == 1);
        CHECK(names.count("hierarchical, threshold 1e-6") == 1);
        CHECK(names.count("shooting, all shots") == 1);
        CHECK(names.count("exact, ") == (occlusion ? 0 : 1));
    }
}

TEST_CASE("numbers of patches are compared at one level of each method, which the main mesh has, too") {
    const StudyPlan plan = quickPlan();
    const std::vector<StudyMethod> methods = studyMethods(false);
    std::set<std::string> main, others;
    for (const Step& step : stepsOf(plan, methods)) {
        if (step.patches != plan.patches) CHECK(step.usual);
        if (step.usual) (step.patches == plan.patches ? main : others).insert(step.method->name);
    }
    CHECK(main == others);
    CHECK(main.count("hierarchical") == 1);
    CHECK(main.count("shooting + ambient") == 0);
}

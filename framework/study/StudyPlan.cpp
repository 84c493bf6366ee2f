#include "study/StudyPlan.h"

#include <algorithm>
#include <cmath>

#include "study/PowerFit.h"

namespace radlab::study {

namespace {

constexpr double steepest = 3.0;

const std::vector<double>& levelsOf(const StudyPlan& plan, const StudyMethod& method) {
    return plan.quick ? method.quick : method.full;
}

// The largest level that is not above the usual one.
double usualOf(const StudyPlan& plan, const StudyMethod& method) {
    double usual = 0.0;
    for (const double level : levelsOf(plan, method))
        if (level <= method.usual) usual = level;
    return usual;
}

}  // namespace

StudyPlan fullPlan() {
    StudyPlan plan;
    plan.name = "full";
    plan.others = {250, 4000, 16000, 64000};
    return plan;
}

StudyPlan quickPlan() {
    StudyPlan plan = smallPlan(300);
    plan.name = "quick";
    plan.others = {75, 1200};
    return plan;
}

StudyPlan smallPlan(std::size_t patches) {
    StudyPlan plan;
    plan.name = std::to_string(patches) + " patches";
    plan.quick = true;
    plan.patches = patches;
    plan.referenceRays = 512;
    plan.finePatches = 6000;
    plan.fineThreshold = 3e-5;
    plan.repeats = 1;
    plan.limit = 1.5;
    return plan;
}

std::vector<Step> stepsOf(const StudyPlan& plan, const std::vector<StudyMethod>& methods) {
    std::vector<std::size_t> sizes = plan.others;
    sizes.push_back(plan.patches);
    std::sort(sizes.begin(), sizes.end());
    std::vector<Step> steps;
    for (const std::size_t patches : sizes)
        for (const StudyMethod& method : methods) {
            const double usual = usualOf(plan, method);
            for (const double level : levelsOf(plan, method))
                if (patches == plan.patches || level == usual)
                    steps.push_back({patches, &method, level, level == usual});
        }
    return steps;
}

double expectedSeconds(const std::vector<glm::dvec2>& measured, double size, double exponent) {
    if (measured.empty()) return 0.0;
    const std::size_t last = measured.size() - 1;
    if (last > 0)
        if (const auto fit = fitPower({measured[last - 1], measured[last]}))
            exponent = std::clamp(fit->exponent, 0.0, steepest);
    return measured[last].y * std::pow(size / measured[last].x, exponent);
}

}  // namespace radlab::study

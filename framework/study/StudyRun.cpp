#include "study/StudyRun.h"

#include <algorithm>
#include <memory>
#include <optional>

#include "base/Error.h"
#include "base/ImageFile.h"
#include "base/Interrupts.h"
#include "base/ProgressBar.h"
#include "base/Stopwatch.h"
#include "engine/RelativeError.h"
#include "scene/Effects.h"
#include "study/PeakMemory.h"
#include "study/Reference.h"
#include "study/StudyPictures.h"

namespace radlab::study {

namespace {

// A mesh and what it is measured against: both are made when first asked for.
class Subject {
public:
    Subject(const Scene& scene, const StudyPlan& studyPlan, std::size_t patches)
        : mesh(scene, engine::patchSizeFor(scene, static_cast<double>(patches))), plan(studyPlan) {}

    const SolverReference& reference() {
        if (!solver) solver = solverReference(mesh, plan.referenceRays);
        return *solver;
    }
    const WholeReference& light() {
        if (!whole) whole.emplace(mesh, plan.finePatches, plan.fineThreshold);
        return *whole;
    }

    StudyMesh mesh;

private:
    const StudyPlan& plan;
    std::optional<SolverReference> solver;
    std::optional<WholeReference> whole;
};

class SceneRun {
public:
    SceneRun(const StudyScene& studied, const StudyPlan& studyPlan, bool openGl, std::filesystem::path out,
             StudyResults& known)
        : scene(studied),
          plan(studyPlan),
          hasOpenGl(openGl),
          folder(std::move(out)),
          results(known),
          methods(studyMethods(findEffects(studied.scene).has(Effect::occlusion))),
          steps(stepsOf(plan, methods)) {}

    SceneReport run() {
        ProgressBar bar(scene.name, static_cast<double>(steps.size()), "settings");
        for (std::size_t i = 0; i < steps.size() && !Interrupts::caught(); ++i) {
            if (isKept(steps[i])) {
                ++report.kept;
                continue;
            }
            const Measurement row = rowFor(steps[i]);
            bar.show(static_cast<double>(i), std::to_string(row.wanted) + " patches: " + nameOf(row));
            if (isAffordable(steps[i], row) && !doneWhole([&] { tryToMeasure(steps[i], row); })) break;
        }
        return std::move(report);
    }

private:
    // What is known of a step before it is measured.
    Measurement rowFor(const Step& step) const {
        Measurement row;
        row.version = RADLAB_VERSION;
        row.plan = plan.name;
        row.scene = scene.name;
        row.contents = scene.contents;
        row.wanted = step.patches;
        row.method = step.method->name;
        row.setting = settingName(*step.method, step.level);
        row.level = sizeOf(step);
        return row;
    }

    // A level as a number to compare: all shots are about as many as it takes.
    static double sizeOf(const Step& step) {
        constexpr double shotsOfAPatch = 6.0;  // until a thousandth is unshot
        return step.level == everything ? shotsOfAPatch * static_cast<double>(step.patches) : step.level;
    }

    bool hasMap(const Step& step) const { return step.usual && step.patches == plan.patches; }

    bool isKept(const Step& step) const {
        const Measurement* row = results.find(rowFor(step));
        if (!row) return false;
        const bool oftenEnough =
            row->repeats >= plan.repeats || row->seconds * static_cast<double>(row->repeats) > plan.limit / 2.0;
        return oftenEnough && (!hasMap(step) || (std::filesystem::exists(folder / mapFile(scene.name, row->method)) &&
                                                 std::filesystem::exists(folder / pictureFile(scene.name))));
    }

    // Whether a step will keep the limit, as the smaller ones of its kind tell; if not, a note says so.
    bool isAffordable(const Step& step, const Measurement& row) {
        if (step.method->usesOpenGl && !hasOpenGl) {
            leaveOut(row, "no OpenGL");
            return false;
        }
        const double expected =
            std::max(expectedOverLevels(row, step.method->growth), expectedOverPatches(row, step.method->growth));
        if (expected <= plan.limit) return true;
        leaveOut(row, "about " + durationText(expected) + " are expected, the limit is " + durationText(plan.limit));
        return false;
    }

    double expectedOverLevels(const Measurement& row, const Growth& growth) const {
        return expectedFrom(
            row.level, growth.overLevels,
            [&](const Measurement& other, double& size) {
                size = other.level;
                return other.wanted == row.wanted && other.level < row.level;
            },
            row);
    }

    double expectedOverPatches(const Measurement& row, const Growth& growth) const {
        return expectedFrom(
            static_cast<double>(row.wanted), growth.overPatches,
            [&](const Measurement& other, double& size) {
                size = static_cast<double>(other.wanted);
                return other.wanted < row.wanted && other.setting == row.setting;
            },
            row);
    }

    template <class Takes>
    double expectedFrom(double size, double exponent, const Takes& takes, const Measurement& like) const {
        std::vector<glm::dvec2> points;
        for (const Measurement& other : results.rows()) {
            double otherSize = 0.0;
            const bool sameMethod = other.plan == like.plan && other.scene == like.scene &&
                                    other.contents == like.contents && other.method == like.method;
            if (sameMethod && takes(other, otherSize)) points.emplace_back(otherSize, other.seconds);
        }
        std::sort(points.begin(), points.end(), [](const auto& a, const auto& b) { return a.x < b.x; });
        return expectedSeconds(points, size, exponent);
    }

    void leaveOut(const Measurement& row, const std::string& why) {
        report.notes.push_back(std::to_string(row.wanted) + " patches, " + nameOf(row) + ": left out, " + why);
    }

    void tryToMeasure(const Step& step, Measurement row) {
        Outcome outcome;
        try {
            StudyMesh& mesh = subjectOf(step.patches).mesh;
            row.patches = mesh.geometry.patches.size();
            outcome = timed(step, mesh, row);
        } catch (const Error& refused) {
            return leaveOut(row, refused.what());
        }
        judge(step, outcome, row);
        results.add(row);
        ++report.measured;
    }

    void judge(const Step& step, const Outcome& outcome, Measurement& row) {
        Subject& subject = subjectOf(step.patches);
        row.shots = outcome.shots;
        if (step.patches == plan.patches) {
            const SolverReference& reference = subject.reference();
            row.solverError =
                engine::relativeError(areasOf(subject.mesh.geometry), outcome.radiosity, reference.radiosity);
            row.solverReference = reference.error;
        }
        if (plan.measuresWhole(row.patches)) {
            const auto& solveWhole = step.method->solveWhole;
            row.wholeError = subject.light().errorOf(solveWhole ? solveWhole(subject.mesh, step.level).radiosity
                                                                : outcome.radiosity);
            row.wholeReference = subject.light().error();
        }
        Interrupts::check();  // or what was measured may have been cut short
        if (hasMap(step)) draw(subject, row, outcome);
    }

    Outcome timed(const Step& step, StudyMesh& mesh, Measurement& row) const {
        Outcome outcome;
        std::vector<double> seconds;
        double all = 0.0;
        while (seconds.size() < plan.repeats && (seconds.empty() || all <= plan.limit)) {
            const PeakMemory memory;
            const Stopwatch watch;
            outcome = step.method->solve(mesh, step.level);
            seconds.push_back(watch.seconds());
            all += seconds.back();
            if (!row.bytes) row.bytes = memory.growth();
        }
        std::sort(seconds.begin(), seconds.end());
        row.repeats = seconds.size();
        row.seconds = (seconds[(seconds.size() - 1) / 2] + seconds[seconds.size() / 2]) / 2.0;
        row.fastest = seconds.front();
        row.slowest = seconds.back();
        return outcome;
    }

    void draw(Subject& subject, const Measurement& row, const Outcome& outcome) const {
        const std::vector<engine::Point>& truth = subject.reference().radiosity;
        const std::filesystem::path picture = folder / pictureFile(scene.name);
        writeImage(picture, solvedPicture(subject.mesh, truth));
        writeImage(folder / mapFile(scene.name, row.method), errorMap(subject.mesh, outcome.radiosity, truth));
    }

    // One mesh at a time is held: steps go from mesh to mesh.
    Subject& subjectOf(std::size_t patches) {
        if (!current || currentPatches != patches) current = std::make_unique<Subject>(scene.scene, plan, patches);
        currentPatches = patches;
        return *current;
    }

    const StudyScene& scene;
    const StudyPlan& plan;
    const bool hasOpenGl;
    const std::filesystem::path folder;
    StudyResults& results;
    const std::vector<StudyMethod> methods;
    const std::vector<Step> steps;
    SceneReport report;
    std::unique_ptr<Subject> current;
    std::size_t currentPatches = 0;
};

}  // namespace

SceneReport studyScene(const StudyScene& scene, const StudyPlan& plan, bool openGl, const std::filesystem::path& folder,
                       StudyResults& results) {
    return SceneRun(scene, plan, openGl, folder, results).run();
}

}  // namespace radlab::study

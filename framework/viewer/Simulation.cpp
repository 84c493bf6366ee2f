#include "viewer/Simulation.h"

#include <algorithm>
#include <cmath>

#include "base/Error.h"
#include "display/HemicubePicture.h"
#include "solver/MethodChoice.h"
#include "viewer/WatchedHemicube.h"

namespace radlab {

namespace {

constexpr double mostDrawn = 400000.0;  // patches
constexpr double leastShare = 1e-3;

double areaOf(const Scene& scene) {
    double sum = 0.0;
    for (const Face& face : scene.faces) {
        glm::dvec3 twice(0.0);
        const glm::dvec3 first(scene.vertices[static_cast<std::size_t>(face.corners[0])]);
        for (std::size_t k = 2; k < face.corners.size(); ++k)
            twice += glm::cross(glm::dvec3(scene.vertices[static_cast<std::size_t>(face.corners[k - 1])]) - first,
                                glm::dvec3(scene.vertices[static_cast<std::size_t>(face.corners[k])]) - first);
        sum += 0.5 * glm::length(twice);
    }
    return sum;
}

void requireDrawable(const Scene& scene, const ViewState& state) {
    const double size = static_cast<double>(std::min(state.patchSize, state.lightSize));
    const double expected = areaOf(scene) / (size * size);
    if (expected > mostDrawn)
        throw Error("patch size " + std::to_string(size) + " means about " + std::to_string(std::llround(expected)) +
                    " patches, expected at most 400000; take a larger one");
}

std::string nextStep(const std::string& function) {
    const int stage = stageOf(function.c_str());
    if (stage == 0) return "";
    return "Do stage " + std::to_string(stage) + ": " + function +
           " in exercises/ProgRef.cpp. Saving the file is enough; the viewer rebuilds it.";
}

// The form factors of another row, while it lives.
class ShownRow {
public:
    ShownRow(PatchMesh& patchMesh, std::vector<float>& shown) : mesh(patchMesh), row(shown) { exchange(); }
    ~ShownRow() { exchange(); }
    ShownRow(const ShownRow&) = delete;
    ShownRow& operator=(const ShownRow&) = delete;

private:
    void exchange() {
        for (std::size_t i = 0; i < row.size(); ++i) std::swap(mesh.patches[i].formF, row[i]);
    }

    PatchMesh& mesh;
    std::vector<float>& row;
};

// The unshot radiosities and form factors of all patches, put back when it goes.
class KeptPatches {
public:
    explicit KeptPatches(PatchMesh& patchMesh) : mesh(patchMesh), before(patchMesh.patches) {}
    ~KeptPatches() { mesh.patches = before; }
    KeptPatches(const KeptPatches&) = delete;
    KeptPatches& operator=(const KeptPatches&) = delete;

private:
    PatchMesh& mesh;
    const std::vector<MyPolygon> before;
};

}  // namespace

float patchSizeFor(const Scene& scene, double count) {
    const double size = std::sqrt(areaOf(scene) / count);
    return size > 0.0 ? static_cast<float>(size) : 1.0f;
}

Simulation::Simulation(Scene scene, RunningNow& place) : shown(std::move(scene)), running(place) {}

bool Simulation::finished() const { return now.unshot <= 0.0 || now.unshotShare <= leastShare; }

void Simulation::setInterlude(double seconds, std::function<void()> action) {
    interludeAfter = seconds;
    meanwhile = std::move(action);
}

void Simulation::interlude() {
    if (!shooting || !meanwhile || sinceInterlude.seconds() < interludeAfter) return;
    const RunningPause pause(running);
    const ShownRow shownRow(*patches, row);
    const Stopwatch watch;
    meanwhile();
    interludeSeconds += watch.seconds();
    sinceInterlude.restart();
}

void Simulation::setFunctions(const std::optional<CourseFunctions>& functions) {
    course.reset();
    if (functions) course = marked(*functions, running);
}

void Simulation::cut(const ViewState& state) {
    requireDrawable(shown, state);
    auto mesh = std::make_unique<PatchMesh>(shown.vertices, shown.faces, state.patchSize, state.lightSize);
    solver.reset();
    patches = std::move(mesh);
    found = findEffects(shown, patches.get());
    restart(state);
}

void Simulation::restart(const ViewState& state) {
    trouble.reset();
    records.clear();
    shooter.reset();
    coloured = false;
    chosen = formFactorMethod(state.method, found);
    if (!hemicube || hemicube->rendersize != 2 * state.hemicubeSize)
        hemicube = std::make_unique<WatchedHemicube>(state.hemicubeSize, running, [this] { interlude(); });
    interludeSeconds = 0.0;
    solver = std::make_unique<Progressive>(
        *patches, [this] { return setFormFactors(); }, course.value_or(CourseFunctions{}));
    now = solver->progress();
    if (course) coloured = attempt([this] { course->colorReconstruction(); });
    trouble.reset();  // the first shot says what is missing, in the order of the stages
}

MyPolygon* Simulation::setFormFactors() {
    return chosen == FormFactorMethod::analytic ? course->calcAnalyticalFF() : course->calcFF(hemicube.get());
}

void Simulation::giveUp(const std::string& text) {
    const std::string function = nameOf(static_cast<Running>(running.failed.load()));
    trouble = Problem{function, false, text + (function.empty() ? "" : "\n" + nextStep(function))};
}

bool Simulation::attempt(const std::function<void()>& action) {
    running.failed = 0;
    try {
        action();
        return true;
    } catch (const NotImplemented& stub) {
        trouble =
            Problem{stub.function(), true, stub.function() + " is not written yet.\n" + nextStep(stub.function())};
    } catch (const std::exception& fault) {
        giveUp(fault.what());
    } catch (...) {
        giveUp("something was thrown that is no exception");
    }
    return false;
}

bool Simulation::shootOnce() {
    bool shot = false;
    const double before = now.seconds;
    row.clear();
    for (const MyPolygon& patch : patches->patches) row.push_back(patch.formF);
    shooting = true;
    const bool well = attempt([&] {
        // Called by itself first, so that what goes wrong in it bears its name.
        MyPolygon* const brightest = course->maxenergyPatch();
        shot = solver->shoot();
        if (shot && brightest) shooter = static_cast<std::size_t>(brightest - patches->patches.data());
    });
    shooting = false;
    now = solver->progress();
    now.seconds -= interludeSeconds;
    if (shot) records.push_back({now.unshotShare, now.seconds - before});
    return well && shot;
}

int Simulation::shoot(int most, double seconds) {
    if (!course || finished()) return 0;
    trouble.reset();
    sinceInterlude.restart();
    const Stopwatch watch;
    int shots = 0;
    while (shots < most && !finished() && shootOnce()) {
        ++shots;
        if (watch.seconds() >= seconds) break;
    }
    const std::optional<Problem> first = trouble;
    coloured = attempt([this] { course->colorReconstruction(); });
    if (first) trouble = first;
    return shots;
}

void Simulation::setRow(std::size_t patch) {
    for (MyPolygon& other : patches->patches) {
        other.unshot_rad = Vec3f(0.0f);
        other.formF = 0.0f;
    }
    patches->patches[patch].unshot_rad = Vec3f(1.0f);
    if (const MyPolygon* found_ = setFormFactors(); found_ != &patches->patches[patch])
        throw Error(
            std::string(nameOf(chosen == FormFactorMethod::analytic ? Running::calcAnalyticalFF : Running::calcFF)) +
            ": with all unshot power on patch " + std::to_string(patch) + ", found another shooter");
}

std::optional<PatchView> Simulation::lookFrom(std::size_t patch) {
    if (!course) return std::nullopt;
    PatchView view;
    const KeptPatches kept(*patches);
    const bool well = attempt([&] {
        setRow(patch);
        for (const MyPolygon& other : patches->patches) {
            view.formFactors.push_back(other.formF);
            view.sum += static_cast<double>(other.formF);
        }
    });
    if (!well) return std::nullopt;
    const std::optional<Problem> before = trouble;
    const bool drawn = chosen == FormFactorMethod::hemicube || attempt([&] {
                           const MyPolygon& seen = patches->patches[patch];
                           const Vec3f up =
                               patches->corners[static_cast<std::size_t>(seen.vertex[0])].position - seen.center;
                           hemicube->renderScene(seen.center, up, seen.normal, course->renderPatchIDs);
                           hemicube->readIndexBuffer();
                       });
    trouble = before;
    if (!drawn) return view;
    view.ids = hemicubeIds(*hemicube);
    view.weights = hemicubeWeights(*hemicube);
    return view;
}

}  // namespace radlab

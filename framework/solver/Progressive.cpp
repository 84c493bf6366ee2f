#include "solver/Progressive.h"

#include <cmath>

#include "base/Stopwatch.h"

namespace radlab {

namespace {

double power(const Vec3f& radiosity, float area) {
    return (double(radiosity.r) + double(radiosity.g) + double(radiosity.b)) * double(area);
}

double unshotPower(const PatchMesh& mesh) {
    double sum = 0.0;
    for (const MyPolygon& patch : mesh.patches) sum += power(patch.unshot_rad, patch.area);
    return sum;
}

}  // namespace

Progressive::Progressive(PatchMesh& patchMesh, FormFactors function, CourseFunctions functions)
    : mesh(patchMesh), formFactors(std::move(function)), course(std::move(functions)) {
    mesh.publish();
    mesh.reset();
    state.emitted = state.unshot = unshotPower(mesh);
    state.unshotShare = state.emitted > 0.0 ? 1.0 : 0.0;
}

bool Progressive::shoot() {
    if (state.unshot <= 0.0) return false;
    const Stopwatch watch;
    MyPolygon* shooter = formFactors();
    if (!shooter || shooter->unshot_rad == Vec3f(0.0f)) return false;
    const Vec3f shot = shooter->unshot_rad;
    course.distributeEnergy(shooter);
    state.seconds += watch.seconds();
    ++state.shots;
    account(*shooter, shot);
    return true;
}

void Progressive::account(const MyPolygon& shooter, const Vec3f& shot) {
    double received = 0.0;
    for (const MyPolygon& patch : mesh.patches) {
        if (&patch == &shooter) continue;
        const Vec3f arriving = shot * patch.formF;
        received += power(arriving, shooter.area);
        state.absorbed += power((Vec3f(1.0f) - patch.diffuse) * arriving, shooter.area);
    }
    state.escaped += power(shot, shooter.area) - received;
    state.unshot = unshotPower(mesh);
    if (!std::isfinite(state.unshot))
        throw Error("radiosity is no longer finite after shot " + std::to_string(state.shots) +
                    ": look for a division by 0 in the form factors or in distributeEnergy");
    state.unshotShare = state.unshot / state.emitted;
}

const Progress& Progressive::run(const Limits& limits, const std::function<bool(const Progress&)>& report) {
    while (state.shots < limits.shots && state.unshotShare > limits.unshotShare && shoot())
        if (report && !report(state)) break;
    course.colorReconstruction();
    return state;
}

}  // namespace radlab

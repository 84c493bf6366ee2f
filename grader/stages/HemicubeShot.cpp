#include "grader/stages/HemicubeShot.h"

#include <cmath>

#include "course/DeltaFormFactors.h"
#include "course/FacePolygon.h"
#include "grader/stages/Remembered.h"

namespace radlab::grader {

namespace {

// A submission may compute eye and direction for itself, or lift the eye a little off the patch.
constexpr double mostEyeShift = 1e-3;  // in edges of the patch
constexpr double mostTilt = 1e-3;      // sine

// As the Hemicube has it.

// Of a few float operations, beside those of the sum.
constexpr double floatError = 1e-6;

// No submission returns this.
constexpr int notThisWay = -9;

double sineBetween(const glm::dvec3& a, const glm::dvec3& b) {
    return glm::length(glm::cross(glm::normalize(a), glm::normalize(b)));
}

bool finite(const Vec3f& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

bool isRight(const Camera& camera, const MyPolygon& shooter) {
    if (!finite(camera.eye) || !finite(camera.direction) || camera.direction == Vec3f(0.0f)) return false;
    const glm::dvec3 shift = glm::dvec3(camera.eye) - glm::dvec3(shooter.center), normal(shooter.normal);
    const double edge = std::sqrt(static_cast<double>(shooter.area));
    const double rounding = floatError * (edge + glm::length(glm::dvec3(shooter.center)));
    const glm::dvec3 direction(camera.direction);
    return glm::length(shift) <= mostEyeShift * edge + rounding && glm::dot(shift, normal) >= -rounding &&
           glm::dot(direction, normal) > 0.0 && sineBetween(direction, normal) < mostTilt;
}

}  // namespace

HemicubeUse useOf(const StepAnswer& answer) {
    HemicubeUse use;
    std::optional<Camera> last;
    for (const HemicubeCall& call : answer.calls) {
        if (call.reads) {
            use.readTooEarly = use.readTooEarly || !use.rendered;
            use.read = true;
            if (last) use.camera = last;
        } else {
            use.rendered = true;
            last = {call.eye, call.up, call.direction};
        }
    }
    if (!use.camera) use.camera = last;
    return use;
}

bool usable(const Vec3f& up, const Vec3f& direction) {
    if (!finite(up) || up == Vec3f(0.0f)) return false;
    return sineBetween(glm::dvec3(up), glm::dvec3(direction)) >= parallelSine;
}

Vec3f perpendicular(const Vec3f& direction) {
    const glm::dvec3 d(direction);
    return Vec3f(glm::normalize(glm::cross(d, axisAcross(d))));
}

Camera rightCamera(const Situation& at, const MyPolygon& shooter) {
    Camera camera{shooter.center, perpendicular(shooter.normal), shooter.normal};
    const std::optional<Camera> used = useOf(at.answer).camera;
    if (used && isRight(*used, shooter)) {
        camera.eye = used->eye;
        camera.direction = used->direction;
        if (usable(used->up, used->direction)) camera.up = used->up;
    }
    return camera;
}

namespace {

std::shared_ptr<const HemicubeBuffer> emptyBuffer(int size) {
    return std::make_shared<const HemicubeBuffer>(HemicubeBuffer{size, rasterIds({}, {}, 2 * size, 2 * size)});
}

HemicubeBuffer retargeted(const HemicubeBuffer& buffer, const ShotWay& way, int count) {
    HemicubeBuffer made = buffer;
    for (int& patch : made.image.patch) patch = way.target(patch, count);
    for (int& patch : made.image.candidates) patch = way.target(patch, count);
    return made;
}

std::vector<float> weighted(std::vector<float> deltas, const ShotWay& way, int edge) {
    for (std::size_t pixel = 0; pixel < deltas.size(); ++pixel)
        deltas[pixel] = way.weight(static_cast<int>(pixel) % edge, static_cast<int>(pixel) / edge, edge, deltas[pixel]);
    return deltas;
}

// What formF holds before a shot, with how far it may be off by the shot before.
Row staleRow(const State& before, const std::vector<double>& slack) {
    Row row{{}, slack};
    for (const MyPolygon& patch : before.patches) row.values.push_back(static_cast<double>(patch.formF));
    row.slack.resize(row.values.size());
    return row;
}

void write(const Row& row, Outcome& outcome) {
    outcome.slack.resize(row.values.size());
    for (std::size_t j = 0; j < row.values.size(); ++j) {
        outcome.state.patches[j].formF = static_cast<float>(row.values[j]);
        outcome.slack[j] = row.slack[j] + floatError * (std::abs(row.values[j]) + row.slack[j]);
    }
}

Outcome ends(const Situation& at, int returned, const Stop& stop = {}) {
    Outcome outcome;
    outcome.state = at.before;
    outcome.returned = returned;
    outcome.stop = stop;
    return outcome;
}

}  // namespace

struct HemicubeShooter::Memory {
    Remembered<HemicubeBuffer> buffers;
    Remembered<std::vector<float>> deltas;

    std::shared_ptr<const HemicubeBuffer> bufferAt(const State& state, const Camera& camera, int size) {
        Fingerprint key;
        key.addShape(state);
        for (const Vec3f& v : {camera.eye, camera.up, camera.direction}) key.add(v);
        key.add(size);
        return buffers.get(key, [&] { return hemicubeBuffer(state, camera.eye, camera.up, camera.direction, size); });
    }

    // What is left of the step before.
    std::shared_ptr<const HemicubeBuffer> bufferBefore(const Situation& at) {
        if (!at.earlier) return emptyBuffer(at.step.hemicubeSize);
        const Situation& before = *at.earlier;
        const auto shooter = static_cast<std::size_t>(before.step.shooter);
        return bufferAt(before.before, rightCamera(before, before.before.patches[shooter]), before.step.hemicubeSize);
    }

    std::shared_ptr<const std::vector<float>> deltasOf(int size) {
        Fingerprint key;
        key.add(size);
        return deltas.get(key, [&] { return deltaFormFactors(size); });
    }

    Outcome shoot(const ShotWay& way, const Situation& at);
    Outcome shootFrom(int shooter, std::shared_ptr<const HemicubeBuffer> buffer, const ShotWay& way,
                      const Situation& at);
};

Outcome HemicubeShooter::Memory::shoot(const ShotWay& way, const Situation& at) {
    const int s = way.shooter(at);
    if (s < 0) return ends(at, way.returned(s));
    const MyPolygon& shooter = at.before.patches[static_cast<std::size_t>(s)];
    if (way.fits && !way.fits(useOf(at.answer))) return ends(at, notThisWay);
    if (way.stop)
        if (const Stop stop = way.stop(shooter); stop.kind != Stop::Kind::none) return ends(at, s, stop);
    if (way.readsBefore) return shootFrom(s, bufferBefore(at), way, at);
    const std::optional<Camera> camera = way.camera(at, shooter);
    if (!camera) return ends(at, notThisWay);
    if (!usable(camera->up, camera->direction)) return ends(at, s, {Stop::Kind::error, "up vector"});
    return shootFrom(s, bufferAt(at.before, *camera, at.step.hemicubeSize), way, at);
}

Outcome HemicubeShooter::Memory::shootFrom(int shooter, std::shared_ptr<const HemicubeBuffer> buffer,
                                           const ShotWay& way, const Situation& at) {
    const std::size_t count = at.before.patches.size();
    if (way.target) buffer = std::make_shared<const HemicubeBuffer>(retargeted(*buffer, way, static_cast<int>(count)));
    const int size = at.step.hemicubeSize;
    Shot shot{at, shooter, *buffer, *deltasOf(size), {}, {}};
    if (way.weight) shot.weights = weighted(std::move(shot.weights), way, 2 * size);
    shot.stale = staleRow(at.before, at.earlier ? shoot(way, *at.earlier).slack : std::vector<double>());
    shot.row = way.collect ? way.collect(shot) : hemicubeRow(*buffer, shot.weights, count);
    if (way.finish) way.finish(shot);
    Outcome outcome = ends(at, way.returned(shooter));
    write(shot.row, outcome);
    return outcome;
}

HemicubeShooter::HemicubeShooter() : memory(std::make_shared<Memory>()) {}
HemicubeShooter::~HemicubeShooter() = default;

Computation HemicubeShooter::shoots(const ShotWay& way) const {
    return [way, kept = memory](const Situation& at) { return kept->shoot(way, at); };
}

}  // namespace radlab::grader

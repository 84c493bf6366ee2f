#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "grader/stages/HemicubeRow.h"
#include "grader/stages/Stage.h"

namespace radlab::grader {

/// Where a hemicube stands, and which way it is turned.
struct Camera {
    Vec3f eye, up, direction;
};

/// What a submission did with its hemicube in a step.
struct HemicubeUse {
    bool rendered = false;         ///< renderScene was called
    bool read = false;             ///< readIndexBuffer was called
    bool readTooEarly = false;     ///< but no renderScene came before it
    std::optional<Camera> camera;  ///< of the renderScene whose IDs it read; where it read none, of the last
};

HemicubeUse useOf(const StepAnswer& answer);

/// The camera that a shot from a patch needs: the submission's own where it is right, since any up vector is.
Camera rightCamera(const Situation& at, const MyPolygon& shooter);

/// Whether Hemicube takes that up vector with that direction.
bool usable(const Vec3f& up, const Vec3f& direction);

/// A vector at right angles to another one.
Vec3f perpendicular(const Vec3f& direction);

/// What is known in the middle of a shot.
struct Shot {
    const Situation& at;
    int shooter;                   ///< index of the patch that shoots
    const HemicubeBuffer& buffer;  ///< the IDs that are read, less 1
    std::vector<float> weights;    ///< of pixels: their delta form factors
    Row stale;                     ///< what formF holds before
    Row row;                       ///< what it will hold: what the pixels add up to

    const MyPolygon& from() const { return at.before.patches[static_cast<std::size_t>(shooter)]; }
};

/// A way to do what calcFF does; as it stands, the right one.
struct ShotWay {
    /// Nothing where the submission's calls show that it went another way; where up is not usable, the Hemicube refuses.
    std::function<std::optional<Camera>(const Situation&, const MyPolygon& shooter)> camera = rightCamera;
    /// Whether the submission's calls are as this way needs them; not asked where there are no patches.
    std::function<bool(const HemicubeUse&)> fits;
    /// Where the Hemicube refuses to render.
    std::function<Stop(const MyPolygon& shooter)> stop;
    std::function<int(const Situation&)> shooter = [](const Situation& at) { return at.step.shooter; };
    bool readsBefore = false;  ///< the IDs are those of the step before, or none
    /// The weight of a pixel of a square of `edge` pixels each way.
    std::function<float(int x, int y, int edge, float delta)> weight;
    /// The patch that gets what a pixel shows, by index; -1 is background, and nobody. A pixel may show -1.
    std::function<int(int patch, int count)> target;
    /// Adds up; or does something else with the pixels.
    std::function<Row(const Shot&)> collect;
    std::function<void(Shot&)> finish;
    std::function<int(int index)> returned = [](int index) { return index; };
};

/// Shoots; what has been rasterised once is kept for as long as the computation lives.
class HemicubeShooter {
public:
    HemicubeShooter();
    ~HemicubeShooter();

    Computation shoots(const ShotWay& way) const;

private:
    struct Memory;
    std::shared_ptr<Memory> memory;
};

}  // namespace radlab::grader

// A libFuzzer program: whatever the bytes, the readers end in a valid result or in an Error.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "base/Error.h"
#include "base/Warning.h"
#include "scene/Effects.h"
#include "scene/Placement.h"
#include "scene/ResourceFile.h"
#include "scene/X3dReader.h"

namespace {

using namespace radlab;

// Small, so that time goes into parsing and not into writing out what USE repeats.
constexpr X3dLimits limits{2'000, 5'000, 10'000, 5'000, 50};

// libFuzzer keeps the input of a run that aborts.
void require(bool holds) {
    if (!holds) std::abort();
}

void checkScene(const Scene& scene) {
    const int count = static_cast<int>(scene.vertices.size());
    require(!scene.faces.empty());
    require(scene.faces.size() <= limits.faces);
    for (const Vec3f& vertex : scene.vertices) require(isFinite(vertex));
    for (const Face& face : scene.faces) {
        require(face.corners.size() >= 3u);
        require(face.material != nullptr);
        require(isFinite(face.material->diffuse) && isFinite(face.material->emissive));
        for (int corner : face.corners) require(corner >= 0 && corner < count);
    }
    for (const Camera& camera : scene.cameras) {
        require(isFinite(camera.position));
        require(std::abs(glm::length(camera.direction) - 1.0f) < 1e-4f);
        require(std::abs(glm::length(camera.up) - 1.0f) < 1e-4f);
        require(std::abs(glm::dot(camera.up, camera.direction)) < 1e-4f);
    }
}

void checkResource(const Resource& resource) {
    require(resource.hemicubeSize >= 2);
    require(std::isfinite(resource.patchSize) && resource.patchSize > 0);
    require(std::isfinite(resource.lightSize) && resource.lightSize > 0);
}

template <class Run>
void tolerate(Run run) {
    try {
        run();
    } catch (const Error&) {
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const WarningCapture quiet;
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    tolerate([&] {
        const Scene scene = parseX3d(text, "fuzz.x3d", limits);
        checkScene(scene);
        findEffects(scene);
    });
    tolerate([&] { checkResource(parseResource(text, "fuzz.xml")); });
    return 0;
}

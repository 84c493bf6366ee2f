#include "apps/SpecularPart.h"

#include "base/ProgressBar.h"
#include "base/Stopwatch.h"

namespace radlab {

using namespace engine;

SpecularPart::SpecularPart(const SceneInput& input) {
    if (!input.effects.specularInSolution()) return;
    const Stopwatch watch;
    ProgressBar bar("specular transport", static_cast<double>(input.geometry.patches.size()), "patches");
    SpecularOptions options;
    options.progress = [&](std::size_t patches) { bar.show(static_cast<double>(patches)); };
    transport.emplace(input.geometry, input.scatterings, options);
    char text[150];
    std::snprintf(text, sizeof text, "\nover specular faces: %zu rays, %zu pairs of patches, %.3g s", transport->rays(),
                  transport->entries(), watch.seconds());
    summary = text;
}

}  // namespace radlab

#include "solver/FormFactors.h"

#include <memory>

#include "course/ProgRef.h"
#include "scene/Effects.h"

namespace radlab {

FormFactorMethod formFactorMethod(const Resource& resource, const Scene& scene) {
    if (resource.method != FormFactorMethod::automatic) return resource.method;
    return findEffects(scene).has(Effect::occlusion) ? FormFactorMethod::hemicube : FormFactorMethod::analytic;
}

Progressive::FormFactors formFactorsBy(FormFactorMethod method, int hemicubeSize) {
    RADLAB_CHECK(method != FormFactorMethod::automatic);
    if (method == FormFactorMethod::analytic) return calcAnalyticalFF;
    const auto hemicube = std::make_shared<Hemicube>(hemicubeSize);
    return [hemicube] { return calcFF(hemicube.get()); };
}

}  // namespace radlab

#include "solver/MethodChoice.h"

#include "scene/Effects.h"

namespace radlab {

FormFactorMethod formFactorMethod(const Resource& resource, const Scene& scene) {
    if (resource.method != FormFactorMethod::automatic) return resource.method;
    return findEffects(scene).has(Effect::occlusion) ? FormFactorMethod::hemicube : FormFactorMethod::analytic;
}

}  // namespace radlab

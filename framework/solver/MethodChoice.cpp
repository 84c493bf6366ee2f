#include "solver/MethodChoice.h"

namespace radlab {

FormFactorMethod formFactorMethod(const Resource& resource, const Scene& scene) {
    if (resource.method != FormFactorMethod::automatic) return resource.method;
    return formFactorMethod(FormFactorMethod::automatic, findEffects(scene));
}

FormFactorMethod formFactorMethod(FormFactorMethod wanted, const Effects& effects) {
    if (wanted != FormFactorMethod::automatic) return wanted;
    return effects.has(Effect::occlusion) ? FormFactorMethod::hemicube : FormFactorMethod::analytic;
}

}  // namespace radlab

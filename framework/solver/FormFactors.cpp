#include "solver/FormFactors.h"

#include <memory>

#include "course/ProgRef.h"

namespace radlab {

Progressive::FormFactors formFactorsBy(FormFactorMethod method, int hemicubeSize) {
    RADLAB_CHECK(method != FormFactorMethod::automatic);
    if (method == FormFactorMethod::analytic) return calcAnalyticalFF;
    const auto hemicube = std::make_shared<Hemicube>(hemicubeSize);
    return [hemicube] { return calcFF(hemicube.get()); };
}

}  // namespace radlab

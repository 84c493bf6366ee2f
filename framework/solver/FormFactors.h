#pragma once

#include "solver/MethodChoice.h"
#include "solver/Progressive.h"

namespace radlab {

/// The course's function for a method: calcAnalyticalFF, or calcFF on a hemicube of the given size.
///
/// @pre method is not automatic; for the hemicube a GlContext is current, as long as the result lives
Progressive::FormFactors formFactorsBy(FormFactorMethod method, int hemicubeSize);

}  // namespace radlab

// A file of its own: programs that load the six functions from a library define none of them.

#include "course/ProgRef.h"
#include "solver/CourseFunctions.h"

namespace radlab {

CourseFunctions linkedFunctions() {
    return {maxenergy_patch, calcAnalyticalFF, distributeEnergy, colorReconstruction, renderPatchIDs, calcFF};
}

}  // namespace radlab

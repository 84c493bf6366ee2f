// Part of the libraries that the viewer loads, beside the file with the six functions.

#include "course/ProgRef.h"
#include "solver/CourseFunctions.h"

#ifdef _WIN32
#define RADLAB_EXPORTED __declspec(dllexport)
#else
#define RADLAB_EXPORTED __attribute__((visibility("default")))
#endif

extern "C" RADLAB_EXPORTED const radlab::CourseFunctions* radlabCourseFunctions() {
    static const radlab::CourseFunctions functions{maxenergy_patch,     calcAnalyticalFF, distributeEnergy,
                                                   colorReconstruction, renderPatchIDs,   calcFF};
    return &functions;
}

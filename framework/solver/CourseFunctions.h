#pragma once

#include <functional>

#include "course/Hemicube.h"
#include "course/PatchMesh.h"

namespace radlab {

/// The six functions of the exercise: those that a program is linked with, or those of a library that it loads.
struct CourseFunctions {
    std::function<MyPolygon*()> maxenergyPatch;
    std::function<MyPolygon*()> calcAnalyticalFF;
    std::function<bool(MyPolygon*)> distributeEnergy;
    std::function<void()> colorReconstruction;
    std::function<void()> renderPatchIDs;
    std::function<MyPolygon*(Hemicube*)> calcFF;
};

/// The functions that this program is linked with.
CourseFunctions linkedFunctions();

}  // namespace radlab

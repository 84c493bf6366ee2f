#pragma once

#include <string>
#include <vector>

#include "engine/Geometry.h"
#include "engine/Radiosity.h"

namespace radlab::engine {

/// A scene whose radiosities are hard to find for some solver, and what they are.
struct HardRoom {
    std::string what;
    Geometry geometry;
    Surfaces surfaces;  ///< grey
    std::vector<double>
        truth;           ///< radiosity of each patch, W/m²; one number: the mean over the area; none: to be refused
    std::string source;  ///< where the truth comes from
    bool occlusion = false;
    double matrix = 1e-9;  ///< relative errors allowed; infinite where a solver is not made for the room
    double shooting = 1e-5;
    double links = 1e-2;
};

/// The table of hard rooms.
const std::vector<HardRoom>& hardRooms();

}  // namespace radlab::engine

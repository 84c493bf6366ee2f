#pragma once

#include <string>
#include <vector>

#include "engine/Geometry.h"
#include "engine/Radiosity.h"

namespace radlab::engine {

/// The ways to solve for radiosities.
enum class Solver {
    matrix,    ///< conjugate gradients on the stored form factors
    shooting,  ///< progressive refinement, rows of the same form factors
    links,     ///< hierarchical radiosity
};

std::string nameOf(Solver solver);

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

/// The largest relative error that a solver may make in a room; infinite where it is not made for it, and may take for ever.
double allowedError(const HardRoom& room, Solver solver);

/// The largest relative error that a solver makes in a room: 0 where the room is to be refused and is, infinite where a room is
/// refused that is not to be, or the other way round.
double errorOf(const HardRoom& room, Solver solver);

}  // namespace radlab::engine

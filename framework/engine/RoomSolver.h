#pragma once

#include <string>

#include "engine/HardRooms.h"

namespace radlab::engine {

/// The ways to solve for radiosities.
enum class Solver {
    matrix,    ///< conjugate gradients on the stored form factors
    shooting,  ///< progressive refinement, rows of the same form factors
    links,     ///< hierarchical radiosity
};

std::string nameOf(Solver solver);

/// The largest relative error that a solver may make in a room; infinite where it is not made for it, and may take for ever.
double allowedError(const HardRoom& room, Solver solver);

/// The largest relative error that a solver makes in a room: 0 where the room is to be refused and is, infinite where a room is
/// refused that is not to be, or the other way round.
double errorOf(const HardRoom& room, Solver solver);

}  // namespace radlab::engine

#pragma once

#include <string>
#include <vector>

#include "engine/Cost.h"
#include "engine/Scattering.h"

namespace radlab::engine {

/// A way to find radiosities, and what it is expected to give for what.
struct Way {
    bool links = false;                 ///< by hierarchical radiosity; else by a matrix of form factors
    Method method = Method::automatic;  ///< of the matrix
    double setting = 0.0;  ///< threshold of links, size of hemicubes, rays of hemisphere and visibility; 0: none
    std::size_t specularRays = 0;  ///< from each patch, over specular faces; 0: none
    double error = 0.0;            ///< expected RMS error over RMS radiosity, on a given mesh
    double seconds = 0.0;          ///< expected
};

/// "links, threshold 0.001", "visibility, 16 rays".
std::string describe(const Way& way);

/// All ways that suit a scene, with errors and times from a table of measured ones; with panes, those that let light through.
///
/// The errors are the middle ones of those seen in the project's closed and open rooms; a scene may have three times as much.
std::vector<Way> waysFor(const Work& work, const Effects& effects);

/// The fastest way whose expected error, times a factor, is at most so much; the most accurate one where none is.
///
/// @pre there are ways
Way cheapestWay(const std::vector<Way>& ways, double error, double factor = 1.0);

/// Finds the radiosities in a way.
///
/// @param scatterings of each face
std::vector<Point> solveBy(const Way& way, const Geometry& geometry, const Surfaces& surfaces,
                           const std::vector<Scattering>& scatterings, const Effects& effects);

}  // namespace radlab::engine

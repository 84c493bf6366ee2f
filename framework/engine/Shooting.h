#pragma once

#include <functional>
#include <vector>

#include "engine/Radiosity.h"

namespace radlab::engine {

struct ShootingOptions {
    double unshot = 1e-3;  ///< stop where at most this share of the emitted power is unshot
    bool indirect = true;  ///< shoot what was reflected, too
    std::size_t mostShots = static_cast<std::size_t>(-1);
    /// What a shooter exchanges with patches beside its form factors, such as light over mirrors; nothing where empty.
    std::function<std::vector<PatchExchange>(std::size_t shooter)> further = {};
    std::function<void(std::size_t shots, double unshot)>
        progress;  ///< told after every few shots; what is shot is kept where it throws Interrupted
};

struct ShootingReport {
    std::size_t shots = 0;
    double unshot = 0.0;  ///< power that is left, as a share of the emitted power, the channels added up
    Point ambient{0.0};   ///< the light that is still under way, as if it fell on all patches alike: W/m² per channel
    double seconds = 0.0;
};

/// Sets the form factors from a patch to all patches; called by several threads at once.
using RowFunction = std::function<void(std::size_t shooter, double* factors)>;

/// The radiosity of every patch by progressive refinement: rows are made when they are shot, and none is kept.
///
/// The eight patches with the most unshot power shoot in one go, so that several threads have rows to make; which these are
/// does not depend on the number of threads.
///
/// @param areas of the patches
/// @return W/m² per channel, without the ambient term
/// @cost   a row and a pass over the patches for each shot; memory for eight rows
/// Errors: light that grows from shot to shot, as rows add up to more than 1.
/// @source [Cohen1988]
std::vector<Point> shootRadiosity(const std::vector<double>& areas, const Surfaces& surfaces, const RowFunction& row,
                                  const ShootingOptions& options = {}, ShootingReport* report = nullptr);

/// Adds what each patch reflects of the ambient light: better to look at, and on average nearer to the solution, while much is
/// unshot.
///
/// @source [Cohen1988]
void addAmbient(std::vector<Point>& radiosity, const Surfaces& surfaces, const Point& ambient);

}  // namespace radlab::engine

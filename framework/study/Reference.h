#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "engine/Radiosity.h"
#include "study/StudyMesh.h"

namespace radlab::study {

/// The radiosities of a mesh as good as they can be had, and how good that is.
struct SolverReference {
    std::vector<engine::Point> radiosity;
    double error = 0.0;  ///< estimated
};

/// Exact form factors, times a visibility by so many rays for each pair that is partly hidden, and conjugate gradients.
///
/// @cost a function of pairs
SolverReference solverReference(const StudyMesh& mesh, std::size_t rays);

/// The light of a scene itself, as patches of a mesh are measured against it.
class WholeReference {
public:
    /// Solves for the light on the same patches cut on, each edge into as many as there may be patches.
    ///
    /// @param mostPatches of the fine mesh
    /// @param threshold   of the links that it is solved by
    WholeReference(const StudyMesh& coarse, std::size_t mostPatches, double threshold);

    /// How far one radiosity for each coarse patch is from the light all over it.
    ///
    /// The light deviates from the fine patches' radiosities, too, but in a way that no coarse patch can follow: so the squares add
    /// up, of what is measured against these and of estimateMeshError of these.
    ///
    /// @return as engine::relativeError
    double errorOf(const std::vector<engine::Point>& radiosity) const;

    /// The estimated error of the fine patches' radiosities.
    double error() const { return solutionError; }
    /// How far the light is from one radiosity for each fine patch: it is in every error, and grows as the mesh that
    /// is measured comes near the fine one.
    double meshError() const { return fineMeshError; }
    std::size_t patches() const { return truth.size(); }

private:
    std::vector<std::size_t> coarseOf;
    std::vector<double> areas;
    std::vector<engine::Point> truth;
    double solutionError = 0.0, fineMeshError = 0.0;
};

}  // namespace radlab::study

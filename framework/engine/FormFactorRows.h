#pragma once

#include <memory>

#include "engine/ExchangeArea.h"
#include "engine/FormFactors.h"
#include "engine/Hemicubes.h"
#include "engine/RayScene.h"
#include "engine/Visibility.h"

namespace radlab::engine {

/// Form factors row by row, or pair by pair, as they are asked for: nothing is stored.
///
/// May be asked by several threads at once; the numbers are those of the matrix, to the bit.
class FormFactorRows {
public:
    /// @param geometry  lives as long as this does
    /// Errors: a hemicube size out of its range.
    /// @cost what the method prepares: a tree of triangles, nodes on patches, pieces of patches
    FormFactorRows(const Geometry& geometry, const FormFactorOptions& options);

    /// The method, never `automatic`.
    Method method() const { return options.method; }

    /// Ai·Fij.
    ///
    /// @pre the method is one of pairs: isReciprocal(method())
    double exchange(std::size_t i, std::size_t j) const;

    /// The form factors from a patch to all.
    ///
    /// @param factors  room for as many numbers as there are patches; what was there is lost
    void row(std::size_t from, double* factors) const;

    /// How many rays were traced so far.
    std::size_t rays() const;

private:
    void byPairs(std::size_t from, double* factors) const;
    void byPoints(std::size_t from, double* factors) const;
    void byHemisphere(std::size_t from, double* factors) const;
    void follow(Point from, const Point& direction, std::size_t start, double* arrived) const;

    const Geometry& geometry;
    FormFactorOptions options;
    std::unique_ptr<ExchangeAreas> exchanges;  // these four: where the method needs them
    std::unique_ptr<Visibility> visibility;
    std::unique_ptr<Hemicubes> hemicubes;
    std::unique_ptr<RayScene> scene;
};

}  // namespace radlab::engine

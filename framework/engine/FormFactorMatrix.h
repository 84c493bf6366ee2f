#pragma once

#include <cstddef>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

#include "engine/Polygon.h"

namespace radlab::engine {

/// The bytes that a matrix of so many patches takes.
constexpr double matrixBytes(double patches) { return patches * patches * sizeof(double); }

/// The form factors between all pairs of patches, stored whole: row i, column j is F(i→j).
class FormFactorMatrix {
public:
    /// All zero.
    ///
    /// Errors: more memory than this machine has left; the message says how much.
    explicit FormFactorMatrix(const std::vector<Polygon>& patches);

    std::size_t size() const { return patchAreas.size(); }
    /// Where an entry of a matrix of so many patches lies; more entries than 32 bits can count are nothing special.
    static constexpr std::size_t indexOf(std::size_t i, std::size_t j, std::size_t patches) { return i * patches + j; }
    double& at(std::size_t i, std::size_t j) { return factors[indexOf(i, j, size())]; }
    double at(std::size_t i, std::size_t j) const { return factors[indexOf(i, j, size())]; }
    const double* row(std::size_t i) const { return factors.get() + indexOf(i, 0, size()); }
    const std::vector<double>& areas() const { return patchAreas; }

private:
    struct Freed {
        void operator()(double* numbers) const { std::free(numbers); }
    };

    std::vector<double> patchAreas;
    std::unique_ptr<double[], Freed> factors;  // from calloc: pages come when the threads that fill them ask
};

/// How well a matrix keeps the two laws that form factors obey.
struct MatrixQuality {
    double lowestSum = 0.0, highestSum = 0.0,
           meanSum = 0.0;                ///< of rows; 1 in a closed scene, less where light leaves it
    std::size_t highestRow = 0;          ///< the patch of the highest sum
    double reciprocity = 0.0;            ///< the largest |Ai·Fij - Aj·Fji|, over the smaller of Ai and Aj
    std::size_t worstI = 0, worstJ = 0;  ///< the pair that has it
};

/// @cost one pass over the matrix; sums are in double, row by row
MatrixQuality qualityOf(const FormFactorMatrix& matrix);

/// The quality in two lines of words.
std::string describe(const MatrixQuality& quality);

/// Makes Ai·Fij = Aj·Fji hold by taking the mean of both; sums of rows change.
///
/// @cost one pass over the matrix
void makeReciprocal(FormFactorMatrix& matrix);

/// Makes both laws hold: Ai·Fij = Aj·Fji for all pairs, and rows that add up to 1, or to at most 1 in an open scene.
///
/// Makes the matrix reciprocal, then multiplies rows and columns alike, again and again, until the sums are right: so zeros
/// stay zero, nothing becomes negative, and the pairs stay reciprocal all the way. A scene counts as closed where the mean sum is
/// within 2 % of 1.
///
/// @return the largest deviation of a row's sum that is left: where it is not small, no such matrix exists for these zeros
/// @cost one pass over the matrix for each of at most 1,000 rounds, until the deviation is below 1e-12
/// @source [CohenWallace1993, chapter 4] the two laws
double enforceLaws(FormFactorMatrix& matrix);

}  // namespace radlab::engine

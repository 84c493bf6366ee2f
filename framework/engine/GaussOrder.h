#pragma once

#include <array>

namespace radlab::engine {

/// How many Gauss-Legendre nodes a function needs in each direction, by how far off its nearest singularity is.
class GaussOrders {
public:
    static constexpr int most = 12;

    /// @param tolerance of the relative error
    /// @cost  some ten microseconds
    explicit GaussOrders(double tolerance);

    double tolerance() const { return error; }

    /// Nodes that suffice, 1 to most; most + 1 where these do not.
    ///
    /// The error of a rule falls as ρ^(-2 order), with ρ the size of the ellipse through the singularity. Measured on
    /// squares in random places, the largest error is at most 8 times the distance times that.
    ///
    /// @param distance of the singularity from the middle, in half lengths of the interval
    /// @cost  one comparison where few nodes suffice
    int at(double distance) const;

private:
    double error;
    std::array<double, most> nearest;  // the smallest distance at which 1, 2, 3... nodes suffice
};

}  // namespace radlab::engine

#pragma once

#include <string>
#include <vector>

#include <glm/vec2.hpp>

namespace radlab::study {

/// What an axis counts, and so how its numbers are written.
enum class Unit { seconds, share, count, bytes };

struct Axis {
    std::string title;
    Unit unit;
};

/// The points of one method, and the name that stands beside them.
struct Curve {
    std::string method;  ///< decides colour, dashes and mark
    std::string label;
    std::vector<glm::dvec2> points;      ///< joined in their order
    std::vector<glm::dvec2> loose = {};  ///< not joined
};

/// A plot on logarithmic axes.
struct Plot {
    std::string file;  ///< without its ending
    Axis x, y;
    std::vector<Curve> curves;      ///< all coordinates above 0; those without a joined point are not shown
    std::vector<glm::dvec2> front;  ///< the Pareto front, numbered from 1; may be empty
};

/// Numbers moved apart as little as this needs: in their order, at least `gap` between neighbours, none below `low` and, where
/// there is room, none above `high`.
std::vector<double> spreadOut(std::vector<double> places, double gap, double low, double high);

/// The numbers of a logarithmic axis between two values: powers of ten, and 2 and 5 times these where there are few.
std::vector<double> ticsBetween(double low, double high);

}  // namespace radlab::study

#include "grader/stages/PairFormula.h"

#include <algorithm>
#include <numbers>

namespace radlab::grader {

Pair pairOf(const MyPolygon& from, const MyPolygon& to) {
    const glm::dvec3 between = glm::dvec3(to.center) - glm::dvec3(from.center);
    const double distance = glm::length(between);
    const glm::dvec3 direction = between / distance;
    return {distance,
            glm::dot(glm::dvec3(from.normal), direction),
            -glm::dot(glm::dvec3(to.normal), direction),
            static_cast<double>(from.area),
            static_cast<double>(to.area),
            static_cast<double>(glm::dot(from.normal, to.normal))};
}

double pointToPoint(const Pair& pair) {
    return std::max(pair.cosineFrom, 0.0) * std::max(pair.cosineTo, 0.0) * pair.areaTo /
           (std::numbers::pi * pair.distance * pair.distance);
}

}  // namespace radlab::grader

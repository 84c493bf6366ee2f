#include "study/PowerFit.h"

#include <cmath>

#include <glm/glm.hpp>

namespace radlab::study {

double PowerFit::at(double x) const { return factor * std::pow(x, exponent); }

std::optional<PowerFit> fitPower(const std::vector<glm::dvec2>& points) {
    std::vector<glm::dvec2> logs;
    glm::dvec2 mean(0.0);
    for (const glm::dvec2& point : points) {
        if (!(point.x > 0.0) || !(point.y > 0.0)) continue;
        logs.push_back(glm::log(point));
        mean += logs.back();
    }
    if (logs.empty()) return {};
    mean /= static_cast<double>(logs.size());
    double across = 0.0, along = 0.0;
    for (const glm::dvec2& log : logs) {
        const glm::dvec2 off = log - mean;
        across += off.x * off.y;
        along += off.x * off.x;
    }
    if (!(along > 0.0)) return {};
    const double exponent = across / along;
    return PowerFit{std::exp(mean.y - exponent * mean.x), exponent};
}

}  // namespace radlab::study

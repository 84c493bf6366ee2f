#include "engine/RelativeError.h"

#include <cmath>

#include "base/Error.h"

namespace radlab::engine {

double relativeError(const std::vector<double>& areas, const std::vector<Point>& found,
                     const std::vector<Point>& truth) {
    RADLAB_CHECK(found.size() == truth.size());
    RADLAB_CHECK(areas.size() == truth.size());
    double error = 0.0, all = 0.0;
    for (std::size_t i = 0; i < truth.size(); ++i) {
        const Point off = found[i] - truth[i];
        error += areas[i] * glm::dot(off, off);
        all += areas[i] * glm::dot(truth[i], truth[i]);
    }
    return all > 0.0 ? std::sqrt(error / all) : 0.0;
}

}  // namespace radlab::engine

#pragma once

#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include "grader/stages/HemicubeShot.h"

namespace radlab::grader {

/// The slack of a form factor that may be anything.
inline constexpr double unknown = std::numeric_limits<double>::infinity();

/// Makes computations that differ from the right one in one way.
class Ways {
public:
    explicit Ways(const HemicubeShooter& from) : shooter(from) {}

    Computation with(const std::function<void(ShotWay&)>& change) const {
        ShotWay way;
        change(way);
        return shooter.shoots(way);
    }
    Computation weight(const std::function<float(int x, int y, int edge, float delta)>& change) const {
        return with([&](ShotWay& way) { way.weight = change; });
    }
    /// Only the pixels of a part of the buffer.
    Computation part(const std::function<bool(int x, int y, int edge)>& in) const {
        return weight([in](int x, int y, int edge, float delta) { return in(x, y, edge) ? delta : 0.0f; });
    }
    Computation target(const std::function<int(int patch, int count)>& change) const {
        return with([&](ShotWay& way) { way.target = change; });
    }
    /// IDs that have gone through a smaller number.
    template <class Number>
    Computation narrow() const {
        return target([](int patch, int count) {
            const int id = static_cast<Number>(patch + 1);
            return id > 0 && id <= count ? id - 1 : -1;
        });
    }
    Computation finish(const std::function<void(Shot&)>& change) const {
        return with([&](ShotWay& way) { way.finish = change; });
    }
    /// Each form factor times something that depends on the patch.
    Computation times(const std::function<double(const MyPolygon& from, const MyPolygon& to)>& factor) const {
        return finish([factor](Shot& shot) {
            for (std::size_t j = 0; j < shot.row.values.size(); ++j) {
                const double f = factor(shot.from(), shot.at.before.patches[j]);
                shot.row.values[j] *= f;
                shot.row.slack[j] *= std::abs(f);
            }
        });
    }
    Computation camera(const std::function<std::optional<Camera>(const Situation&, const MyPolygon&)>& change) const {
        return with([&](ShotWay& way) { way.camera = change; });
    }

private:
    const HemicubeShooter& shooter;
};

/// All form factors 0.
inline Row nothing(const Shot& shot) {
    const std::size_t count = shot.at.before.patches.size();
    return {std::vector<double>(count), std::vector<double>(count)};
}

/// Mistakes about where the hemicube stands, how it is turned, and which of its pictures is read.
std::vector<Mistake> cameraMistakes(const Ways& ways);

/// Mistakes about which pixels count, for which patch, and how much.
std::vector<Mistake> pixelMistakes(const Ways& ways);

/// Mistakes about what is done with the sums, and what is returned.
std::vector<Mistake> resultMistakes(const Ways& ways);

}  // namespace radlab::grader

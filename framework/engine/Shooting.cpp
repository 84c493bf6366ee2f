#include "engine/Shooting.h"

#include <algorithm>
#include <numeric>

#include <tbb/parallel_for.h>

#include "base/Error.h"
#include "base/Interrupts.h"
#include "base/Stopwatch.h"

namespace radlab::engine {

namespace {

constexpr std::size_t atOnce = 8;

double sum(const Point& color) { return color.x + color.y + color.z; }

class Shooter {
public:
    Shooter(const std::vector<double>& patchAreas, const Surfaces& materials, bool followReflected)
        : areas(patchAreas),
          surfaces(materials),
          radiosity(materials.emission),
          unshot(materials.emission),
          indirect(followReflected) {
        power.resize(areas.size());
        for (std::size_t i = 0; i < areas.size(); ++i) power[i] = areas[i] * sum(unshot[i]);
        emitted = unshotPower();
    }

    double unshotPower() const { return std::accumulate(power.begin(), power.end(), 0.0); }

    // The patches with the most power, at most so many, none without any.
    std::vector<std::size_t> brightest(std::size_t most) const {
        std::vector<std::size_t> order(areas.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        const auto end = order.begin() + static_cast<std::ptrdiff_t>(std::min(most, order.size()));
        std::partial_sort(order.begin(), end, order.end(), [&](std::size_t a, std::size_t b) {
            return power[a] != power[b] ? power[a] > power[b] : a < b;
        });
        order.erase(std::find_if(order.begin(), end, [&](std::size_t i) { return !(power[i] > 0.0); }), order.end());
        return order;
    }

    void shoot(std::size_t from, const std::vector<double>& factors, const std::vector<PatchExchange>& further) {
        const Point light = std::exchange(unshot[from], Point(0.0));
        power[from] = 0.0;
        for (std::size_t i = 0; i < areas.size(); ++i)
            if (factors[i] > 0.0) receive(i, areas[from] * factors[i] * light);
        for (const PatchExchange& other : further) receive(other.patch, other.exchange * light);
    }

    // What is unshot spread over all patches, and what they then reflect again and again.
    Point ambient() const {
        Point reflectance(0.0), light(0.0);
        double all = 0.0;
        for (std::size_t i = 0; i < areas.size(); ++i) {
            all += areas[i];
            reflectance += areas[i] * surfaces.reflectance[i];
            light += areas[i] * unshot[i];
        }
        return all > 0.0 ? light / all / glm::max(1.0 - reflectance / all, Point(1e-6)) : Point(0.0);
    }

    const std::vector<double>& areas;
    const Surfaces& surfaces;
    std::vector<Point> radiosity, unshot;
    std::vector<double> power;
    double emitted;

private:
    void receive(std::size_t patch, const Point& light) {
        if (!(areas[patch] > 0.0)) return;
        const Point reflected = surfaces.reflectance[patch] * light / areas[patch];
        radiosity[patch] += reflected;
        if (!indirect) return;
        unshot[patch] += reflected;
        power[patch] = areas[patch] * sum(unshot[patch]);
    }

    bool indirect;
};

}  // namespace

std::vector<Point> shootRadiosity(const std::vector<double>& areas, const Surfaces& surfaces, const RowFunction& row,
                                  const ShootingOptions& options, ShootingReport* report) {
    constexpr double grown = 1e3;
    const Stopwatch watch;
    Shooter shooter(areas, surfaces, options.indirect);
    std::vector<std::vector<double>> rows(atOnce, std::vector<double>(areas.size()));
    std::size_t shots = 0;
    double left = shooter.emitted;
    const auto takeTurn = [&](const std::vector<std::size_t>& turn) {
        tbb::parallel_for(std::size_t{0}, turn.size(), [&](std::size_t k) { row(turn[k], rows[k].data()); });
        for (std::size_t k = 0; k < turn.size(); ++k)
            shooter.shoot(turn[k], rows[k], options.further ? options.further(turn[k]) : std::vector<PatchExchange>());
        shots += turn.size();
        left = shooter.unshotPower();
        if (!(left < grown * shooter.emitted))
            throw Error(
                "the light grows from shot to shot, since form factors add up to more than 1: expected smaller "
                "patches, smaller reflectances, or another method");
    };
    const bool whole = doneWhole([&] {
        while (left > options.unshot * shooter.emitted && shots < options.mostShots) {
            Interrupts::check();
            const std::vector<std::size_t> turn = shooter.brightest(std::min(atOnce, options.mostShots - shots));
            if (turn.empty()) break;
            takeTurn(turn);
            if (options.progress) options.progress(shots, left / shooter.emitted);
        }
    });
    if (!whole && shots == 0) throw Interrupted();
    const double share = shooter.emitted > 0.0 ? left / shooter.emitted : 0.0;
    if (report) *report = {shots, share, shooter.ambient(), watch.seconds()};
    return shooter.radiosity;
}

void addAmbient(std::vector<Point>& radiosity, const Surfaces& surfaces, const Point& ambient) {
    for (std::size_t i = 0; i < radiosity.size(); ++i) radiosity[i] += surfaces.reflectance[i] * ambient;
}

}  // namespace radlab::engine

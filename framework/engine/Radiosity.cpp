#include "engine/Radiosity.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <list>

#include <tbb/parallel_for.h>

#include "base/Error.h"
#include "base/Interrupts.h"

namespace radlab::engine {

namespace {

using Values = std::vector<double>;

double dot(const Values& a, const Values& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
    return sum;
}

Values exchanged(const Transport& transport, const Values& x) {
    Interrupts::check();
    Values result(x.size());
    transport.exchange(x, result);
    return result;
}

[[noreturn]] void refuse(const Transport& transport, const Values& reflectance, const std::string& why) {
    const Values sums = exchanged(transport, Values(reflectance.size(), 1.0));
    double most = -1.0;
    std::size_t patch = 0;
    for (std::size_t i = 0; i < sums.size(); ++i) {
        const double comesBack = transport.areas[i] > 0.0 ? reflectance[i] * sums[i] / transport.areas[i] : 0.0;
        if (comesBack <= most) continue;
        most = comesBack;
        patch = i;
    }
    char text[200];
    std::snprintf(text, sizeof text,
                  ": of what leaves patch %zu, %.9g comes back to it as reflected light; expected less than 1 "
                  "(smaller reflectances, or better form factors)",
                  patch, most);
    throw Error(why + text);
}

// The symmetric system of one channel.
class System {
public:
    System(Transport exchanged, const Values& reflectance) : light(std::move(exchanged)), scale(reflectance.size()) {
        for (std::size_t i = 0; i < scale.size(); ++i) {
            const double area = light.areas[i];
            scale[i] = area > 0.0 ? std::sqrt(reflectance[i] / area) : 0.0;
        }
    }

    // √(ρ/A)·S·x
    Values reflected(const Values& x) const { return scaled(exchanged(light, x)); }

    const Transport& transport() const { return light; }

    Values scaled(Values y) const {
        for (std::size_t i = 0; i < y.size(); ++i) y[i] *= scale[i];
        return y;
    }

    // What conjugate gradients need: (1 - M)·y.
    Values apply(const Values& y) const {
        Values result = reflected(scaled(y));
        for (std::size_t i = 0; i < y.size(); ++i) result[i] = y[i] - result[i];
        return result;
    }

private:
    Transport light;
    Values scale;
};

// All that is exchanged in a channel.
Transport inChannel(const Transport& transport, int channel) {
    if (!transport.further) return transport;
    return {transport.areas, [&transport, channel](const Values& x, Values& result) {
                transport.exchange(x, result);
                transport.further(channel, x, result);
            }};
}

// xᵀ·S·y and yᵀ·S·x are the same for a reciprocal exchange; for another one they are not, unless by a rare chance.
void requireReciprocal(const Transport& transport) {
    constexpr double within = 1e-9;
    Values x, y;
    for (std::size_t i = 0; i < transport.areas.size(); ++i) {
        x.push_back(1.0 + std::sin(double(i)));
        y.push_back(1.0 + std::cos(double(i * i)));
    }
    const double there = dot(y, exchanged(transport, x)), back = dot(x, exchanged(transport, y));
    if (std::abs(there - back) > within * std::abs(there))
        throw Error("these form factors are not reciprocal (Ai Fij and Aj Fji differ): make them so before solving");
}

bool isDark(const Values& values) {
    return std::all_of(values.begin(), values.end(), [](double v) { return v == 0.0; });
}

// Conjugate gradients for one channel; what there is after any iteration is a solution, as good as its residual.
class ChannelSolver {
public:
    ChannelSolver(int number, const Transport& light, const Surfaces& surfaces, const SolverOptions& options)
        : channel(number),
          emission(channelOf(surfaces.emission, channel)),
          reflectance(channelOf(surfaces.reflectance, channel)),
          system(light, reflectance),
          y(emission.size()),
          mostIterations(options.mostIterations) {
        if (isDark(reflectance)) return;
        residual = direction = system.reflected(emission);
        square = dot(residual, residual);
        first = std::sqrt(square);
        wanted = options.tolerance * first;
        if (options.indirect) return;
        y = residual;
        square = 0.0;
    }

    bool isDone() const { return !(std::sqrt(square) > wanted); }
    std::size_t iterations() const { return count; }
    double relativeResidual() const { return first > 0.0 ? std::sqrt(square) / first : 0.0; }

    void iterate() {
        if (count == mostIterations) refuse(system.transport(), reflectance, "the light did not settle");
        const Values applied = system.apply(direction);
        const double curvature = dot(direction, applied);
        if (!(curvature > 1e-14 * dot(direction, direction)))
            refuse(system.transport(), reflectance, "the light in this scene never ends");
        const double step = square / curvature;
        for (std::size_t i = 0; i < y.size(); ++i) {
            y[i] += step * direction[i];
            residual[i] -= step * applied[i];
        }
        const double next = dot(residual, residual);
        for (std::size_t i = 0; i < y.size(); ++i) direction[i] = residual[i] + next / square * direction[i];
        square = next;
        ++count;
    }

    Values radiosity() const {
        Values all = system.scaled(y);
        for (std::size_t i = 0; i < all.size(); ++i) all[i] += emission[i];
        return all;
    }

    const int channel;

private:
    const Values emission, reflectance;
    const System system;
    Values y, residual, direction;
    double square = 0.0, first = 0.0, wanted = 0.0;
    std::size_t count = 0, mostIterations;
};

// All channels by turns, so that those of a solution that is cut short are about equally good.
bool solvedByTurns(std::list<ChannelSolver>& solvers) {
    return doneWhole([&] {
        for (bool any = true; any;) {
            any = false;
            for (ChannelSolver& one : solvers) {
                if (one.isDone()) continue;
                one.iterate();
                any = true;
            }
        }
    });
}

}  // namespace

Surfaces surfacesOf(const PatchMesh& mesh) {
    Surfaces surfaces;
    for (const MyPolygon& patch : mesh.patches) {
        surfaces.emission.emplace_back(patch.emissive);
        surfaces.reflectance.emplace_back(patch.diffuse);
    }
    return surfaces;
}

std::vector<double> channelOf(const std::vector<Point>& colors, int channel) {
    std::vector<double> values;
    for (const Point& color : colors) values.push_back(color[channel]);
    return values;
}

Transport transportOf(const FormFactorMatrix& matrix) {
    return {matrix.areas(), [&matrix](const Values& x, Values& result) {
                tbb::parallel_for(std::size_t{0}, matrix.size(), [&](std::size_t i) {
                    Interrupts::check();
                    const double* row = matrix.row(i);
                    double sum = 0.0;
                    for (std::size_t j = 0; j < matrix.size(); ++j) sum += row[j] * x[j];
                    result[i] = matrix.areas()[i] * sum;
                });
            }};
}

std::vector<Point> solveRadiosity(const Transport& transport, const Surfaces& surfaces, const SolverOptions& options,
                                  SolverReport* report) {
    RADLAB_CHECK(surfaces.emission.size() == transport.areas.size());
    RADLAB_CHECK(surfaces.reflectance.size() == transport.areas.size());
    requireReciprocal(transport);
    const Channels channels = options.channels.value_or(channelsOf(surfaces.emission, surfaces.reflectance));
    std::list<ChannelSolver> solvers;
    for (int channel = 0; channel < 3; ++channel) {
        if (!channels.solved(channel)) continue;
        const Transport light = inChannel(transport, channel);
        if (transport.further) requireReciprocal(light);
        solvers.emplace_back(channel, light, surfaces, options);
    }
    SolverReport made;
    made.stopped = !solvedByTurns(solvers);
    std::vector<Point> radiosity(transport.areas.size(), Point(0.0));
    for (const ChannelSolver& one : solvers) {
        if (!one.isDone() && one.iterations() == 0) throw Interrupted();
        const Values solved = one.radiosity();
        for (std::size_t i = 0; i < radiosity.size(); ++i) radiosity[i][one.channel] = solved[i];
        ++made.channels;
        made.iterations = std::max(made.iterations, one.iterations());
        made.residual = std::max(made.residual, one.relativeResidual());
    }
    for (Point& b : radiosity) b = channels.spread(b);
    if (report) *report = made;
    return radiosity;
}

std::vector<Point> solveRadiosity(const FormFactorMatrix& matrix, const Surfaces& surfaces,
                                  const SolverOptions& options, SolverReport* report) {
    return solveRadiosity(transportOf(matrix), surfaces, options, report);
}

}  // namespace radlab::engine

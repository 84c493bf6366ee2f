#include "engine/Radiosity.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

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
    System(const Transport& light, const Values& reflectance) : transport(light), scale(reflectance.size()) {
        for (std::size_t i = 0; i < scale.size(); ++i) {
            const double area = transport.areas[i];
            scale[i] = area > 0.0 ? std::sqrt(reflectance[i] / area) : 0.0;
        }
    }

    // √(ρ/A)·S·x
    Values reflected(const Values& x) const { return scaled(exchanged(transport, x)); }

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
    const Transport& transport;
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

struct Solved {
    Values radiosity;
    std::size_t iterations;
    double residual;
};

Solved solveChannel(const Transport& transport, const Values& emission, const Values& reflectance,
                    const SolverOptions& options) {
    if (isDark(reflectance)) return {emission, 0, 0.0};
    const System system(transport, reflectance);
    Values y(emission.size()), residual = system.reflected(emission), direction = residual;
    const double wanted = options.tolerance * std::sqrt(dot(residual, residual));
    double square = dot(residual, residual);
    std::size_t iterations = 0;
    if (!options.indirect) {
        y = residual;
        square = 0.0;
    }
    for (; std::sqrt(square) > wanted; ++iterations) {
        if (iterations == options.mostIterations) refuse(transport, reflectance, "the light did not settle");
        const Values applied = system.apply(direction);
        const double curvature = dot(direction, applied);
        if (!(curvature > 1e-14 * dot(direction, direction)))
            refuse(transport, reflectance, "the light in this scene never ends");
        const double step = square / curvature;
        for (std::size_t i = 0; i < y.size(); ++i) {
            y[i] += step * direction[i];
            residual[i] -= step * applied[i];
        }
        const double next = dot(residual, residual);
        for (std::size_t i = 0; i < y.size(); ++i) direction[i] = residual[i] + next / square * direction[i];
        square = next;
    }
    Solved solved{system.scaled(y), iterations, wanted > 0.0 ? std::sqrt(square) / wanted * options.tolerance : 0.0};
    for (std::size_t i = 0; i < y.size(); ++i) solved.radiosity[i] += emission[i];
    return solved;
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
    std::vector<Point> radiosity(transport.areas.size(), Point(0.0));
    SolverReport made;
    const Channels channels = options.channels.value_or(channelsOf(surfaces.emission, surfaces.reflectance));
    for (int channel = 0; channel < 3; ++channel) {
        if (!channels.solved(channel)) continue;
        const Transport light = inChannel(transport, channel);
        if (transport.further) requireReciprocal(light);
        const Solved solved = solveChannel(light, channelOf(surfaces.emission, channel),
                                           channelOf(surfaces.reflectance, channel), options);
        for (std::size_t i = 0; i < radiosity.size(); ++i) radiosity[i][channel] = solved.radiosity[i];
        made = {made.channels + 1, std::max(made.iterations, solved.iterations),
                std::max(made.residual, solved.residual)};
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

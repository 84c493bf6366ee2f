#include "engine/HierarchicalRadiosity.h"

#include <algorithm>
#include <array>

#include "base/Interrupts.h"
#include "base/Stopwatch.h"
#include "engine/Links.h"

namespace radlab::engine {

namespace {

constexpr std::size_t mostRounds = 8;
constexpr double roughly = 1e-2;  // as far as the light is solved that only tells what to refine

// Each channel's radiosity of every node, and how much of it a node that receives it would reflect.
class Light {
public:
    Light(const PatchTree& clusters, const Surfaces& surfaces) : tree(clusters) {
        Point all(0.0);
        for (std::size_t i = 0; i < tree.leaves(); ++i) all += tree.area(i) * surfaces.emission[i];
        for (int c = 0; c < 3; ++c) {
            emitted[c] = all[c];
            reflectance[c] = spread(surfaces.reflectance, c);
        }
        set(surfaces.emission);
    }

    void set(const std::vector<Point>& ofPatches) {
        for (int c = 0; c < 3; ++c) radiosity[c] = spread(ofPatches, c);
    }

    // The largest share of a channel's emitted light that a link carries and that is reflected there, in either direction.
    double share(const Link& link) const {
        double most = 0.0;
        for (int c = 0; c < 3; ++c)
            if (emitted[c] > 0.0)
                most = std::max({most, radiosity[c][link.a] * reflectance[c][link.b] / emitted[c],
                                 radiosity[c][link.b] * reflectance[c][link.a] / emitted[c]});
        return most * link.exchange;
    }

private:
    std::vector<double> spread(const std::vector<Point>& ofPatches, int channel) const {
        std::vector<double> values = channelOf(ofPatches, channel);
        tree.pull(values);
        return values;
    }

    const PatchTree& tree;
    std::array<double, 3> emitted;
    std::array<std::vector<double>, 3> radiosity, reflectance;
};

// Adds what arrives at each patch in another way than by links.
void addFurther(const ChannelExchange& further, const PatchTree& tree, const std::vector<Point>& radiosity,
                std::vector<Point>& arrived) {
    for (int c = 0; c < 3; ++c) {
        std::vector<double> exchanged(radiosity.size());
        further(c, channelOf(radiosity, c), exchanged);
        for (std::size_t i = 0; i < arrived.size(); ++i)
            if (tree.area(i) > 0.0) arrived[i][c] += exchanged[i] / tree.area(i);
    }
}

}  // namespace

std::vector<Point> solveHierarchical(const Geometry& geometry, const Surfaces& surfaces,
                                     const HierarchicalOptions& options, HierarchicalReport* report) {
    const Stopwatch watch;
    const PatchTree tree(geometry);
    Links links(tree, {options.occlusion, options.rays, options.tolerance});
    Light light(tree, surfaces);
    std::vector<Point> radiosity = surfaces.emission;
    HierarchicalReport made;
    SolverOptions solver;
    solver.channels = options.channels;
    solver.indirect = options.indirect;
    const auto solve = [&](double tolerance) {
        if (options.progress) options.progress(links.list().size());
        Transport transport = links.transport();
        transport.further = options.further;
        solver.tolerance = tolerance;
        SolverReport solved;
        radiosity = solveRadiosity(transport, surfaces, solver, &solved);
        made.links = links.list().size();
        made.channels = solved.channels;
        made.residual = solved.residual;
        ++made.rounds;
    };
    const auto carriesMuch = [&](const Link& link) { return light.share(link) > options.threshold; };
    made.stopped = !doneWhole([&] {
        while (links.refine(carriesMuch) && made.rounds < mostRounds) {
            solve(roughly);
            light.set(radiosity);
        }
        solve(SolverOptions().tolerance);
        const std::vector<Point>& sent = options.indirect ? radiosity : surfaces.emission;
        std::vector<Point> arrived = links.gathered(sent);
        if (options.further) addFurther(options.further, tree, sent, arrived);
        for (std::size_t i = 0; i < radiosity.size(); ++i) {
            radiosity[i] = surfaces.emission[i] + surfaces.reflectance[i] * arrived[i];
            if (options.channels) radiosity[i] = options.channels->spread(radiosity[i]);
        }
    });
    if (made.rounds == 0) throw Interrupted();
    made.rays = links.rays();
    made.seconds = watch.seconds();
    if (report) *report = made;
    return radiosity;
}

}  // namespace radlab::engine

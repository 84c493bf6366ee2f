#include "engine/SpecularTransport.h"

#include <algorithm>
#include <iterator>
#include <numeric>

#include <tbb/parallel_for.h>

#include "base/Interrupts.h"
#include "engine/LowDiscrepancy.h"
#include "engine/TracedScene.h"

namespace radlab::engine {

namespace {

// For each face whether its patches emit or reflect diffusely, and may see a specular one.
std::vector<bool> facesThatSend(const Geometry& geometry, const std::vector<Scattering>& scatterings) {
    const std::vector<Polygon>& faces = geometry.faces;
    std::vector<std::size_t> specular;
    for (std::size_t f = 0; f < faces.size(); ++f)
        if (scatterings[f].isSpecular() && faces[f].area > 0.0) specular.push_back(f);
    std::vector<bool> send;
    for (std::size_t f = 0; f < faces.size(); ++f)
        send.push_back(isSeen(scatterings[f]) && std::any_of(specular.begin(), specular.end(), [&](std::size_t other) {
                           return faceEachOther(faces[f], faces[other]);
                       }));
    return send;
}

// How many rays each patch sends: emitters, which light most, more than others; all together twice as many at most.
std::vector<std::size_t> raysOf(const Geometry& geometry, const std::vector<Scattering>& scatterings,
                                const SpecularOptions& options) {
    constexpr std::size_t most = 16;
    const std::vector<bool> send = facesThatSend(geometry, scatterings);
    const auto emits = [&](std::size_t patch) { return scatterings[geometry.faceOf[patch]].emission != Point(0.0); };
    std::vector<std::size_t> counts;
    std::size_t senders = 0, emitters = 0;
    for (std::size_t i = 0; i < geometry.patches.size(); ++i) {
        counts.push_back(send[geometry.faceOf[i]] && geometry.patches[i].area > 0.0 ? options.rays : 0);
        if (counts[i] == 0) continue;
        ++senders;
        if (emits(i)) ++emitters;
    }
    std::vector<bool> wanted(counts.size(), options.senders.empty());
    for (const std::size_t i : options.senders) wanted[i] = true;
    for (std::size_t i = 0; i < counts.size(); ++i)
        if (emits(i) && emitters > 0)
            counts[i] *= std::min(most, senders / emitters);
        else if (!wanted[i])
            counts[i] = 0;
    return counts;
}

std::vector<Arrival> arrivalsFrom(std::size_t patch, const TracedScene& scene, std::size_t rays, std::uint64_t seed) {
    const Polygon& shape = scene.patches()[patch];
    const AreaSampler sampler(shape);
    const std::uint64_t key = (seed << 48) ^ patch;
    const LowDiscrepancy points(key);
    std::vector<Arrival> found;
    for (std::size_t k = 0; k < rays; ++k) {
        Interrupts::check();
        const auto at = points.at(k);
        SpecularWalk(scene, key, k, found)
            .follow({patch, sampler.at(at[0], at[1]), true}, cosineDirection(shape.normal, at[2], at[3]));
    }
    std::stable_sort(found.begin(), found.end(), [](const Arrival& a, const Arrival& b) { return a.patch < b.patch; });
    return found;
}

}  // namespace

SpecularTransport::SpecularTransport(const Geometry& geometry, const std::vector<Scattering>& scatterings,
                                     const SpecularOptions& options) {
    const std::vector<std::size_t> counts = raysOf(geometry, scatterings, options);
    if (std::all_of(counts.begin(), counts.end(), [](std::size_t count) { return count == 0; })) return;
    const TracedScene scene(geometry, scatterings);
    rows.resize(counts.size());
    forAll(rows.size(), options.progress, [&](std::size_t i) {
        if (counts[i] > 0) rows[i] = rowOf(arrivalsFrom(i, scene, counts[i], options.seed));
    });
    traced = scene.rays();
    std::vector<double> raysByArea;
    for (std::size_t i = 0; i < counts.size(); ++i)
        raysByArea.push_back(static_cast<double>(counts[i]) / geometry.patches[i].area);
    makeReciprocal(raysByArea);
}

SpecularTransport::Row SpecularTransport::rowOf(const std::vector<Arrival>& arrivals) {
    Row row;
    for (auto from = arrivals.begin(); from != arrivals.end();) {
        const std::size_t patch = from->patch;
        Point sum(0.0);
        for (; from != arrivals.end() && from->patch == patch; ++from) sum += from->share;
        row.push_back({static_cast<std::uint32_t>(patch), {float(sum.r), float(sum.g), float(sum.b)}});
    }
    return row;
}

std::vector<SpecularTransport::Row> SpecularTransport::transposed(const std::vector<Row>& rows) {
    std::vector<Row> columns(rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i)
        for (const Entry& entry : rows[i])
            columns[entry.patch].push_back({static_cast<std::uint32_t>(i), entry.exchange});
    return columns;
}

SpecularTransport::Row SpecularTransport::merged(const Row& sent, const Row& received) {
    Row both, sums;
    std::merge(sent.begin(), sent.end(), received.begin(), received.end(), std::back_inserter(both),
               [](const Entry& a, const Entry& b) { return a.patch < b.patch; });
    for (const Entry& entry : both)
        if (sums.empty() || sums.back().patch != entry.patch)
            sums.push_back(entry);
        else
            for (std::size_t c = 0; c < 3; ++c) sums.back().exchange[c] += entry.exchange[c];
    return sums;
}

// Rays of a patch tell A·F with a variance of A·(A·F)/rays: by the inverse of A/rays both directions are weighted.
void SpecularTransport::makeReciprocal(const std::vector<double>& raysByArea) {
    const std::vector<Row> columns = transposed(rows);
    tbb::parallel_for(std::size_t{0}, rows.size(), [&](std::size_t i) {
        Interrupts::check();
        rows[i] = merged(rows[i], columns[i]);
        for (Entry& entry : rows[i])
            for (float& exchange : entry.exchange)
                exchange = static_cast<float>(double(exchange) / (raysByArea[i] + raysByArea[entry.patch]));
    });
}

ChannelExchange SpecularTransport::further() const {
    if (rows.empty()) return {};
    return [this](int channel, const std::vector<double>& x, std::vector<double>& result) {
        tbb::parallel_for(std::size_t{0}, rows.size(), [&](std::size_t i) {
            double sum = 0.0;
            for (const Entry& entry : rows[i])
                sum += static_cast<double>(entry.exchange[static_cast<std::size_t>(channel)]) * x[entry.patch];
            result[i] += sum;
        });
    };
}

std::vector<PatchExchange> SpecularTransport::row(std::size_t patch) const {
    std::vector<PatchExchange> row;
    if (rows.empty()) return row;
    for (const Entry& entry : rows[patch])
        row.push_back({entry.patch, Point(entry.exchange[0], entry.exchange[1], entry.exchange[2])});
    return row;
}

std::size_t SpecularTransport::entries() const {
    std::size_t count = 0;
    for (const std::vector<Entry>& row : rows) count += row.size();
    return count;
}

std::size_t specularRays(const Geometry& geometry, const std::vector<Scattering>& scatterings,
                         const SpecularOptions& options) {
    const std::vector<std::size_t> counts = raysOf(geometry, scatterings, options);
    return std::accumulate(counts.begin(), counts.end(), std::size_t{0});
}

}  // namespace radlab::engine

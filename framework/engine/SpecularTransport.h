#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "engine/Geometry.h"
#include "engine/Parallel.h"
#include "engine/Radiosity.h"
#include "engine/Scattering.h"
#include "engine/SpecularWalk.h"

namespace radlab::engine {

struct SpecularOptions {
    /// From each patch that may see a specular face; from emitters, where they are few, up to 16 times as many.
    std::size_t rays = 4096;
    std::uint64_t seed = 0;            ///< another one chooses other rays
    std::vector<std::size_t> senders;  ///< that send rays, beside emitters: enough for what these get; empty: all
    Progress progress;                 ///< counts patches
};

/// What patches send each other over one specular face or several: what form factors leave out.
///
/// From each patch that emits or reflects diffusely and may see a specular face go rays, spread as its diffuse light is. At the
/// front of a specular face they go on, about the mirror direction, and from then on each front that they meet gets
/// what is left of them: the extended form factor, less the part that is direct. Panes weaken rays and let them on.
/// Of rays that carry little, a few are followed for all (Russian roulette). The two directions of a pair are
/// averaged, each by what its rays are worth, so that the exchange is reciprocal to the bit.
///
/// @source [SillionPuech1989] extended form factors; [ArvoKirk1990] Russian roulette
class SpecularTransport {
public:
    /// @param scatterings of each face
    /// @cost  the rays, on all cores, the same to the bit for any number of threads; 16 bytes for each pair that
    ///        exchanges something, and twice that on the way; no ray and no memory where no face is specular
    SpecularTransport(const Geometry& geometry, const std::vector<Scattering>& scatterings,
                      const SpecularOptions& options = {});

    /// Adds to result, for each patch, what arrives from x in a channel; as Transport::further, to be outlived by this.
    ChannelExchange further() const;

    /// What a patch exchanges with others, and with itself, in their order.
    std::vector<PatchExchange> row(std::size_t patch) const;

    /// How many rays were traced.
    std::size_t rays() const { return traced; }
    /// How many pairs exchange something, both directions counted.
    std::size_t entries() const;

private:
    struct Entry {
        std::uint32_t patch;
        std::array<float, 3> exchange;  // A·F of each channel; while rows are made, the sum of what rays brought
    };
    using Row = std::vector<Entry>;

    static Row rowOf(const std::vector<Arrival>& arrivals);
    static std::vector<Row> transposed(const std::vector<Row>& rows);
    static Row merged(const Row& sent, const Row& received);
    void makeReciprocal(const std::vector<double>& raysByArea);

    std::vector<Row> rows;  // of each patch, in the order of the other patches; none where nothing is exchanged
    std::size_t traced = 0;
};

/// How many rays leave the patches for a SpecularTransport; each may be followed over several faces.
std::size_t specularRays(const Geometry& geometry, const std::vector<Scattering>& scatterings,
                         const SpecularOptions& options = {});

}  // namespace radlab::engine

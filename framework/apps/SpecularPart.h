#pragma once

#include <optional>

#include "apps/SceneInput.h"
#include "engine/SpecularTransport.h"

namespace radlab {

/// The exchange over specular faces, where a scene has such that throw light on diffuse ones, and how it was made.
struct SpecularPart {
    /// Follows the rays, with a progress bar; nothing where the scene calls for none.
    explicit SpecularPart(const SceneInput& input);

    /// What solvers add to the exchange between patches; empty where there is nothing.
    engine::ChannelExchange further() const { return transport ? transport->further() : engine::ChannelExchange(); }

    std::optional<engine::SpecularTransport> transport;
    std::string summary;  ///< for the user, a line of its own; empty where there is nothing
};

}  // namespace radlab

#pragma once

#include <array>
#include <string>

#include "course/PatchMesh.h"
#include "scene/Channels.h"
#include "scene/Scene.h"

namespace radlab {

/// What a picture of a scene may need beyond the light that comes straight from the lights to grey, dull, open faces.
enum class Effect {
    occlusion,     ///< faces hide parts of each other
    indirect,      ///< light that was reflected once lights other faces
    colour,        ///< more than one channel has to be solved
    specular,      ///< faces mirror
    transparency,  ///< light passes through faces
    smooth,        ///< radiosity is interpolated between patches
    antialias,     ///< pixels that differ from their neighbours are sampled more often
};

constexpr std::array<Effect, 7> allEffects{Effect::occlusion,    Effect::indirect, Effect::colour,   Effect::specular,
                                           Effect::transparency, Effect::smooth,   Effect::antialias};

/// The effect's name as the user writes it.
const char* nameOf(Effect effect);

/// Whether one effect is simulated, and why.
struct Decision {
    bool on = false;
    bool needed = false;  ///< what the scene calls for; differs from `on` only where forced
    bool forced = false;
    std::string reason;  ///< one line for the user, naming the face that decides
};

/// Which effects of a scene are simulated.
class Effects {
public:
    bool has(Effect effect) const { return (*this)[effect].on; }
    const Decision& operator[](Effect effect) const { return decisions[static_cast<std::size_t>(effect)]; }
    Decision& operator[](Effect effect) { return decisions[static_cast<std::size_t>(effect)]; }

    /// The channels to solve: all by themselves where colour is forced on, one for all where it is forced off.
    Channels channels() const;

    /// Whether light over specular faces belongs to the solution, not only to the picture.
    bool specularInSolution() const { return has(Effect::specular) && specularOntoDiffuse; }

    Channels neededChannels;
    bool specularOntoDiffuse = false;  ///< faces that mirror throw light on diffuse ones, and so into the solution

private:
    std::array<Decision, allEffects.size()> decisions;
};

/// Finds out which effects a scene calls for, so that the others need not be simulated.
///
/// None is ever off where leaving it out would change the picture; what a face without area emits or reflects
/// counts, too.
///
/// @param mesh  how the scene was cut into patches, or null: then smooth shading counts as needed
/// @cost that of findOcclusion, and a few passes over faces and patches
Effects findEffects(const Scene& scene, const PatchMesh* mesh = nullptr);

/// What a user demands of one effect.
struct Force {
    Effect effect;
    bool on;
};

/// Reads EFFECT=on or EFFECT=off.
///
/// Errors: no such effect, or another value; the message lists what is expected.
Force forceNamed(const std::string& text);

/// Switches an effect on or off against what the scene calls for; warns of what will be missing.
void apply(const Force& force, Effects& effects);

/// "occlusion: …", "no occlusion: …", with "(forced)" where it was.
std::string describe(const Effects& effects, Effect effect);

}  // namespace radlab

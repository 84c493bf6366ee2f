#include "scene/Effects.h"

#include <algorithm>

#include "base/Warning.h"
#include "scene/Occlusion.h"

namespace radlab {

namespace {

struct About {
    const char* name;
    const char* missing;  // from the picture where it is needed and left out
};

constexpr std::array<About, allEffects.size()> about{{{"occlusion", "shadows will be missing"},
                                                      {"indirect", "light reflected more than once will be missing"},
                                                      {"colour", "all channels will be multiples of one"},
                                                      {"specular", "mirror images will be missing"},
                                                      {"transparency", "all faces will be opaque"},
                                                      {"smooth", "each patch will have one colour"},
                                                      {"antialias", "edges will be jagged"}}};

const About& aboutOf(Effect effect) { return about[static_cast<std::size_t>(effect)]; }

Decision found(bool needed, const std::string& reason) { return {needed, needed, false, reason}; }

// The face of which a quantity is largest; null where it is 0 everywhere.
template <class Quantity>
const Face* largest(const Scene& scene, const Quantity& quantity) {
    const Face* best = nullptr;
    float most = 0.0f;
    for (const Face& face : scene.faces) {
        const float value = quantity(*face.material);
        if (value <= most) continue;
        most = value;
        best = &face;
    }
    return best;
}

float largestOf(const Vec3f& color) { return std::max({color.r, color.g, color.b}); }

// 1 for each channel of which some face has anything.
template <class Color>
Vec3f channelsWith(const Scene& scene, const Color& color) {
    Vec3f any(0.0f);
    for (const Face& face : scene.faces)
        for (int c = 0; c < 3; ++c)
            if (color(*face.material)[c] > 0.0f) any[c] = 1.0f;
    return any;
}

Vec3f litChannels(const Scene& scene) {
    return channelsWith(scene, [](const Material& material) { return material.emissive; });
}

std::string withNumber(const char* what, float value) {
    char text[80];
    std::snprintf(text, sizeof text, "%s %.3g", what, double(value));
    return text;
}

Decision findIndirect(const Scene& scene) {
    const Vec3f lit = litChannels(scene);
    if (lit == Vec3f(0.0f)) return found(false, "nothing emits light");
    const auto reflected = [&](const Material& material) {
        return largestOf((material.diffuse + material.specular) * lit);
    };
    const Face* brightest = largest(scene, reflected);
    if (!brightest) return found(false, "no face reflects the light that there is: one pass of shots is exact");
    return found(true, "the face at " + placeOf(*brightest) + " reflects most, " +
                           withNumber("a share of", reflected(*brightest->material)));
}

Channels findChannels(const Scene& scene) {
    std::vector<glm::dvec3> emission, reflectance;
    for (const Face& face : scene.faces) {
        emission.emplace_back(face.material->emissive);
        reflectance.emplace_back(face.material->diffuse);
        emission.emplace_back(0.0);
        reflectance.emplace_back(face.material->specular);
    }
    return channelsOf(emission, reflectance);
}

std::string listOf(const Channels& channels) {
    std::string list;
    for (int c = 0; c < 3; ++c)
        if (channels.solved(c)) list += (list.empty() ? "" : ", ") + std::string(nameOfChannel(c));
    return list;
}

// The face that keeps channels from being one: the most colourful one in the channels that are lit, else a light.
const Face* mostColorful(const Scene& scene) {
    const Vec3f lit = litChannels(scene);
    const auto spread = [=](const Vec3f& color) {
        float low = largestOf(color * lit);
        for (int c = 0; c < 3; ++c)
            if (lit[c] > 0.0f) low = std::min(low, color[c]);
        return largestOf(color * lit) - low;
    };
    const auto reflected = [&](const Material& material) {
        return spread(material.diffuse) + spread(material.specular);
    };
    const Face* face = largest(scene, reflected);
    return face ? face : largest(scene, [&](const Material& material) { return spread(material.emissive); });
}

Decision findColour(const Scene& scene, const Channels& channels) {
    if (channels.count() == 0) return found(false, "all channels are dark, as nothing emits light");
    if (channels.count() == 1)
        return found(false, std::string("one channel (") + listOf(channels) +
                                ") is enough, the others are dark or its multiples");
    return found(true, std::to_string(channels.count()) + " channels (" + listOf(channels) +
                           ") differ, as the face at " + placeOf(*mostColorful(scene)) + " is coloured");
}

Decision findSpecular(const Scene& scene, bool ontoDiffuse) {
    const auto mirrored = [](const Material& material) { return largestOf(material.specular); };
    const Face* brightest = largest(scene, mirrored);
    if (!brightest) return found(false, "no face mirrors");
    return found(true, "the face at " + placeOf(*brightest) + " mirrors " +
                           withNumber("a share of", mirrored(*brightest->material)) +
                           (ontoDiffuse ? ", also onto diffuse faces" : ", but no light onto diffuse faces"));
}

bool throwsLightOntoDiffuse(const Scene& scene) {
    const Vec3f mirrored = channelsWith(scene, [](const Material& material) { return material.specular; });
    const Vec3f diffuse = channelsWith(scene, [](const Material& material) { return material.diffuse; });
    return litChannels(scene) * mirrored * diffuse != Vec3f(0.0f);
}

Decision findTransparency(const Scene& scene) {
    const Face* clearest = largest(scene, [](const Material& material) { return material.transparency; });
    if (!clearest) return found(false, "every face is opaque");
    return found(true, "the face at " + placeOf(*clearest) + " lets " +
                           withNumber("a share of", clearest->material->transparency) + " through");
}

Decision findSmooth(const Scene& scene, const PatchMesh* mesh) {
    if (scene.faces.empty()) return found(false, "there are no faces");
    if (!mesh) return found(true, "the faces may be cut into several patches");
    std::vector<bool> seen(mesh->corners.size(), false);
    for (std::size_t i = 0; i < mesh->patches.size(); ++i)
        for (int k = 0; k < mesh->patches[i].vertices; ++k) {
            const auto vertex = static_cast<std::size_t>(mesh->patches[i].vertex[k]);
            if (seen[vertex])
                return found(true, "the face at " + placeOf(scene.faces[static_cast<std::size_t>(mesh->faceOf[i])]) +
                                       " has patches that share a vertex");
            seen[vertex] = true;
        }
    return found(false, "every face is one patch, joined to no other");
}

Decision findAntialias(const Scene& scene) {
    if (scene.faces.empty()) return found(false, "there are no faces");
    return found(true, "faces have edges, from the one at " + placeOf(scene.faces.front()) +
                           " on; only pixels that differ from their neighbours are sampled again");
}

}  // namespace

Channels Effects::channels() const {
    const Decision& colour = (*this)[Effect::colour];
    if (colour.on == colour.needed) return neededChannels;
    if (colour.on) return {{0, 1, 2}, {1.0, 1.0, 1.0}};
    for (int c = 0; c < 3; ++c)
        if (neededChannels.solved(c)) return {{c, c, c}, {1.0, 1.0, 1.0}};
    return {};
}

const char* nameOf(Effect effect) { return aboutOf(effect).name; }

Effects findEffects(const Scene& scene, const PatchMesh* mesh) {
    Effects effects;
    const Occlusion occlusion = findOcclusion(scene);
    effects.neededChannels = findChannels(scene);
    effects.specularOntoDiffuse = throwsLightOntoDiffuse(scene);
    effects[Effect::occlusion] = found(occlusion.found, occlusion.reason);
    effects[Effect::indirect] = findIndirect(scene);
    effects[Effect::colour] = findColour(scene, effects.neededChannels);
    effects[Effect::specular] = findSpecular(scene, effects.specularOntoDiffuse);
    effects[Effect::transparency] = findTransparency(scene);
    effects[Effect::smooth] = findSmooth(scene, mesh);
    effects[Effect::antialias] = findAntialias(scene);
    return effects;
}

Force forceNamed(const std::string& text) {
    std::string expected;
    for (const Effect effect : allEffects) {
        const std::string name = nameOf(effect);
        if (text == name + "=on") return {effect, true};
        if (text == name + "=off") return {effect, false};
        expected += (expected.empty() ? "" : ", ") + name;
    }
    throw Error("--force: found '" + text + "', expected EFFECT=on or EFFECT=off, EFFECT one of " + expected);
}

void apply(const Force& force, Effects& effects) {
    Decision& decision = effects[force.effect];
    decision.on = force.on;
    decision.forced = true;
    if (decision.needed && !force.on)
        warn(std::string(nameOf(force.effect)) + " is forced off: " + aboutOf(force.effect).missing + ", although " +
             decision.reason);
}

std::string describe(const Effects& effects, Effect effect) {
    const Decision& decision = effects[effect];
    return (decision.on ? "" : "no ") + std::string(nameOf(effect)) + (decision.forced ? " (forced)" : "") + ": " +
           decision.reason;
}

}  // namespace radlab

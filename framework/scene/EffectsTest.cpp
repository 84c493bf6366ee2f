#include "scene/Effects.h"

#include "scene/SceneTestHelp.h"

using namespace radlab;
using namespace radlab::test;

namespace {

const std::string light = withMaterial("diffuseColor='0 0 0' emissiveColor='1 1 1'") + "\n";
const std::string grey = withMaterial("diffuseColor='0.5 0.5 0.5'") + "\n";
const std::string red = withMaterial("diffuseColor='0.5 0.1 0.1'") + "\n";
const std::string black = withMaterial("diffuseColor='0 0 0'") + "\n";

Effects effectsOf(const std::string& nodes) {
    const WarningCapture quiet;  // all in one place
    return findEffects(parse(nodes));
}
Decision decisionOn(Effect effect, const std::string& nodes) { return effectsOf(nodes)[effect]; }

Decision smoothAt(const Scene& scene, float patchSize) {
    const PatchMesh mesh(scene.vertices, scene.faces, patchSize, patchSize);
    return findEffects(scene, &mesh)[Effect::smooth];
}

}  // namespace

TEST_CASE("an empty scene calls for nothing") {
    const Effects effects = findEffects(Scene());
    for (const Effect effect : allEffects) {
        CAPTURE(nameOf(effect));
        CHECK_FALSE(effects.has(effect));
        CHECK_FALSE(effects[effect].reason.empty());
    }
    CHECK(effects.channels().count() == 0);
}

TEST_CASE("light is indirect where it meets something that reflects it") {
    const Decision found = decisionOn(Effect::indirect, light + black + red + grey);
    CHECK(found.on);
    CHECK(found.reason == "the face at scene.x3d:4 reflects most, a share of 0.5");
    CHECK(decisionOn(Effect::indirect, light + withMaterial("diffuseColor='0 0 0' specularColor='0 0.2 0'")).on);
}

TEST_CASE("one pass is exact where nothing reflects the light, or there is none") {
    CHECK(contains(decisionOn(Effect::indirect, light + black).reason, "no face reflects"));
    CHECK(decisionOn(Effect::indirect, grey + red).reason == "nothing emits light");
    CHECK_FALSE(decisionOn(Effect::indirect, withMaterial("diffuseColor='0 0 0' emissiveColor='1 0 0'") +
                                                 withMaterial("diffuseColor='0 0.9 0.9'"))
                    .on);
}

TEST_CASE("a scene of grey faces has one channel, whatever the colour of its light") {
    const std::string warm = withMaterial("diffuseColor='0.2 0.2 0.2' emissiveColor='3 2 1'");
    const Effects effects = effectsOf(warm + grey + black);
    CHECK_FALSE(effects.has(Effect::colour));
    CHECK(effects.channels().count() == 1);
    CHECK(effects[Effect::colour].reason == "one channel (red) is enough, the others are dark or its multiples");
}

TEST_CASE("a coloured face that is lit makes channels differ, and is named") {
    const Decision found = decisionOn(Effect::colour, light + grey + red);
    CHECK(found.on);
    CHECK(found.reason == "2 channels (red, green) differ, as the face at scene.x3d:4 is coloured");
    const Decision mirror = decisionOn(Effect::colour, light + grey + withMaterial("specularColor='0.1 0.2 0.3'"));
    CHECK(mirror.reason == "3 channels (red, green, blue) differ, as the face at scene.x3d:4 is coloured");
}

TEST_CASE("a face that is coloured only in channels without light does not count") {
    const std::string blue = withMaterial("diffuseColor='0 0 0' emissiveColor='0 0 1'");
    CHECK(decisionOn(Effect::colour, blue + red).reason ==
          "one channel (blue) is enough, the others are dark or its multiples");
    CHECK(decisionOn(Effect::colour, red + grey).reason == "all channels are dark, as nothing emits light");
}

TEST_CASE("lights of different colours make channels differ over grey faces") {
    const std::string warm = withMaterial("diffuseColor='0 0 0' emissiveColor='2 1 1'") + "\n";
    const std::string brighter = withMaterial("diffuseColor='0 0 0' emissiveColor='4 2 2'") + "\n";
    CHECK_FALSE(decisionOn(Effect::colour, warm + brighter + grey).on);
    CHECK(decisionOn(Effect::colour, light + warm + grey).reason ==
          "2 channels (red, green) differ, as the face at scene.x3d:3 is coloured");
}

TEST_CASE("mirrors are specular, and throw light on diffuse faces where there are both") {
    const std::string mirror = withMaterial("diffuseColor='0 0 0' specularColor='0 0.9 0'") + "\n";
    const Effects lit = effectsOf(light + grey + mirror);
    CHECK(lit[Effect::specular].on);
    CHECK(lit.specularOntoDiffuse);
    CHECK(lit[Effect::specular].reason == "the face at scene.x3d:4 mirrors a share of 0.9, also onto diffuse faces");
    CHECK(effectsOf(grey + mirror).has(Effect::specular));
    CHECK_FALSE(effectsOf(grey + mirror).specularOntoDiffuse);
    CHECK_FALSE(effectsOf(light + black + mirror).specularOntoDiffuse);
    CHECK_FALSE(effectsOf(light + grey).has(Effect::specular));
    CHECK_FALSE(effectsOf(light + grey).specularOntoDiffuse);
}

TEST_CASE("clear faces are transparent") {
    const Decision found = decisionOn(Effect::transparency, grey + withMaterial("transparency='0.25'"));
    CHECK(found.on);
    CHECK(found.reason == "the face at scene.x3d:3 lets a share of 0.25 through");
    CHECK(decisionOn(Effect::transparency, grey).reason == "every face is opaque");
}

TEST_CASE("shading is smooth where patches share vertices: within a face, or over its bend") {
    const Scene scene = parse(grey);
    CHECK(smoothAt(scene, 0.3f).on);
    CHECK(smoothAt(scene, 0.3f).reason == "the face at scene.x3d:2 has patches that share a vertex");
    CHECK_FALSE(smoothAt(scene, 10.0f).on);
    CHECK(findEffects(scene).has(Effect::smooth));
    const auto bent = [](const std::string& fields) {
        return parse("<Shape><IndexedFaceSet coordIndex='0 1 2 -1 1 0 3 -1' " + fields + ">" +
                     coordinate("0 0 0 1 0 0 0 1 0 0 -1 0.1") + "</IndexedFaceSet></Shape>");
    };
    CHECK_FALSE(smoothAt(bent(""), 10.0f).on);
    CHECK(smoothAt(bent("creaseAngle='1'"), 10.0f).on);
}

TEST_CASE("edges are smoothed wherever there is a face") { CHECK(decisionOn(Effect::antialias, black).on); }

TEST_CASE("a force names an effect and a value, or the message lists what is expected") {
    for (const Effect effect : allEffects) {
        const Force off = forceNamed(std::string(nameOf(effect)) + "=off");
        CHECK(off.effect == effect);
        CHECK_FALSE(off.on);
        CHECK(forceNamed(std::string(nameOf(effect)) + "=on").on);
    }
    for (const char* text : {"", "=", "colour", "colour=", "colour=1", "color=on", "colour=on ", "=on"}) {
        CAPTURE(text);
        const std::string error = errorOf([&] { forceNamed(text); });
        CHECK(contains(error, "found '" + std::string(text) + "'"));
        CHECK(contains(error, "one of occlusion, indirect, colour, specular, transparency, smooth, antialias"));
    }
}

TEST_CASE("what is forced off is warned of only where it is needed") {
    for (const Effect effect : allEffects) {
        CAPTURE(nameOf(effect));
        Effects effects = effectsOf(light + red);
        WarningCapture warnings;
        const bool needed = effects.has(effect);
        apply({effect, true}, effects);
        CHECK(warnings.texts.empty());
        CHECK(effects.has(effect));
        apply({effect, false}, effects);
        CHECK_FALSE(effects.has(effect));
        CHECK(effects[effect].forced);
        CHECK(warnings.texts.size() == (needed ? 1 : 0));
    }
}

TEST_CASE("colour forced on solves every channel, forced off one, and the last word counts") {
    WarningCapture quiet;
    Effects effects = effectsOf(light + red);
    apply({Effect::colour, false}, effects);
    CHECK(effects.channels().count() == 1);
    CHECK(effects.channels().spread({2, 0, 0}) == glm::dvec3(2, 2, 2));
    apply({Effect::colour, true}, effects);
    CHECK(effects.channels().like == effects.neededChannels.like);
    Effects dull = effectsOf(light + grey);
    apply({Effect::colour, true}, dull);
    CHECK(dull.channels().count() == 3);
    Effects unlit = effectsOf(red);
    apply({Effect::colour, false}, unlit);
    CHECK(unlit.channels().count() == 0);
}

TEST_CASE("a decision reads as a line") {
    Effects effects = effectsOf(grey);
    CHECK(describe(effects, Effect::specular) == "no specular: no face mirrors");
    apply({Effect::specular, true}, effects);
    CHECK(describe(effects, Effect::specular) == "specular (forced): no face mirrors");
}

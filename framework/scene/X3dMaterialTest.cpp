#include "scene/X3dMaterial.h"

#include "scene/SceneTestHelp.h"

using namespace radlab;
using namespace radlab::test;

namespace {

Material materialIn(const std::string& fields) { return *parse(withMaterial(fields)).faces[0].material; }

void checkStandard(const Material& material) {
    CHECK(material.diffuse == Vec3f(0.8f));
    CHECK(material.emissive == Vec3f(0.0f));
    CHECK(material.specular == Vec3f(0.0f));
    CHECK(material.shininess == 0.2f);
    CHECK(material.transparency == 0.0f);
}

}  // namespace

TEST_CASE("a Material without fields has X3D's defaults") { checkStandard(materialIn("")); }

TEST_CASE("a Shape without Material or Appearance has the default material") {
    checkStandard(*parse(triangle()).faces[0].material);
    checkStandard(*parse(triangle("", "<Appearance/>")).faces[0].material);
}

TEST_CASE("all fields of a Material are read as they stand, without gamma") {
    const Material material = materialIn(
        "diffuseColor='0.1 0.2 0.3' emissiveColor='17 0 2.5' specularColor='1 0.5 0' "
        "shininess='0.75' transparency='0.25'");
    CHECK(material.diffuse == Vec3f(0.1f, 0.2f, 0.3f));
    CHECK(material.emissive == Vec3f(17, 0, 2.5f));
    CHECK(material.specular == Vec3f(1, 0.5f, 0));
    CHECK(material.shininess == 0.75f);
    CHECK(material.transparency == 0.25f);
}

TEST_CASE("commas and line ends separate values") {
    CHECK(materialIn("diffuseColor='0.1,0.2,\n0.3'").diffuse == Vec3f(0.1f, 0.2f, 0.3f));
}

TEST_CASE("emission may be above 1 but not below 0") {
    CHECK(materialIn("emissiveColor='1000 0 0'").emits());
    CHECK(contains(errorIn(withMaterial("emissiveColor='-1 0 0'")), "found -1, expected 0 or more"));
}

TEST_CASE("reflectances and fractions outside 0 to 1 are an error") {
    CHECK(contains(errorIn(withMaterial("diffuseColor='1.5 0 0'")),
                   "scene.x3d:2: Material: diffuseColor is out of range, found 1.5, expected 0 to 1"));
    CHECK(contains(errorIn(withMaterial("specularColor='0 -0.5 0'")), "specularColor is out of range, found -0.5"));
    CHECK(contains(errorIn(withMaterial("transparency='1.01'")), "transparency is out of range, found 1.01"));
    CHECK(contains(errorIn(withMaterial("shininess='20'")), "shininess is out of range, found 20"));
}

TEST_CASE("a colour takes three finite numbers") {
    CHECK(contains(errorIn(withMaterial("diffuseColor='1 1'")), "has the wrong number of values, found 2"));
    CHECK(contains(errorIn(withMaterial("diffuseColor=''")), "found 0, expected 3"));
    CHECK(contains(errorIn(withMaterial("emissiveColor='inf 0 0'")), "emissiveColor holds what is no number"));
    CHECK(contains(errorIn(withMaterial("emissiveColor='nan 0 0'")), "emissiveColor holds what is no number"));
    CHECK(contains(errorIn(withMaterial("emissiveColor='1e60 0 0'")), "too large"));
    CHECK(contains(errorIn(withMaterial("transparency='0 0'")), "found 2, expected 1"));
}

TEST_CASE("a Material that is used twice is one material") {
    const Scene scene = parse(triangle("", "<Appearance><Material DEF='M' diffuseColor='1 0 0'/></Appearance>") +
                              triangle("", "<Appearance><Material USE='M'/></Appearance>"));
    CHECK(scene.faces[0].material == scene.faces[1].material);
}

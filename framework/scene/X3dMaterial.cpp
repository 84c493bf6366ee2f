#include "scene/X3dMaterial.h"

#include <limits>

namespace radlab {

namespace {

// Its own DEF, or that of the Appearance around it.
std::string nameOf(const X3dNode& node) {
    if (node.has("DEF")) return std::string(node.text("DEF"));
    const tinyxml2::XMLNode* around = node.element()->Parent();
    const tinyxml2::XMLElement* parent = around ? around->ToElement() : nullptr;
    return parent && X3dNode(*parent, node.fileName()).name() == "Appearance"
               ? std::string(X3dNode(*parent, node.fileName()).text("DEF"))
               : "";
}

}  // namespace

Material readMaterial(const X3dNode& node) {
    const Material standard;
    Material material;
    material.diffuse = node.colour("diffuseColor", standard.diffuse, 1.0);
    material.emissive = node.colour("emissiveColor", standard.emissive, std::numeric_limits<double>::infinity());
    material.specular = node.colour("specularColor", standard.specular, 1.0);
    material.shininess = node.fraction("shininess", standard.shininess);
    material.transparency = node.fraction("transparency", standard.transparency);
    material.name = nameOf(node);
    return material;
}

}  // namespace radlab

#include "scene/X3dMaterial.h"

#include <limits>

namespace radlab {

Material readMaterial(const X3dNode& node) {
    const Material standard;
    Material material;
    material.diffuse = node.colour("diffuseColor", standard.diffuse, 1.0);
    material.emissive = node.colour("emissiveColor", standard.emissive, std::numeric_limits<double>::infinity());
    material.specular = node.colour("specularColor", standard.specular, 1.0);
    material.shininess = node.fraction("shininess", standard.shininess);
    material.transparency = node.fraction("transparency", standard.transparency);
    return material;
}

}  // namespace radlab

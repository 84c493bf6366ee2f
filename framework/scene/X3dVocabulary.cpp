#include "scene/X3dVocabulary.h"

#include <algorithm>
#include <array>
#include <string>

namespace radlab {

namespace {

struct Entry {
    std::string_view name;
    X3dKind kind;
    std::string_view fields;  // separated by single spaces
};

constexpr std::string_view fieldsOfAll =
    "DEF USE containerField class id style name metadata bboxCenter bboxSize bboxDisplay";

constexpr std::array<Entry, 29> vocabulary = {{
    {"Scene", X3dKind::group, ""},
    {"Group", X3dKind::group, ""},
    {"StaticGroup", X3dKind::group, ""},
    {"Anchor", X3dKind::group, "url parameter description"},
    {"Collision", X3dKind::group, "enabled collide"},
    {"Transform", X3dKind::group, "translation rotation scale scaleOrientation center"},
    {"Shape", X3dKind::shape, ""},
    {"Appearance", X3dKind::appearance, ""},
    {"Material", X3dKind::material, "diffuseColor emissiveColor specularColor shininess transparency ambientIntensity"},
    {"IndexedFaceSet", X3dKind::geometry,
     "coordIndex ccw solid convex creaseAngle normalPerVertex colorPerVertex texCoordIndex normalIndex colorIndex"},
    {"IndexedTriangleSet", X3dKind::geometry, "index ccw solid normalPerVertex colorPerVertex"},
    {"IndexedQuadSet", X3dKind::geometry, "index ccw solid normalPerVertex colorPerVertex"},
    {"Coordinate", X3dKind::coordinate, "point"},
    {"Viewpoint", X3dKind::viewpoint,
     "position orientation fieldOfView description centerOfRotation jump retainUserOffsets viewAll nearDistance "
     "farDistance zNear zFar"},
    {"Background", X3dKind::background, "skyColor skyAngle groundColor groundAngle transparency"},
    {"NavigationInfo", X3dKind::silent, ""},
    {"WorldInfo", X3dKind::silent, ""},
    {"MetadataBoolean", X3dKind::silent, ""},
    {"MetadataDouble", X3dKind::silent, ""},
    {"MetadataFloat", X3dKind::silent, ""},
    {"MetadataInteger", X3dKind::silent, ""},
    {"MetadataSet", X3dKind::silent, ""},
    {"MetadataString", X3dKind::silent, ""},
    {"Normal", X3dKind::silent, ""},
    {"TextureCoordinate", X3dKind::silent, ""},
    {"MultiTextureCoordinate", X3dKind::silent, ""},
    {"Color", X3dKind::silent, ""},
    {"ColorRGBA", X3dKind::silent, ""},
    {"Tangent", X3dKind::silent, ""},
}};

const Entry* find(std::string_view name) {
    const auto found =
        std::find_if(vocabulary.begin(), vocabulary.end(), [&](const Entry& entry) { return entry.name == name; });
    return found == vocabulary.end() ? nullptr : &*found;
}

bool hasWord(std::string_view words, std::string_view word) {
    for (std::size_t at = 0; at < words.size();) {
        const std::size_t end = std::min(words.find(' ', at), words.size());
        if (words.substr(at, end - at) == word) return true;
        at = end + 1;
    }
    return false;
}

}  // namespace

X3dKind kindOf(std::string_view name) {
    const Entry* entry = find(name);
    return entry ? entry->kind : X3dKind::other;
}

bool isKnownField(std::string_view node, std::string_view field) {
    const Entry* entry = find(node);
    // A prefix marks a field of another vocabulary, such as xsi:schemaLocation.
    if (!entry || entry->kind == X3dKind::silent || field.find(':') != std::string_view::npos) return true;
    return field == "xmlns" || hasWord(fieldsOfAll, field) || hasWord(entry->fields, field);
}

bool belongsBelow(X3dKind child, X3dKind parent) {
    if (child == X3dKind::silent) return true;
    switch (parent) {
        case X3dKind::group:
            return child == X3dKind::group || child == X3dKind::shape || child == X3dKind::viewpoint ||
                   child == X3dKind::background;
        case X3dKind::shape: return child == X3dKind::appearance || child == X3dKind::geometry;
        case X3dKind::appearance: return child == X3dKind::material || child == X3dKind::geometry;
        case X3dKind::geometry: return child == X3dKind::coordinate;
        default: return false;
    }
}

}  // namespace radlab

#pragma once

#include <string_view>

namespace radlab {

/// What the reader does with a node.
enum class X3dKind {
    other,   ///< passed over, and named in the warning
    silent,  ///< passed over without a word: it has no bearing on radiosity
    group,
    shape,
    appearance,
    material,
    geometry,
    coordinate,
    viewpoint,
    background
};

/// The kind of a node by its name without prefix.
X3dKind kindOf(std::string_view name);

/// Whether a field of the node is read, or may be passed over without a word.
bool isKnownField(std::string_view node, std::string_view field);

/// Whether the reader looks for such a child in such a parent.
///
/// Geometry is looked for in an Appearance too, where the course's older files have it.
bool belongsBelow(X3dKind child, X3dKind parent);

}  // namespace radlab

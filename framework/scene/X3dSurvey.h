#pragma once

#include <unordered_map>

#include "scene/Tally.h"
#include "scene/X3dNode.h"
#include "scene/X3dVocabulary.h"

namespace radlab {

/// What one look over a whole file finds out before any of it is read: which node each USE means, and what is
/// going to be passed over.
///
/// Names are matched in the order of the file, so that a USE means the last DEF of its name before it, and a
/// node that is used stands whole before the place that uses it: following USE always comes to an end.
class X3dSurvey {
public:
    /// @throws Error for a USE without a DEF before it, of another kind of node, or of a node that it stands in;
    ///         for a DEF and a USE in one element; for nesting too deep
    /// @cost   one pass over the elements
    explicit X3dSurvey(const X3dNode& scene);

    /// The node that is meant: itself, or the one that its USE names.
    X3dNode resolve(const X3dNode& node) const;

    Tally passedOver;  ///< nodes and fields that the reader does not know
    Tally redefined;   ///< DEF names that are given more than once

private:
    void visit(const X3dNode& node, X3dKind kind, bool isRead, int depth);
    void visitChild(const X3dNode& child, X3dKind parent, bool isRead, int depth);
    void noteName(const X3dNode& node, bool isRead);
    void noteFields(const X3dNode& node, bool isRead);

    std::unordered_map<std::string, const tinyxml2::XMLElement*> definitions;
    std::unordered_map<const tinyxml2::XMLElement*, const tinyxml2::XMLElement*> uses;  // to null where none was found
    const std::string* fileName = nullptr;
};

/// The Coordinate nodes anywhere below a geometry node.
std::vector<X3dNode> coordinatesBelow(const X3dNode& geometry);

}  // namespace radlab

#pragma once

#include <memory>
#include <optional>
#include <string>
#include <unordered_map>

#include "scene/Placement.h"
#include "scene/Scene.h"
#include "scene/X3dGeometry.h"
#include "scene/X3dReader.h"
#include "scene/X3dSurvey.h"

namespace radlab {

/// Walks the nodes of a file with each USE written out, and gathers the scene.
///
/// Each node's fields are read once, however often it is used.
class X3dSceneBuilder {
public:
    X3dSceneBuilder(const X3dSurvey& found, std::string file, const X3dLimits& limitsOfFile);

    /// @throws Error for wrong fields and for more than the limits allow
    Scene build(const X3dNode& root);

    int flattenedFaces() const { return flattened; }

private:
    /// The parts that make up a Shape.
    struct Parts {
        std::optional<X3dNode> appearance, material, geometry;
    };

    template <class Visit>
    void eachChild(const X3dNode& node, Visit visit);

    void addGroup(const X3dNode& group, const Placement& outer, int depth);
    void addNode(const X3dNode& node, const Placement& placement, int depth);
    void addCamera(const X3dNode& viewpoint, const Placement& placement);
    void addBackground(const X3dNode& background);
    void addShape(const X3dNode& shape, const Placement& placement);
    void addFaces(const X3dNode& shape, const Placement& placement, const X3dGeometry& geometry,
                  const std::shared_ptr<const Material>& material);

    void collectParts(const X3dNode& parent, Parts& parts);
    void checkRoom(const X3dNode& shape, const X3dGeometry& geometry) const;

    const Placement& placementOf(const X3dNode& group);
    const X3dGeometry& geometryOf(const X3dNode& node);
    std::shared_ptr<const X3dPoints> pointsOf(const X3dNode& geometry);
    std::shared_ptr<const Material> materialOf(const std::optional<X3dNode>& node);

    template <class Value>
    using PerElement = std::unordered_map<const tinyxml2::XMLElement*, Value>;

    const X3dSurvey& survey;
    const X3dLimits limits;
    Scene scene;
    std::size_t nodes = 0;
    std::size_t corners = 0;
    int flattened = 0;
    bool hasBackground = false;
    PerElement<Placement> placements;
    PerElement<X3dGeometry> geometries;
    PerElement<std::shared_ptr<const X3dPoints>> points;
    PerElement<std::shared_ptr<const Material>> materials;
    std::shared_ptr<const Material> standardMaterial = std::make_shared<const Material>();
};

}  // namespace radlab

#include "scene/X3dSceneBuilder.h"

#include <algorithm>
#include <utility>

#include "base/Interrupts.h"
#include "scene/Number.h"
#include "scene/X3dMaterial.h"
#include "scene/X3dViewpoint.h"
#include "scene/XmlDocument.h"

namespace radlab {

namespace {

constexpr int deepestUse = 200;

bool isWalked(std::string_view name) { return kindOf(name) != X3dKind::other && kindOf(name) != X3dKind::silent; }

[[noreturn]] void failOverLimit(const X3dNode& node, std::size_t limit, const std::string& things) {
    node.fail("the scene is too large once every USE is written out, expected at most " + std::to_string(limit) + " " +
              things);
}

void takeOnly(std::optional<X3dNode>& slot, const X3dNode& node) {
    if (slot)
        node.fail("a second one in the same Shape, expected one (the first is on line " +
                  std::to_string(slot->where().line) + ")");
    slot = node;
}

}  // namespace

X3dSceneBuilder::X3dSceneBuilder(const X3dSurvey& found, std::string file, const X3dLimits& limitsOfFile)
    : survey(found), limits(limitsOfFile) {
    scene.file = std::move(file);
}

Scene X3dSceneBuilder::build(const X3dNode& root) {
    addGroup(root, Placement(), 1);
    return std::move(scene);
}

/// Comments count as nodes too: skipping them takes time, and a group that is used often is walked often.
template <class Visit>
void X3dSceneBuilder::eachChild(const X3dNode& node, Visit visit) {
    for (auto child = node.element()->FirstChild(); child; child = child->NextSibling()) {
        Interrupts::check();
        if (++nodes > limits.nodes) failOverLimit(node, limits.nodes, "nodes");
        const auto element = child->ToElement();
        if (element && isWalked(localName(element->Name()))) visit(survey.resolve(X3dNode(*element, node.fileName())));
    }
}

void X3dSceneBuilder::addGroup(const X3dNode& group, const Placement& outer, int depth) {
    if (depth > deepestUse)
        group.fail("groups are nested too deeply by USE, expected at most " + std::to_string(deepestUse) + " levels");
    const Placement placement = outer * placementOf(group);
    eachChild(group, [&](const X3dNode& child) { addNode(child, placement, depth); });
}

void X3dSceneBuilder::addNode(const X3dNode& node, const Placement& placement, int depth) {
    switch (kindOf(node.name())) {
        case X3dKind::group: return addGroup(node, placement, depth + 1);
        case X3dKind::shape: return addShape(node, placement);
        case X3dKind::viewpoint: return addCamera(node, placement);
        case X3dKind::background: return addBackground(node);
        default: return;
    }
}

void X3dSceneBuilder::addCamera(const X3dNode& viewpoint, const Placement& placement) {
    if (scene.cameras.size() == limits.cameras) failOverLimit(viewpoint, limits.cameras, "viewpoints");
    scene.cameras.push_back(readViewpoint(viewpoint, placement));
}

/// The first one counts, as the one that X3D binds.
void X3dSceneBuilder::addBackground(const X3dNode& background) {
    if (std::exchange(hasBackground, true)) return;
    const auto sky = background.numbers("skyColor");
    if (sky.size() % 3 != 0)
        background.fail("skyColor has " + std::to_string(sky.size()) + " numbers, expected a multiple of 3");
    for (double channel : sky)
        if (channel < 0 || channel > 1)
            background.fail("skyColor is out of range, found " + numberText(channel) + ", expected 0 to 1");
    if (!sky.empty()) scene.background = Vec3f(glm::dvec3(sky[0], sky[1], sky[2]));
}

void X3dSceneBuilder::addShape(const X3dNode& shape, const Placement& placement) {
    Parts parts;
    collectParts(shape, parts);
    if (parts.appearance) collectParts(*parts.appearance, parts);
    const auto material = materialOf(parts.material);
    if (parts.geometry) addFaces(shape, placement, geometryOf(*parts.geometry), material);
}

void X3dSceneBuilder::collectParts(const X3dNode& parent, Parts& parts) {
    const X3dKind parentKind = kindOf(parent.name());
    eachChild(parent, [&](const X3dNode& child) {
        const X3dKind kind = kindOf(child.name());
        if (!belongsBelow(kind, parentKind)) return;
        if (kind == X3dKind::appearance) takeOnly(parts.appearance, child);
        if (kind == X3dKind::material) takeOnly(parts.material, child);
        if (kind == X3dKind::geometry) takeOnly(parts.geometry, child);
    });
}

void X3dSceneBuilder::checkRoom(const X3dNode& shape, const X3dGeometry& geometry) const {
    if (geometry.faces.size() > limits.faces - scene.faces.size()) failOverLimit(shape, limits.faces, "faces");
    if (geometry.corners > limits.corners - corners) failOverLimit(shape, limits.corners, "corners of faces");
    if (geometry.points->size() > limits.vertices - scene.vertices.size())
        failOverLimit(shape, limits.vertices, "vertices");
}

void X3dSceneBuilder::addFaces(const X3dNode& shape, const Placement& placement, const X3dGeometry& geometry,
                               const std::shared_ptr<const Material>& material) {
    if (geometry.faces.empty()) return;
    checkRoom(shape, geometry);
    const int first = static_cast<int>(scene.vertices.size());
    for (const glm::dvec3& point : *geometry.points) {
        scene.vertices.push_back(placed(placement, point));
        if (!isFinite(scene.vertices.back()))
            throw Error(geometry.where, "point " + std::to_string(scene.vertices.size() - 1 - first) +
                                            " (counted from 0) is too far out once the Transforms are applied, "
                                            "expected coordinates of at most 3.4e38");
    }
    corners += geometry.corners;
    for (const auto& local : geometry.faces) {
        Interrupts::check();
        Face face{local, material, geometry.twoSided, geometry.where, geometry.creaseAngle};
        for (int& corner : face.corners) corner += first;
        // Seen in a mirror, counter-clockwise is clockwise.
        if (placement.mirrored) std::reverse(face.corners.begin() + 1, face.corners.end());
        scene.faces.push_back(std::move(face));
    }
}

const Placement& X3dSceneBuilder::placementOf(const X3dNode& group) {
    const auto [entry, isNew] = placements.try_emplace(group.element());
    if (isNew && group.name() == "Transform") entry->second = readTransform(group);
    return entry->second;
}

const X3dGeometry& X3dSceneBuilder::geometryOf(const X3dNode& node) {
    const auto found = geometries.find(node.element());
    if (found != geometries.end()) return found->second;
    const auto& geometry = geometries.emplace(node.element(), readGeometry(node, pointsOf(node))).first->second;
    flattened += geometry.flattened;
    return geometry;
}

std::shared_ptr<const X3dPoints> X3dSceneBuilder::pointsOf(const X3dNode& geometry) {
    const auto found = coordinatesBelow(geometry);
    if (found.empty()) geometry.fail("there is no Coordinate below it, expected one with the points");
    if (found.size() > 1) found[1].fail("a second one below the same geometry, expected one");
    const X3dNode coordinate = survey.resolve(found[0]);
    auto& shared = points[coordinate.element()];
    if (!shared) shared = readCoordinate(coordinate);
    return shared;
}

std::shared_ptr<const Material> X3dSceneBuilder::materialOf(const std::optional<X3dNode>& node) {
    if (!node) return standardMaterial;
    auto& shared = materials[node->element()];
    if (!shared) shared = std::make_shared<const Material>(readMaterial(*node));
    return shared;
}

}  // namespace radlab

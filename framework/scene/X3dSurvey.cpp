#include "scene/X3dSurvey.h"

#include "base/Interrupts.h"
#include "scene/XmlText.h"

namespace radlab {

namespace {

constexpr int deepestNode = 200;

std::string shortName(std::string_view name) {
    const std::string whole = inQuotes(name);
    return whole.substr(1, whole.size() - 2);
}

bool standsIn(const X3dNode& node, const tinyxml2::XMLElement* outer) {
    for (const tinyxml2::XMLNode* at = node.element(); at; at = at->Parent())
        if (at == outer) return true;
    return false;
}

/// The node that a USE means; `target` is the last DEF of its name, or null.
void checkUse(const X3dNode& node, const tinyxml2::XMLElement* target, const std::string& fileName) {
    const std::string use = "USE " + inQuotes(node.text("USE"));
    if (!target) node.fail(use + " names no node, expected a DEF of that name further up in the file");
    const X3dNode meant(*target, fileName);
    const std::string line = std::to_string(meant.where().line);
    if (standsIn(node, target)) node.fail(use + " stands inside the node that it names (line " + line + "), a loop");
    if (meant.name() != node.name())
        node.fail(use + " names another kind of node, found a " + inQuotes(meant.name()) + " (line " + line +
                  "), expected a " + inQuotes(node.name()));
}

void collectCoordinates(const X3dNode& node, std::vector<X3dNode>& found) {
    node.eachChild([&](const X3dNode& child) {
        if (kindOf(child.name()) == X3dKind::coordinate)
            found.push_back(child);
        else
            collectCoordinates(child, found);
    });
}

}  // namespace

std::vector<X3dNode> coordinatesBelow(const X3dNode& geometry) {
    std::vector<X3dNode> found;
    collectCoordinates(geometry, found);
    return found;
}

X3dSurvey::X3dSurvey(const X3dNode& scene) : fileName(&scene.fileName()) { visit(scene, X3dKind::group, true, 1); }

X3dNode X3dSurvey::resolve(const X3dNode& node) const {
    const auto found = uses.find(node.element());
    if (found == uses.end()) return node;
    if (!found->second) node.fail("USE " + inQuotes(node.text("USE")) + " names no node that can be used here");
    return X3dNode(*found->second, *fileName);
}

void X3dSurvey::visit(const X3dNode& node, X3dKind kind, bool isRead, int depth) {
    if (depth > deepestNode)
        node.fail("nodes are nested too deeply, expected at most " + std::to_string(deepestNode) + " levels");
    noteName(node, isRead);
    noteFields(node, isRead);
    node.eachChild([&](const X3dNode& child) { visitChild(child, kind, isRead, depth + 1); });
}

void X3dSurvey::visitChild(const X3dNode& child, X3dKind parent, bool isRead, int depth) {
    Interrupts::check();
    const X3dKind kind = kindOf(child.name());
    // The names in a prototype are its own.
    const bool isPrototype = child.name() == "ProtoDeclare" || child.name() == "ExternProtoDeclare";
    if (!isRead || belongsBelow(kind, parent)) {
        if (!isPrototype) visit(child, kind, isRead && kind != X3dKind::silent, depth);
    } else if (parent == X3dKind::geometry && !coordinatesBelow(child).empty()) {
        visit(child, X3dKind::geometry, true, depth);
    } else {
        passedOver.add(shortName(child.name()));
        if (!isPrototype) visit(child, kind, false, depth);
    }
}

void X3dSurvey::noteName(const X3dNode& node, bool isRead) {
    const std::string name(node.text("DEF"));
    if (node.has("USE")) {
        if (!name.empty() && isRead) node.fail("both a DEF and a USE, expected one of them");
        const auto found = definitions.find(std::string(node.text("USE")));
        const auto target = found == definitions.end() ? nullptr : found->second;
        if (isRead) checkUse(node, target, *fileName);
        const bool usable = target && !standsIn(node, target) && X3dNode(*target, *fileName).name() == node.name();
        uses[node.element()] = usable ? target : nullptr;
    } else if (!name.empty()) {
        const auto [entry, isNew] = definitions.insert_or_assign(name, node.element());
        if (!isNew) redefined.add(shortName(entry->first));
    }
}

void X3dSurvey::noteFields(const X3dNode& node, bool isRead) {
    if (!isRead) return;
    for (auto field = node.element()->FirstAttribute(); field; field = field->Next())
        if (!isKnownField(node.name(), field->Name()))
            passedOver.add(std::string(node.name()) + "." + shortName(field->Name()));
}

}  // namespace radlab

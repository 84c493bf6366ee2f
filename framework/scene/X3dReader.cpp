#include "scene/X3dReader.h"

#include "base/Warning.h"
#include "scene/CoincidentFaces.h"
#include "scene/X3dSceneBuilder.h"
#include "scene/XmlDocument.h"
#include "scene/XmlText.h"

namespace radlab {

namespace {

/// The Scene element, at the root or right below it.
X3dNode findScene(const X3dNode& root) {
    if (root.name() == "Scene") return root;
    const tinyxml2::XMLElement* found = nullptr;
    root.eachChild([&](const X3dNode& child) {
        if (child.name() != "Scene") return;
        if (found) child.fail("a second Scene, expected one in a file");
        found = child.element();
    });
    if (!found) root.fail("there is no Scene in this file, expected one below the X3D element");
    return X3dNode(*found, root.fileName());
}

void warnOf(const X3dSurvey& survey, const std::string& fileName) {
    if (!survey.passedOver.empty()) warn(fileName + ": passed over: " + survey.passedOver.text());
    if (!survey.redefined.empty())
        warn(fileName + ": DEF names given again, a USE takes the last one above it: " + survey.redefined.text());
}

void warnOf(const X3dSceneBuilder& builder, const std::string& fileName) {
    if (builder.flattenedFaces() > 0)
        warn(fileName + ": faces left out, since their repeated corners leave no area: " +
             std::to_string(builder.flattenedFaces()));
}

void warnOfCoincidence(const Scene& scene) {
    const CoincidentFaces found = findCoincidentFaces(scene);
    if (found.count > 0) warn(scene.file + ": " + describe(found, scene));
}

}  // namespace

Scene readX3d(const std::filesystem::path& file) { return parseX3d(readTextFile(file), pathText(file)); }

Scene parseX3d(std::string_view text, const std::string& fileName, const X3dLimits& limits) {
    const XmlDocument document(text, fileName);
    const X3dNode root = findScene(X3dNode(document.root(), document.fileName()));
    const X3dSurvey survey(root);
    X3dSceneBuilder builder(survey, fileName, limits);
    Scene scene = builder.build(root);
    warnOf(survey, fileName);
    warnOf(builder, fileName);
    if (scene.faces.empty()) root.fail("there is not a single face in it, expected something to render");
    warnOfCoincidence(scene);
    return scene;
}

}  // namespace radlab

#pragma once

#include <filesystem>
#include <string>

#include "scene/Scene.h"
#include "viewer/ViewState.h"

namespace radlab {

/// A scene as the viewer first shows it.
struct OpenedScene {
    Scene scene;
    ViewState state;
};

/// Reads a scene, and the settings of the Resource.xml that names it, where it is one.
///
/// Errors: those of the readers.
OpenedScene openedScene(std::filesystem::path file);

/// The file in `folder` that keeps the view of a scene.
std::filesystem::path keptFile(const std::filesystem::path& folder, const std::filesystem::path& scene);

/// NAME-001.png in `folder`, or the next number that is not taken.
std::filesystem::path nextScreenshot(const std::filesystem::path& folder, const std::string& name);

}  // namespace radlab

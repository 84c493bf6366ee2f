#pragma once

#include <filesystem>
#include <string>

#include "scene/Scene.h"

namespace radlab::study {

/// A scene to study.
struct StudyScene {
    std::string name;      ///< the file's, without its ending: letters, digits, _ and -
    std::string contents;  ///< a hash of the file's contents
    Scene scene;
};

/// Errors: those of the reader; a scene in which nothing emits.
StudyScene readStudyScene(const std::filesystem::path& file);

/// "picture_cornell_1.png" and "map_cornell_1_hemisphere.png", in the study's folder.
std::string pictureFile(const std::string& scene);
std::string mapFile(const std::string& scene, const std::string& method);

}  // namespace radlab::study

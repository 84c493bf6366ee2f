#pragma once

#include <filesystem>
#include <vector>

#include "study/StudyRun.h"

namespace radlab::study {

/// A scene that was studied.
struct StudiedScene {
    StudyScene scene;
    SceneReport report;
};

/// Draws the plots of all scenes and writes the page that shows them, index.html.
///
/// Where there is no gnuplot, a warning says so, and the page has tables and pictures only.
///
/// @param folder  of the results, with the pictures that studyScene wrote
/// @return the page
/// Errors: a folder that cannot be written.
std::filesystem::path writeStudy(const std::filesystem::path& folder, const StudyPlan& plan,
                                 const std::vector<StudiedScene>& scenes, const StudyResults& results);

}  // namespace radlab::study

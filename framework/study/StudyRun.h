#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "study/StudyPlan.h"
#include "study/StudyResults.h"
#include "study/StudyScene.h"

namespace radlab::study {

/// What came of a scene, beside its rows.
struct SceneReport {
    std::size_t measured = 0, kept = 0;  ///< settings: measured now, and taken from the results as they were
    std::vector<std::string> notes;      ///< settings that were left out, and why
};

/// Measures what is not in the results yet, setting by setting, and writes pictures beside them.
///
/// Once Interrupts has caught something, the setting at hand is dropped and no other begun.
///
/// @param folder  where pictures go
/// @param openGl  whether a GlContext is current, for the methods that need it
/// Errors: those of writing.
SceneReport studyScene(const StudyScene& scene, const StudyPlan& plan, bool openGl, const std::filesystem::path& folder,
                       StudyResults& results);

}  // namespace radlab::study

#pragma once

#include "grader/apps/CheckFile.h"
#include "grader/report/Terminal.h"

namespace radlab::grader {

/// Judges the first stage that is not right yet, again whenever the file's text changes, until Ctrl-C or until all is right.
///
/// The file is read over and over, so it works on network drives and under WSL, too. A compile error is shown with its line,
/// and under it the last verdict again.
/// @return an exit code: 0 where all is right, 130 after Ctrl-C
/// @pre    there is an Interrupts
int watch(const FileChecker& checker, const ReportOptions& options);

/// The same for one extension, out of its file in the folder.
int watchExtension(const FileChecker& checker, const ManifestStage& extension, const std::filesystem::path& folder,
                   const ReportOptions& options);

}  // namespace radlab::grader

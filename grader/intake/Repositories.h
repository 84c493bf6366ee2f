#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "grader/intake/OpenFile.h"

namespace radlab::grader {

/// What stands before and after the login in the names of a class' repositories.
struct AroundLogin {
    std::string before, after;
};

/// Whether a folder of a class' folder is a repository.
bool isRepository(const std::filesystem::path& folder, const FolderEntry& entry);

/// What the names of the repositories in a downloaded folder begin with, by the folder's own name; empty where it tells
/// nothing.
///
/// "radiosity-submissions" is what gh classroom makes, "cs-radiosity_submissions_2026_11_23_T_08_15_00" what gh teacher
/// does.
std::string beginningToldBy(const std::string& folderName);

/// Where the login stands in the names of repositories, the same for all of them, so that no two get one id.
///
/// The folder's name comes first, then what more than half of the repositories say in their .classroom50.yaml, then
/// what all names begin with. Students write that file: one alone decides nothing, not even for itself.
///
/// @param names  of the repositories
/// @param folder where they lie
/// @return       fits each name and leaves something of it; empty where nothing tells
/// @source Classroom 50's wiki, "CLI Teacher Guide": <classroom>-<assignment>-<login>, earlier <login>-<assignment>
AroundLogin aroundLogin(const std::vector<std::string>& names, const std::filesystem::path& folder);

}  // namespace radlab::grader

#pragma once

#include <sys/stat.h>

#include <filesystem>
#include <string>
#include <vector>

#include "grader/intake/OpenFile.h"

namespace radlab::grader {

/// What one entry of a class' folder says about who handed it in.
struct Piece {
    std::string owner;  ///< the same for all that belongs to one student: any bytes
    std::string id;     ///< what the student's id should look like: any bytes
    std::string name, account;
    bool late = false;
    bool doubtful = false;  ///< may be another student's; left out where there is something else of this one
    std::string upload;     ///< a number that grows with time; may be empty
    std::string original;   ///< what the student called the file; may be empty
    bool isWork = true;     ///< else there is nothing in it to look through
    FolderEntry entry;
};

/// What the entries of a class' folder are, by the layout that more than half of them have.
///
/// @param folder where they lie; its name may tell what repositories are called
std::vector<Piece> piecesOf(const std::vector<FolderEntry>& entries, const std::filesystem::path& folder);

}  // namespace radlab::grader

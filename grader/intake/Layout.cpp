#include "grader/intake/Layout.h"

#include <algorithm>
#include <functional>
#include <optional>

#include "grader/intake/DownloadName.h"

namespace radlab::grader {

namespace {

constexpr std::string_view submissionsFolder = "-submissions";  // of gh classroom clone student-repos

using Read = std::function<std::optional<Piece>(const FolderEntry&)>;

// No two owners are alike: names of entries hold no NUL.
std::string ownerOf(const std::string& name, const std::string& account) { return name + '\0' + account; }

std::optional<Piece> canvasPiece(const FolderEntry& entry) {
    if (S_ISDIR(entry.about.st_mode)) return {};
    const auto read = canvasName(entry.name);
    if (!read) return {};
    Piece piece;
    piece.owner = ownerOf(read->name, read->account);
    piece.id = read->name.empty() ? read->account : read->name + "_" + read->account;
    piece.name = read->name.empty() ? read->account : read->name;
    piece.account = read->account;
    piece.late = read->late;
    piece.doubtful = read->ambiguous;
    piece.upload = read->upload;
    piece.original = read->original;
    piece.isWork = !read->original.empty();
    return piece;
}

std::optional<Piece> moodlePiece(const FolderEntry& entry) {
    const auto read = moodleName(entry.name);
    if (!read) return {};
    Piece piece;
    piece.owner = ownerOf(read->name, read->account);
    piece.id = read->account.empty() ? read->name : read->name + "_" + read->account;
    piece.name = read->name;
    piece.account = read->account.empty() ? read->name : read->account;
    piece.original = read->original;
    piece.isWork = read->holdsFiles;
    return piece;
}

// What repositories are called before the login; empty where nothing tells.
std::string assignmentOf(const std::vector<std::string>& names, const std::string& className) {
    const auto allBegin = [&](const std::string& text) {
        return std::all_of(names.begin(), names.end(), [&](const std::string& name) {
            return name.size() > text.size() && name.rfind(text, 0) == 0;
        });
    };
    const std::size_t rest = className.size() - std::min(className.size(), submissionsFolder.size());
    std::string told = className.substr(0, rest) + "-";
    if (rest > 0 && className.substr(rest) == submissionsFolder && allBegin(told)) return told;
    std::string common = names.size() < 2 ? "" : names.front();
    while (!common.empty() && (common.back() != '-' || !allBegin(common))) common.pop_back();
    return common;
}

Read repositoryReader(const std::vector<FolderEntry>& entries, const std::filesystem::path& folder,
                      const std::string& className) {
    std::vector<std::string> names;
    for (const FolderEntry& entry : entries)
        if (isRepository(folder, entry)) names.push_back(entry.name);
    return [names, assignment = assignmentOf(names, className)](const FolderEntry& entry) -> std::optional<Piece> {
        if (std::find(names.begin(), names.end(), entry.name) == names.end()) return {};
        Piece piece;
        piece.owner = ownerOf(entry.name, "");
        piece.name = entry.name;
        piece.id = piece.account = entry.name.substr(assignment.size());
        return piece;
    };
}

// A folder, an archive or a file a student.
Piece plainPiece(const FolderEntry& entry) {
    Piece piece;
    piece.owner = entry.name;
    piece.name = S_ISDIR(entry.about.st_mode) ? entry.name : withoutEnding(entry.name);
    piece.id = piece.account = piece.name;
    return piece;
}

}  // namespace

bool isRepository(const std::filesystem::path& folder, const FolderEntry& entry) {
    struct stat about = {};
    return S_ISDIR(entry.about.st_mode) && lstat((folder / entry.name / ".git").c_str(), &about) == 0;
}

std::vector<Piece> piecesOf(const std::vector<FolderEntry>& entries, const std::filesystem::path& folder,
                            const std::string& className) {
    const auto isMost = [&](const Read& read) {
        const auto count = std::count_if(entries.begin(), entries.end(),
                                         [&](const FolderEntry& entry) { return read(entry).has_value(); });
        return 2 * static_cast<std::size_t>(count) > entries.size();
    };
    Read layout = [](const FolderEntry&) { return std::nullopt; };
    for (const Read& read : {Read(moodlePiece), Read(canvasPiece), repositoryReader(entries, folder, className)}) {
        if (!isMost(read)) continue;
        layout = read;
        break;
    }
    std::vector<Piece> pieces;
    for (const FolderEntry& entry : entries) {
        const auto read = layout(entry);
        pieces.push_back(read ? *read : plainPiece(entry));
        pieces.back().entry = entry;
    }
    return pieces;
}

}  // namespace radlab::grader

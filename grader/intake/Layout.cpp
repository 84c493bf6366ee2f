#include "grader/intake/Layout.h"

#include <algorithm>
#include <functional>
#include <optional>

#include "grader/intake/DownloadName.h"
#include "grader/intake/Repositories.h"

namespace radlab::grader {

namespace {

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

Read repositoryReader(const std::vector<FolderEntry>& entries, const std::filesystem::path& folder) {
    std::vector<std::string> names;
    for (const FolderEntry& entry : entries)
        if (isRepository(folder, entry)) names.push_back(entry.name);
    return [names, around = aroundLogin(names, folder)](const FolderEntry& entry) -> std::optional<Piece> {
        if (std::find(names.begin(), names.end(), entry.name) == names.end()) return {};
        Piece piece;
        piece.owner = ownerOf(entry.name, "");
        piece.name = entry.name;
        const std::size_t length = entry.name.size() - around.before.size() - around.after.size();
        piece.id = piece.account = entry.name.substr(around.before.size(), length);
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

std::vector<Piece> piecesOf(const std::vector<FolderEntry>& entries, const std::filesystem::path& folder) {
    const auto isMost = [&](const Read& read) {
        const auto count = std::count_if(entries.begin(), entries.end(),
                                         [&](const FolderEntry& entry) { return read(entry).has_value(); });
        return 2 * static_cast<std::size_t>(count) > entries.size();
    };
    Read layout = [](const FolderEntry&) { return std::nullopt; };
    for (const Read& read : {Read(moodlePiece), Read(canvasPiece), repositoryReader(entries, folder)}) {
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

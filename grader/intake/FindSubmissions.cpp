#include <algorithm>
#include <array>
#include <cstdint>
#include <ctime>
#include <map>
#include <tuple>
#include <utility>

#include "base/Error.h"
#include "grader/intake/DownloadName.h"
#include "grader/intake/Layout.h"
#include "grader/intake/Remarks.h"
#include "grader/intake/Repositories.h"
#include "grader/intake/StudentId.h"
#include "grader/intake/Submission.h"

namespace radlab::grader {

namespace {

namespace fs = std::filesystem;

bool isNoSubmission(const std::string& name) {
    const auto names = {"__MACOSX", "Thumbs.db", "desktop.ini", "index.html"};
    return name.front() == '.' || std::find(names.begin(), names.end(), name) != names.end();
}

bool holdsRepositories(const fs::path& folder, const std::vector<FolderEntry>& entries) {
    return std::any_of(entries.begin(), entries.end(),
                       [&](const FolderEntry& entry) { return isRepository(folder, entry); });
}

std::vector<FolderEntry> studentsEntries(const fs::path& folder) {
    try {
        auto entries = entriesOf(openPlace(folder.string()), SIZE_MAX);
        std::erase_if(*entries, [](const FolderEntry& entry) { return isNoSubmission(entry.name); });
        // gh teacher download lays a table of all marks beside the repositories.
        if (holdsRepositories(folder, *entries))
            std::erase_if(*entries, [](const FolderEntry& entry) { return entry.name == "scores.csv"; });
        return std::move(*entries);
    } catch (const NotTaken& reason) {
        throw Error({folder.string()}, reason.what());
    }
}

// gh makes one folder, and the repositories in it.
fs::path folderOfRepositories(const fs::path& folder, const std::vector<FolderEntry>& entries) {
    if (entries.size() != 1 || !S_ISDIR(entries[0].about.st_mode) || beginningToldBy(entries[0].name).empty())
        return folder;
    const fs::path inner = folder / entries[0].name;
    return holdsRepositories(inner, studentsEntries(inner)) ? inner : folder;
}

// "2026-11-23T08:15:00Z"
std::string isoTime(std::time_t time) {
    std::tm parts = {};
    std::array<char, 64> text;
    if (!gmtime_r(&time, &parts)) return "";
    return {text.data(), std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &parts)};
}

// The older one first.
bool isBefore(const Piece& a, const Piece& b) {
    const auto key = [](const Piece& piece) {
        return std::tuple(piece.upload.size(), piece.upload, numberOf(piece.original), piece.entry.about.st_mtime,
                          piece.entry.name);
    };
    return key(a) < key(b);
}

// Why a piece is left out; empty where it is not.
std::string faultOf(const Piece& piece, std::size_t ofThisStudent) {
    std::string kind = refusedKind(piece.entry.about.st_mode);
    if (!kind.empty()) return kind;
    if (!piece.doubtful || ofThisStudent == 1) return "";
    return "its numbers can be read in two ways, as another student's, too: look at it by hand";
}

Submission submissionOf(std::vector<Piece> pieces, const fs::path& folder) {
    std::sort(pieces.begin(), pieces.end(), isBefore);
    Submission submission;
    submission.student.name = pieces.front().name;
    submission.student.account = pieces.front().account;
    std::time_t newest = 0;
    for (const Piece& piece : pieces) {
        const std::string fault = faultOf(piece, pieces.size());
        if (!fault.empty()) {
            submission.student.remarks.push_back(shownName(piece.entry.name) + ": " + fault);
            continue;
        }
        submission.student.late = submission.student.late || piece.late;
        newest = std::max(newest, piece.entry.about.st_mtime);
        submission.student.submitted = isoTime(newest);
        if (piece.isWork) submission.places.push_back(folder / piece.entry.name);
    }
    return submission;
}

void remarkSharedAccounts(std::vector<Submission>& submissions) {
    std::map<std::string, int> owners;
    for (const Submission& submission : submissions) ++owners[submission.student.account];
    for (Submission& submission : submissions)
        if (owners[submission.student.account] > 1)
            submission.student.remarks.push_back("another entry of the class' folder has the account " +
                                                 shownName(submission.student.account) + ", too: look at both by hand");
}

std::vector<Submission> submissionsOf(const std::vector<Piece>& pieces, const fs::path& folder) {
    std::map<std::string, std::vector<Piece>> byOwner;
    for (const Piece& piece : pieces) byOwner[piece.owner].push_back(piece);
    std::vector<IdSource> sources;
    std::vector<Submission> submissions;
    for (auto& [owner, those] : byOwner) {
        sources.push_back({those.front().id, owner});
        submissions.push_back(submissionOf(std::move(those), folder));
    }
    const std::vector<std::string> ids = studentIds(sources);
    for (std::size_t i = 0; i < ids.size(); ++i) submissions[i].student.id = ids[i];
    remarkSharedAccounts(submissions);
    std::sort(submissions.begin(), submissions.end(),
              [](const Submission& a, const Submission& b) { return a.student.id < b.student.id; });
    return submissions;
}

}  // namespace

std::vector<Submission> findSubmissions(const fs::path& folder) {
    std::error_code failure;
    const fs::path real = fs::canonical(folder, failure);
    if (failure || !fs::is_directory(real, failure))
        throw Error({folder.string()}, "no such folder: expected the unpacked download of a class");
    std::vector<FolderEntry> entries = studentsEntries(real);
    const fs::path inner = folderOfRepositories(real, entries);
    if (inner != real) entries = studentsEntries(inner);
    if (entries.empty())
        throw Error({folder.string()}, "no submission: expected a folder, an archive or a file a student");
    return submissionsOf(piecesOf(entries, inner), inner);
}

}  // namespace radlab::grader

#include "grader/intake/Folder.h"

#include <algorithm>
#include <optional>

namespace radlab::grader {

namespace {

struct Found {
    std::string path;
    mode_t mode = 0;
};

class Walk {
public:
    Walk(const OpenFile& folder, const IntakeRules& within)
        : root(folder), rules(within), choice(within), result{Gathered(within), {}} {}

    GatheredFolder run() {
        std::vector<std::string> folders = {""};
        for (std::size_t depth = 0; !folders.empty(); ++depth) {
            if (depth > rules.deepest) {
                remarks().refuse(shownName(folders.front()) + ": more than " + std::to_string(rules.deepest) +
                                 " folders inside one another; what lies there was not looked at");
                break;
            }
            const std::optional<std::vector<Found>> level = entriesIn(folders);
            if (!level) {
                remarks().refuse("more than " + std::to_string(rules.mostEntries) +
                                 " files and folders; nothing at depth " + std::to_string(depth) +
                                 " or deeper was looked at");
                break;
            }
            folders = lookAt(*level);
            if (depth == 0) keepArchives(*level);
        }
        choice.finish(result.gathered);
        return std::move(result);
    }

private:
    Remarks& remarks() { return result.gathered.remarks; }

    // Calls `what`; where it cannot be done, a remark says why.
    template <class What>
    void attempt(const std::string& path, const What& what) {
        try {
            what();
        } catch (const NotTaken& reason) {
            if (path.empty()) throw;
            remarks().refuse(shownName(path) + ": " + reason.what());
        }
    }

    // Sorted by path; nothing where there are too many.
    std::optional<std::vector<Found>> entriesIn(const std::vector<std::string>& folders) {
        std::vector<Found> level;
        bool tooMany = false;
        for (const std::string& folder : folders) {
            attempt(folder, [&] {
                const auto entries = entriesOf(openBelow(root, folder), rules.mostEntries - seen);
                tooMany = !entries;
                if (tooMany) return;
                seen += entries->size();
                const std::string before = folder.empty() ? "" : folder + "/";
                for (const FolderEntry& entry : *entries) level.push_back({before + entry.name, entry.about.st_mode});
            });
            if (tooMany) return {};
        }
        std::sort(level.begin(), level.end(), [](const Found& a, const Found& b) { return a.path < b.path; });
        return level;
    }

    // Takes what is wanted, and returns the folders.
    std::vector<std::string> lookAt(const std::vector<Found>& level) {
        std::vector<std::string> folders;
        for (const Found& found : level) {
            const std::string refused = refusedKind(found.mode);
            if (!refused.empty())
                remarks().refuse(shownName(found.path) + ": " + refused);
            else if (S_ISREG(found.mode))
                lookAtFile(found.path);
            else if (!isPassedOver(lastPart(found.path)))
                folders.push_back(found.path);
        }
        return folders;
    }

    void lookAtFile(const std::string& path) {
        if (!choice.isNamed(path)) return result.gathered.addOther(path);
        if (!choice.wants(path)) return;
        attempt(path, [&] {
            if (bytesRead > rules.mostUnpacked) throw NotTaken("one of too many files of that name");
            Candidate file{path, contentsOf(openBelow(root, path), rules.mostBytes)};
            bytesRead += file.contents.size();
            choice.offer(file);
        });
    }

    void keepArchives(const std::vector<Found>& level) {
        for (const Found& found : level)
            if (S_ISREG(found.mode) && kindOf(found.path) != FileKind::other) result.archives.push_back(found.path);
    }

    const OpenFile& root;
    const IntakeRules& rules;
    Choice choice;
    GatheredFolder result;
    std::size_t seen = 0;       // entries
    std::size_t bytesRead = 0;  // of all that was offered
};

}  // namespace

bool isPassedOver(std::string_view folder) { return folder == ".git" || folder == "__MACOSX"; }

GatheredFolder gatherFolder(const OpenFile& folder, const IntakeRules& rules) { return Walk(folder, rules).run(); }

}  // namespace radlab::grader

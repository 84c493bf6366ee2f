#include "grader/intake/Repositories.h"

#include <algorithm>
#include <map>
#include <optional>
#include <regex>
#include <tuple>

namespace radlab::grader {

namespace {

constexpr std::size_t mostOfIdentity = 4096;  // bytes of a .classroom50.yaml: a few short lines

struct Identity {
    std::string classroom, assignment;
    auto key() const { return std::tie(classroom, assignment); }
    bool operator<(const Identity& other) const { return key() < other.key(); }
};

bool isThere(const std::filesystem::path& file) {
    struct stat about = {};
    return lstat(file.c_str(), &about) == 0;
}

// The value of a line `key: "value"`, as names of repositories have it.
std::string valueOf(const std::string& key, const std::string& yaml) {
    std::smatch parts;
    if (!std::regex_search(yaml, parts, std::regex("(?:^|\n)" + key + ": *[\"']?([0-9A-Za-z._-]+)"))) return "";
    std::string value = parts[1];
    std::transform(value.begin(), value.end(), value.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + ('a' - 'A')) : c; });
    return value;
}

std::optional<Identity> identityOf(const std::filesystem::path& repository) {
    const std::filesystem::path file = repository / ".classroom50.yaml";
    if (!isThere(file)) return {};
    try {
        const std::string yaml = contentsOf(openPlace(file.string()), mostOfIdentity);
        const Identity identity{valueOf("classroom", yaml), valueOf("assignment", yaml)};
        if (!identity.assignment.empty()) return identity;
    } catch (const NotTaken&) {
    }
    return {};
}

// What more than half of several repositories say; nothing where they do not agree.
std::optional<Identity> identityOfMost(const std::vector<std::string>& names, const std::filesystem::path& folder) {
    if (names.size() < 2) return {};
    std::map<Identity, std::size_t> votes;
    for (const std::string& name : names)
        if (const auto identity = identityOf(folder / name)) ++votes[*identity];
    for (const auto& [identity, count] : votes)
        if (2 * count > names.size()) return identity;
    return {};
}

bool fitsAll(const AroundLogin& around, const std::vector<std::string>& names) {
    return std::all_of(names.begin(), names.end(), [&](const std::string& name) {
        return name.size() > around.before.size() + around.after.size() && name.starts_with(around.before) &&
               name.ends_with(around.after);
    });
}

// Up to the last dash before which they are alike.
std::string commonBeginning(const std::vector<std::string>& names) {
    std::string common = names.size() < 2 ? "" : names.front();
    while (!common.empty() && (common.back() != '-' || !fitsAll({common, ""}, names))) common.pop_back();
    return common;
}

}  // namespace

bool isRepository(const std::filesystem::path& folder, const FolderEntry& entry) {
    return S_ISDIR(entry.about.st_mode) && isThere(folder / entry.name / ".git");
}

std::string beginningToldBy(const std::string& folderName) {
    static const std::regex pattern("([\\s\\S]+)(?:-submissions|_submissions_[0-9T_]+)");
    std::smatch parts;
    return std::regex_match(folderName, parts, pattern) ? parts[1].str() + "-" : "";
}

AroundLogin aroundLogin(const std::vector<std::string>& names, const std::filesystem::path& folder) {
    std::vector<AroundLogin> told = {{beginningToldBy(folder.filename().string()), ""}};
    if (const auto identity = identityOfMost(names, folder)) {
        told.push_back({identity->classroom + "-" + identity->assignment + "-", ""});
        told.push_back({"", "-" + identity->assignment});
    }
    for (const AroundLogin& around : told)
        if (!(around.before + around.after).empty() && fitsAll(around, names)) return around;
    return {commonBeginning(names), ""};
}

}  // namespace radlab::grader

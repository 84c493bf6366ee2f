#include "grader/intake/Choice.h"

#include <algorithm>
#include <utility>

namespace radlab::grader {

namespace {

constexpr std::size_t mostOthers = 5;
constexpr const char* homeFolder = "exercises";

}  // namespace

void Gathered::addOther(const std::string& path) {
    if (others.size() < mostOthers)
        others.push_back(path);
    else
        moreOthers = true;
}

std::string_view lastPart(std::string_view path) {
    const std::size_t slash = path.rfind('/');
    return slash == std::string_view::npos ? path : path.substr(slash + 1);
}

Choice::Choice(const IntakeRules& rules) {
    for (const std::string& name : rules.files) all.push_back({name, {}, {}, {}});
}

std::optional<Choice::Rank> Choice::rankOf(const std::string& path, const std::string& wanted) {
    const std::string_view name = lastPart(path);
    const auto match = matchName(name, wanted);
    if (!match) return {};
    const std::string_view folders(path.data(), path.size() - name.size());
    Rank rank;
    rank.match = *match;
    rank.folders = static_cast<std::size_t>(std::count(folders.begin(), folders.end(), '/')) + 1;
    rank.amongExercises = lastPart(folders.substr(0, folders.empty() ? 0 : folders.size() - 1)) == homeFolder;
    if (rank.amongExercises && rank.folders == 2) rank.folders = 0;
    return rank;
}

bool Choice::isNamed(const std::string& path) const {
    return std::any_of(all.begin(), all.end(), [&](const Wanted& wanted) { return rankOf(path, wanted.name); });
}

bool Choice::wants(const std::string& path) const {
    return std::any_of(all.begin(), all.end(), [&](const Wanted& wanted) {
        const auto rank = rankOf(path, wanted.name);
        if (!rank || !wanted.rank || *rank < *wanted.rank) return rank.has_value();
        return !(*wanted.rank < *rank) && wanted.rival.empty();
    });
}

void Choice::offer(const Candidate& file) {
    for (Wanted& wanted : all) {
        const auto rank = rankOf(file.path, wanted.name);
        if (!rank || (wanted.rank && *wanted.rank < *rank)) continue;
        if (!wanted.rank || *rank < *wanted.rank)
            wanted = {wanted.name, rank, file, ""};
        else if (file.contents == wanted.best.contents)
            wanted.best.path = std::min(wanted.best.path, file.path);
        else if (wanted.rival.empty())
            wanted.rival = file.path;
    }
}

void Choice::finish(Gathered& gathered) {
    for (Wanted& wanted : all) {
        if (!wanted.rank) continue;
        const std::string path = shownName(wanted.best.path);
        if (!wanted.rival.empty()) {
            gathered.remarks.refuse(path + " and " + shownName(wanted.rival) +
                                    " differ, and neither comes first: hand in one " + wanted.name);
            continue;
        }
        if (wanted.rank->match.how == NameMatch::How::otherCase)
            gathered.remarks.note(path + " was taken for " + wanted.name + ": spell the name like that");
        gathered.files[wanted.name] = std::move(wanted.best);
    }
}

}  // namespace radlab::grader

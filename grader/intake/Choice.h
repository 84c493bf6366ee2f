#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "grader/intake/DownloadName.h"
#include "grader/intake/Remarks.h"
#include "grader/intake/Submission.h"

namespace radlab::grader {

/// A file of a submission.
struct Candidate {
    std::string path;  ///< in its folder or archive, with '/'
    std::string contents;
};

/// What looking through one folder, archive or file gave.
struct Gathered {
    explicit Gathered(const IntakeRules& rules) : remarks(rules.mostRemarks) {}

    std::map<std::string, Candidate> files;  ///< by name of the rules
    std::vector<std::string> others;         ///< paths of a few files that nobody asked for
    bool moreOthers = false;
    Remarks remarks;

    void addOther(const std::string& path);
};

/// The last part of a path with '/'.
std::string_view lastPart(std::string_view path);

/// Finds the files that the rules name among those of one folder or archive, which come by one by one.
class Choice {
public:
    explicit Choice(const IntakeRules& rules);

    /// Whether a file is called like one that the rules name.
    bool isNamed(const std::string& path) const;
    /// Whether a file is to be offered: none that is better was offered before.
    bool wants(const std::string& path) const;
    void offer(const Candidate& file);

    /// Hands over the best file of each name, and what there is to say about them.
    void finish(Gathered& gathered);

private:
    // Compared one after the other; a smaller one is better.
    struct Rank {
        NameMatch match;
        std::size_t folders = 0;  // that the file lies in, and one more; 0 for exercises/NAME
        bool amongExercises = false;
        auto key() const { return std::tuple(match.how, folders, !amongExercises, -match.number); }
        bool operator<(const Rank& other) const { return key() < other.key(); }
    };
    struct Wanted {
        std::string name;
        std::optional<Rank> rank;  // of the best one
        Candidate best;
        std::string rival;  // a file of the same rank with other contents
    };
    static std::optional<Rank> rankOf(const std::string& path, const std::string& wanted);

    std::vector<Wanted> all;
};

}  // namespace radlab::grader

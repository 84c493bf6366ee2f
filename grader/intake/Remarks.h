#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace radlab::grader {

/// Bytes of a stranger as one line that a person may see: visibleText, with newlines and tabs spelled out, too.
std::string visibleLine(std::string_view bytes);

/// A name out of a submission as it may stand in a remark: visibleLine of its beginning.
std::string shownName(std::string_view name);

/// "a, b" of names; "and more" where not all are given.
std::string shownNames(const std::vector<std::string>& names, bool more = false);

/// One thing to say.
struct Remark {
    std::string text;
    bool refuses = false;  ///< something that may have been handed in as the work was not taken
};

/// What there is to say about a submission.
class Remarks {
public:
    /// @param toKeep remarks that are kept; the rest is counted
    explicit Remarks(std::size_t toKeep);

    /// About something that was taken, or is only told.
    void note(std::string text);
    /// About something that was not taken though it may have been handed in as the work.
    void refuse(std::string text);
    void add(Remark remark);
    /// Takes over those of others, and their count.
    void add(const Remarks& others);
    /// Counts so many that are not told.
    void addUntold(std::size_t count) { left += count; }

    bool refusedAny() const { return refused; }
    const std::vector<Remark>& told() const { return kept; }
    std::size_t untold() const { return left; }
    /// The text of each that was kept; where there were more, a line at the end says how many.
    std::vector<std::string> lines() const;

private:
    std::size_t most;
    std::vector<Remark> kept;
    std::size_t left = 0;  // remarks that were not kept
    bool refused = false;
};

}  // namespace radlab::grader

#include "grader/apps/GradeSummary.h"

#include <cstdio>
#include <sstream>

#include "grader/report/Wording.h"

namespace radlab::grader {

namespace {

constexpr std::size_t mostNames = 5;

struct Overall {
    std::size_t marks = 0;
    double score = 0.0, maxScore = 0.0;
    std::vector<std::string> refused, errors;
};

Overall overallOf(const std::vector<Submission>& submissions, const StoreReader& store) {
    Overall all;
    for (const Submission& submission : submissions) {
        const std::optional<StudentResult> found = store.find(submission.student.id);
        if (!found) continue;
        if (found->outcome == Outcome::refused) all.refused.push_back(submission.student.id);
        if (found->outcome == Outcome::error) all.errors.push_back(submission.student.id);
        if (found->outcome != Outcome::graded) continue;
        ++all.marks;
        all.score += found->result.score;
        all.maxScore = std::max(all.maxScore, found->result.maxScore);
    }
    return all;
}

std::string listed(const std::vector<std::string>& ids) {
    std::string text;
    for (std::size_t i = 0; i < std::min(ids.size(), mostNames); ++i) text += (i > 0 ? ", " : "") + ids[i];
    return ids.size() > mostNames ? text + " and " + std::to_string(ids.size() - mostNames) + " more" : text;
}

}  // namespace

std::string classSummary(const ClassCounts& counts, const std::vector<Submission>& submissions,
                         const StoreReader& store) {
    const Overall all = overallOf(submissions, store);
    std::ostringstream text;
    text << "graded: " << counts.graded + counts.kept << ", of which the store had " << counts.kept << "\n";
    if (counts.nothing > 0) text << "nothing handed in: " << counts.nothing << "\n";
    if (counts.refused > 0) text << "refused: " << counts.refused << " (" << listed(all.refused) << ")\n";
    if (counts.errors > 0) text << "errors: " << counts.errors << " (" << listed(all.errors) << ")\n";
    if (all.marks > 0) {
        char mean[32];
        std::snprintf(mean, sizeof mean, "%.1f", all.score / static_cast<double>(all.marks));
        text << "mean: " << mean << " of " << marksText(all.maxScore) << " (" << all.marks << " students)\n";
    }
    const std::filesystem::path page = store.path().parent_path() / "grades" / "index.html";
    if (std::filesystem::exists(page)) text << "page: " << page.string() << "\n";
    if (counts.errors > 0)
        text << "next: the same command tries the errors again, which are the grader's or this machine's\n";
    return text.str();
}

}  // namespace radlab::grader

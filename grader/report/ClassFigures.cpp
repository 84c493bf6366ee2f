#include "grader/report/ClassFigures.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "grader/report/Wording.h"

namespace radlab::grader {

namespace {

double medianOf(std::vector<double> scores) {
    if (scores.empty()) return 0.0;
    std::sort(scores.begin(), scores.end());
    const std::size_t middle = scores.size() / 2;
    return scores.size() % 2 == 1 ? scores[middle] : 0.5 * (scores[middle - 1] + scores[middle]);
}

// Adds up the results of a class, one student after the other.
class Sum {
public:
    void add(std::size_t number, const StudentResult& student) {
        ++figures.students;
        ++figures.outcomes[outcomeWord(student)];
        if (student.student.late) ++figures.late;
        if (!hasMark(student)) return;
        figures.scores.push_back(student.result.score);
        figures.maxScore = std::max(figures.maxScore, student.result.maxScore);
        for (const StageResult& stage : student.result.stages)
            if (stage.status != Status::skipped) addStage(number, stage);
    }

    ClassFigures result() {
        figures.mean = meanOf(figures.scores);
        figures.median = medianOf(figures.scores);
        for (auto& [number, stage] : stages) figures.stages.push_back(std::move(stage));
        for (auto& [key, misconception] : misconceptions) figures.misconceptions.push_back(std::move(misconception));
        std::stable_sort(figures.misconceptions.begin(), figures.misconceptions.end(),
                         [](const Misconception& one, const Misconception& other) {
                             return one.students.size() > other.students.size();
                         });
        return std::move(figures);
    }

private:
    void addStage(std::size_t number, const StageResult& stage) {
        StageFigures& sum = stages[{stage.number, stage.stage}];
        sum.number = stage.number;
        sum.stage = stage.stage;
        sum.maxScore = std::max(sum.maxScore, stage.maxScore);
        sum.scores.push_back(stage.score);
        if (stage.status == Status::pass) ++sum.passed;
        if (stage.status == Status::notStarted) ++sum.notStarted;
        for (const CheckResult& check : stage.checks) addCheck(number, sum, check);
    }

    void addCheck(std::size_t number, StageFigures& stage, const CheckResult& check) {
        if (check.status != Status::pass && check.status != Status::fail) return;
        CheckFigures& sum = checkOf(stage, check);
        ++sum.judged;
        if (check.status == Status::pass) ++sum.passed;
        if (check.status == Status::fail && check.diagnosis) addDiagnosis(number, stage, *check.diagnosis);
    }

    static CheckFigures& checkOf(StageFigures& stage, const CheckResult& check) {
        const auto found = std::find_if(stage.checks.begin(), stage.checks.end(),
                                        [&](const CheckFigures& other) { return other.id == check.id; });
        if (found != stage.checks.end()) return *found;
        return stage.checks.emplace_back(CheckFigures{check.id, check.name});
    }

    void addDiagnosis(std::size_t number, const StageFigures& stage, const Diagnosis& diagnosis) {
        Misconception& misconception = misconceptions[{stage.number, stage.stage, diagnosis.id}];
        misconception.stage = stage.stage;
        misconception.diagnosis = diagnosis;
        // One mistake may fail several checks of a student, who come one after the other.
        if (misconception.students.empty() || misconception.students.back() != number)
            misconception.students.push_back(number);
    }

    ClassFigures figures;
    std::map<std::pair<int, std::string>, StageFigures> stages;
    std::map<std::tuple<int, std::string, std::string>, Misconception> misconceptions;
};

}  // namespace

ClassFigures figuresOf(const std::vector<StudentResult>& results) {
    Sum sum;
    for (std::size_t number = 0; number < results.size(); ++number) sum.add(number, results[number]);
    return sum.result();
}

double meanOf(const std::vector<double>& scores) {
    if (scores.empty()) return 0.0;
    return std::accumulate(scores.begin(), scores.end(), 0.0) / static_cast<double>(scores.size());
}

}  // namespace radlab::grader

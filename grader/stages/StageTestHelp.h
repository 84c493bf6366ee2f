#pragma once

// For tests of stages: what a worker would answer, were a computation the submission.

#include <doctest/doctest.h>

#include "base/Error.h"
#include "grader/stages/Verdict.h"

namespace radlab::grader {

/// What a submission does beside its outcome in a step: the calls of its hemicube.
using Calls = std::function<std::vector<HemicubeCall>(const State& before, const Step& step)>;

inline std::vector<HemicubeCall> noCalls(const State&, const Step&) { return {}; }

inline StepAnswer answerOf(const Step& step, const Outcome& outcome, std::vector<HemicubeCall> calls) {
    StepAnswer answer;
    answer.stop = outcome.stop;
    answer.returned = outcome.returned;
    answer.state = outcome.state;
    answer.calls = std::move(calls);
    if (step.inFloats)
        for (std::size_t i = 0; i + 2 < outcome.pixels.size(); i += 3)
            answer.picture.emplace_back(outcome.pixels[i], outcome.pixels[i + 1], outcome.pixels[i + 2]);
    for (const double pixel : outcome.pixels) {
        if (step.inFloats) break;
        const auto id = static_cast<std::uint32_t>(pixel);
        for (const int bits : {16, 8, 0}) answer.pixels.push_back(static_cast<std::uint8_t>(id >> bits));
    }
    return answer;
}

/// The steps of a case, done by a computation, as the records that a worker writes.
inline std::string recordsOf(const Case& asked, const Computation& computation, const Calls& calls, std::size_t first) {
    std::string records;
    State left;
    std::vector<Situation> situations;
    std::vector<State> found(asked.steps.size());
    std::vector<StepAnswer> answers(asked.steps.size());
    situations.reserve(asked.steps.size());
    for (std::size_t i = 0; i < asked.steps.size(); ++i) {
        const Step& step = asked.steps[i];
        found[i] = step.state ? *step.state : left;
        for (std::size_t k = 0; k < step.unshot.size(); ++k) found[i].patches[k].unshot_rad = step.unshot[k];
        answers[i].state = found[i];
        answers[i].calls = calls(found[i], step);
        situations.push_back({found[i], step, answers[i], i ? &situations.back() : nullptr});
        const Outcome outcome = computation(situations.back());
        records += toRecord(answerOf(step, outcome, answers[i].calls), 0, first + i, step.wanted);
        left = outcome.stop.kind == Stop::Kind::none ? outcome.state : found[i];
    }
    return records;
}

/// The runs of all checks, were the computation the submission; through the bytes that travel.
inline std::vector<CheckRun> runsOf(const std::vector<Check>& checks, const Computation& computation,
                                    const Calls& calls = noCalls) {
    std::vector<CheckRun> runs;
    for (const Check& check : checks) {
        std::vector<Step> steps;
        std::string records;
        for (const Case& asked : check.cases) {
            records += recordsOf(asked, computation, calls, steps.size());
            steps.insert(steps.end(), asked.steps.begin(), asked.steps.end());
        }
        runs.push_back({answersFromRecords(records, 0, steps), ""});
        RADLAB_CHECK(runs.back().answers.size() == steps.size());
    }
    return runs;
}

template <class Item>
std::vector<const Item*> pointersTo(const std::vector<Item>& items) {
    std::vector<const Item*> pointers;
    for (const Item& item : items) pointers.push_back(&item);
    return pointers;
}

/// The same as judge, of lists that own what is in them.
inline StageVerdict judgeAll(const Stage& stage, const std::vector<Check>& checks, const std::vector<CheckRun>& runs) {
    return judge(stage, pointersTo(checks), pointersTo(runs));
}

inline StageVerdict judged(const Stage& stage, std::uint64_t seed, const Computation& computation,
                           const Calls& calls = noCalls) {
    const std::vector<Check> checks = stage.checks(seed);
    return judgeAll(stage, checks, runsOf(checks, computation, calls));
}

/// The first message of a check that did not pass; empty where all did.
inline std::string firstFailure(const StageVerdict& verdict) {
    for (const CheckVerdict& check : verdict.checks)
        if (check.status != Status::pass) return check.message;
    return "";
}

/// The ids of the checks that did not pass.
inline std::vector<std::string> failedChecks(const Stage& stage, std::uint64_t seed, const Computation& computation,
                                             const Calls& calls = noCalls) {
    const std::vector<Check> checks = stage.checks(seed);
    const StageVerdict verdict = judgeAll(stage, checks, runsOf(checks, computation, calls));
    std::vector<std::string> failed;
    for (std::size_t i = 0; i < checks.size(); ++i)
        if (verdict.checks[i].status != Status::pass) failed.push_back(checks[i].id);
    return failed;
}

/// A stage that takes one computation for right and knows no mistakes.
class Only : public Stage {
public:
    Only(const Stage& whole, Computation one) : stage(whole), computation(std::move(one)) {}

    std::string function() const override { return stage.function(); }
    std::vector<Check> checks(std::uint64_t seed) const override { return stage.checks(seed); }
    std::vector<Computation> right() const override { return {computation}; }
    Numbers numbers(const Step& step, const State& before, const Outcome& outcome) const override {
        return stage.numbers(step, before, outcome);
    }
    std::string name(const Step& step, std::size_t k) const override { return stage.name(step, k); }
    std::string tolerance() const override { return stage.tolerance(); }
    std::vector<Mistake> mistakes() const override { return {}; }
    std::vector<std::string> inputs() const override { return stage.inputs(); }

private:
    const Stage& stage;
    Computation computation;
};

inline void checkRightWaysPass(const Stage& stage, int seeds, const Calls& calls = noCalls) {
    const std::vector<Computation> ways = stage.right();
    for (int seed = 1; seed <= seeds; ++seed)
        for (std::size_t way = 0; way < ways.size(); ++way) {
            CAPTURE(seed);
            CAPTURE(way);
            CHECK(firstFailure(judged(stage, static_cast<std::uint64_t>(seed), ways[way], calls)) == "");
        }
}

/// Every mistake loses a check, and gets its own name.
inline void checkMistakesAreNamed(const Stage& stage, int seeds, const Calls& calls = noCalls) {
    const std::vector<Mistake> mistakes = stage.mistakes();
    for (int seed = 1; seed <= seeds; ++seed)
        for (std::size_t m = 0; m < mistakes.size(); ++m) {
            const StageVerdict verdict =
                judged(stage, static_cast<std::uint64_t>(seed), mistakes[m].computation, calls);
            CAPTURE(seed);
            CAPTURE(m);
            CAPTURE(mistakes[m].text);
            CHECK(firstFailure(verdict) != "");
            CHECK((verdict.diagnosis ? verdict.diagnosis->id : "") == mistakes[m].id);
        }
}

/// Whether the runs differ from a computation in any check.
inline bool differ(const Stage& stage, const Computation& computation, const std::vector<Check>& checks,
                   const std::vector<CheckRun>& runs) {
    const Only only(stage, computation);
    for (std::size_t i = 0; i < checks.size(); ++i)
        if (!firstFailure(judge(only, {&checks[i]}, {&runs[i]})).empty()) return true;
    return false;
}

/// No two mistakes give the same numbers in all cases: else the second is never named.
inline void checkMistakesDiffer(const Stage& stage, std::uint64_t seed, const Calls& calls = noCalls) {
    const std::vector<Mistake> mistakes = stage.mistakes();
    const std::vector<Check> checks = stage.checks(seed);
    std::vector<std::vector<CheckRun>> runs;
    for (const Mistake& mistake : mistakes) runs.push_back(runsOf(checks, mistake.computation, calls));
    for (std::size_t second = 1; second < mistakes.size(); ++second)
        for (std::size_t first = 0; first < second; ++first) {
            CAPTURE(first);
            CAPTURE(mistakes[first].text);
            CAPTURE(second);
            CAPTURE(mistakes[second].text);
            CHECK(differ(stage, mistakes[first].computation, checks, runs[second]));
        }
}

/// Ids, texts and hints are there, and end as sentences.
inline void checkWording(const Stage& stage) {
    for (const Mistake& mistake : stage.mistakes()) {
        CAPTURE(mistake.id);
        CAPTURE(mistake.text);
        CAPTURE(mistake.hint);
        CHECK(mistake.id.find_first_not_of("abcdefghijklmnopqrstuvwxyz-0123456789") == std::string::npos);
        CHECK(mistake.text.back() == '.');
        CHECK((mistake.hint.back() == '.' || mistake.hint.back() == '?'));
        CHECK(mistake.text.size() < 400);
    }
}

}  // namespace radlab::grader

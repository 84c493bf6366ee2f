#include "grader/stages/Verdict.h"

#include <algorithm>
#include <cmath>
#include <list>

#include "base/Error.h"
#include "grader/stages/CaseText.h"

namespace radlab::grader {

namespace {

// A case with the answers that belong to it, which may end before its last step.
struct Answered {
    const Case* asked = nullptr;
    std::size_t check = 0;
    std::vector<const StepAnswer*> answers;

    bool complete() const {
        return answers.size() == asked->steps.size() || (!answers.empty() && stopped(*answers.back()));
    }
    static bool stopped(const StepAnswer& answer) { return answer.stop.kind != Stop::Kind::none; }
};

std::vector<Answered> casesOf(const std::vector<const Check*>& checks, const std::vector<const CheckRun*>& runs) {
    std::vector<Answered> all;
    for (std::size_t c = 0; c < checks.size(); ++c) {
        auto next = runs[c]->answers.begin();
        for (const Case& asked : checks[c]->cases) {
            Answered answered{&asked, c, {}};
            for (std::size_t i = 0; i < asked.steps.size() && next != runs[c]->answers.end(); ++i, ++next)
                if (answered.answers.empty() || !Answered::stopped(*answered.answers.back()))
                    answered.answers.push_back(&*next);
            all.push_back(answered);
        }
    }
    return all;
}

State prepared(const Step& step, const State* left) {
    State state = step.state ? *step.state : *left;
    for (std::size_t i = 0; i < step.unshot.size(); ++i) state.patches[i].unshot_rad = step.unshot[i];
    return state;
}

Outcome foundIn(const StepAnswer& answer) {
    Outcome outcome;
    outcome.state = answer.state;
    outcome.returned = answer.returned;
    outcome.stop = answer.stop;
    outcome.pixels.reserve(answer.pixels.size() / 3);
    for (std::size_t i = 0; i + 2 < answer.pixels.size(); i += 3)
        outcome.pixels.push_back(answer.pixels[i] * 65536.0 + answer.pixels[i + 1] * 256.0 + answer.pixels[i + 2]);
    for (const Vec3f& pixel : answer.picture)
        for (int channel = 0; channel < 3; ++channel) outcome.pixels.push_back(static_cast<double>(pixel[channel]));
    return outcome;
}

// One step of a submission and of a computation.
struct StepPair {
    Outcome found;
    Outcome computed;
    State before;  // as the computation found it
};

// Goes through a case step by step until visit returns false.
template <class Visit>
void follow(const Answered& answered, const Computation& computation, const Visit& visit) {
    std::list<Situation> situations;
    std::list<StepPair> pairs;
    for (std::size_t i = 0; i < answered.answers.size(); ++i) {
        const Step& step = answered.asked->steps[i];
        StepPair& pair = pairs.emplace_back();
        pair.before = prepared(step, i ? &std::prev(pairs.end(), 2)->computed.state : nullptr);
        pair.found = foundIn(*answered.answers[i]);
        situations.push_back({pair.before, step, *answered.answers[i], i ? &situations.back() : nullptr});
        pair.computed = computation(situations.back());
        if (!visit(i, pair)) return;
        pair.found = {};  // the next step needs what was computed alone
    }
}

// Where a submission first differs from a computation.
struct Difference {
    bool any = false;
    std::size_t step = 0, value = 0;
    double found = 0.0, expected = 0.0, slack = 0.0;
    const Stop* stop = nullptr;  // where one of the two stops and the other does not
};

bool sameStop(const Stop& found, const Stop& computed) {
    return found.kind == computed.kind && found.text.find(computed.text) != std::string::npos;
}

Difference compare(const Stage& stage, const Answered& answered, const Computation& computation) {
    Difference difference;
    follow(answered, computation, [&](std::size_t i, const StepPair& pair) {
        const Step& step = answered.asked->steps[i];
        const Stop &found = answered.answers[i]->stop, &computed = pair.computed.stop;
        if (found.kind != Stop::Kind::none || computed.kind != Stop::Kind::none) {
            if (!sameStop(found, computed)) difference = {true, i, 0, 0.0, 0.0, 0.0, &answered.answers[i]->stop};
            return false;
        }
        const Numbers is = stage.numbers(step, pair.before, pair.found);
        const Numbers wanted = stage.numbers(step, pair.before, pair.computed);
        RADLAB_CHECK(is.values.size() == wanted.values.size());
        for (std::size_t k = 0; k < wanted.values.size() && !difference.any; ++k)
            if (!agrees(is.values[k], wanted.values[k], wanted.slack[k]))
                difference = {true, i, k, is.values[k], wanted.values[k], wanted.slack[k], nullptr};
        return !difference.any;
    });
    return difference;
}

std::vector<Difference> compareAll(const Stage& stage, const std::vector<Answered>& cases, const Computation& right) {
    std::vector<Difference> differences;
    for (const Answered& answered : cases) differences.push_back(compare(stage, answered, right));
    return differences;
}

std::size_t countWrong(const std::vector<Difference>& differences) {
    return static_cast<std::size_t>(
        std::count_if(differences.begin(), differences.end(), [](const Difference& d) { return d.any; }));
}

std::string differenceText(const Stage& stage, const Answered& answered, const Difference& difference) {
    const std::string where = "in the case '" + answered.asked->what + "': ";
    if (difference.stop) return where + stopText(stage.function(), *difference.stop);
    const Step& step = answered.asked->steps[difference.step];
    const std::string call =
        answered.asked->steps.size() > 1 ? "after call " + std::to_string(difference.step + 1) + " " : "";
    return where + call + stage.name(step, difference.value) + " is " +
           stage.show(step, difference.value, difference.found) + ", expected " +
           stage.show(step, difference.value, difference.expected) + " (tolerance: " + stage.tolerance() + ")";
}

bool isStub(const Stage& stage, const StepAnswer& answer) {
    return answer.stop.kind == Stop::Kind::notImplemented && answer.stop.text == stage.function();
}

CheckVerdict verdictOf(const Stage& stage, std::size_t check, const CheckRun& run, const std::vector<Answered>& cases,
                       const std::vector<Difference>& differences) {
    if (!run.answers.empty() && run.answers.back().stop.kind == Stop::Kind::machine)
        return {Status::error, stopText(stage.function(), run.answers.back().stop)};
    if (!run.answers.empty() && isStub(stage, run.answers.front()))
        return {Status::notStarted, stage.function() + " is not written yet"};
    for (std::size_t i = 0; i < cases.size(); ++i)
        if (cases[i].check == check && differences[i].any)
            return {Status::fail, differenceText(stage, cases[i], differences[i])};
    if (!run.cause.empty()) {
        for (const Answered& answered : cases)
            if (answered.check == check && !answered.complete())
                return {Status::fail, "in the case '" + answered.asked->what + "': " + run.cause};
        return {Status::fail, run.cause};
    }
    return {};
}

bool explains(const Stage& stage, const Computation& computation, const std::vector<Answered>& cases,
              const std::vector<Difference>& differences) {
    // The failing cases first: they tell a wrong guess soonest.
    for (const bool failing : {true, false})
        for (std::size_t i = 0; i < cases.size(); ++i)
            if (differences[i].any == failing && compare(stage, cases[i], computation).any) return false;
    return true;
}

std::optional<Diagnosis> fitted(const Stage& stage, const std::vector<Answered>& cases, const Computation& right) {
    struct Kept {
        State before;
        const Step* step;
        Numbers found, expected;
    };
    std::list<Kept> kept;
    for (const Answered& answered : cases)
        follow(answered, right, [&](std::size_t i, const StepPair& pair) {
            const Step& step = answered.asked->steps[i];
            if (answered.answers[i]->stop.kind != Stop::Kind::none || answered.asked->steps.size() > 1) return false;
            kept.push_back({pair.before, &step, stage.numbers(step, pair.before, pair.found),
                            stage.numbers(step, pair.before, pair.computed)});
            return true;
        });
    std::vector<Comparison> comparisons;
    for (const Kept& one : kept) comparisons.push_back({one.before, *one.step, one.found, one.expected});
    return stage.fit(comparisons);
}

std::optional<Diagnosis> diagnose(const Stage& stage, const std::vector<Answered>& cases,
                                  const std::vector<Difference>& differences, const Computation& right) {
    for (const Mistake& mistake : stage.mistakes())
        if (explains(stage, mistake.computation, cases, differences))
            return Diagnosis{mistake.id, mistake.text, mistake.hint};
    return fitted(stage, cases, right);
}

// The failing case with the fewest patches, in its first failing step.
std::string smallestExample(const Stage& stage, const std::vector<Answered>& cases,
                            const std::vector<Difference>& differences, const Computation& right) {
    std::size_t smallest = cases.size();
    const auto size = [&](std::size_t i) { return cases[i].asked->steps[0].state->patches.size(); };
    for (std::size_t i = 0; i < cases.size(); ++i)
        if (differences[i].any && !differences[i].stop && (smallest == cases.size() || size(i) < size(smallest)))
            smallest = i;
    if (smallest == cases.size()) return "";
    std::string text;
    const Difference& difference = differences[smallest];
    follow(cases[smallest], right, [&](std::size_t i, const StepPair& pair) {
        if (i < difference.step) return true;
        text = caseAsCode(stage, *cases[smallest].asked, i, pair.before, difference.value, difference.found,
                          difference.expected);
        return false;
    });
    return text;
}

}  // namespace

std::string stopText(const std::string& function, const Stop& stop) {
    switch (stop.kind) {
        case Stop::Kind::none: return function + " returned, where it should have stopped";
        case Stop::Kind::notImplemented: return stop.text + " is not written yet";
        case Stop::Kind::missing:
            return "the file has no function " + function + " with the parameters that the course's header declares";
        case Stop::Kind::load: return "the compiled file cannot be loaded: " + stop.text;
        case Stop::Kind::error: return function + " was stopped by the framework: " + stop.text;
        case Stop::Kind::exception: return function + " ended with an exception: " + stop.text;
        case Stop::Kind::machine: return "the worker failed: " + stop.text;
    }
    return "";
}

bool agrees(double found, double expected, double slack) {
    if (std::isinf(slack)) return true;
    if (!std::isfinite(found) || !std::isfinite(expected))
        return (std::isnan(found) && std::isnan(expected)) || found == expected;
    return std::abs(found - expected) <= slack;
}

StageVerdict judge(const Stage& stage, const std::vector<const Check*>& checks,
                   const std::vector<const CheckRun*>& runs) {
    RADLAB_CHECK(checks.size() == runs.size());
    const std::vector<Answered> cases = casesOf(checks, runs);
    const std::vector<Computation> ways = stage.right();
    const Computation* way = &ways.front();
    std::vector<Difference> differences = compareAll(stage, cases, *way);
    for (std::size_t i = 1; i < ways.size() && countWrong(differences) > 0; ++i) {
        const std::vector<Difference> other = compareAll(stage, cases, ways[i]);
        if (countWrong(other) >= countWrong(differences)) continue;
        differences = other;
        way = &ways[i];
    }
    StageVerdict verdict;
    for (std::size_t c = 0; c < checks.size(); ++c)
        verdict.checks.push_back(verdictOf(stage, c, *runs[c], cases, differences));
    const bool started = std::any_of(verdict.checks.begin(), verdict.checks.end(),
                                     [](const CheckVerdict& c) { return c.status != Status::notStarted; });
    if (!started || countWrong(differences) == 0) return verdict;
    verdict.diagnosis = diagnose(stage, cases, differences, *way);
    if (!verdict.diagnosis) verdict.example = smallestExample(stage, cases, differences, *way);
    return verdict;
}

}  // namespace radlab::grader

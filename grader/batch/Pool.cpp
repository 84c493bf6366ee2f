#include "grader/batch/Pool.h"

#include <poll.h>

#include <deque>
#include <list>
#include <vector>

#include "base/Error.h"
#include "base/Interrupts.h"
#include "grader/batch/JobProcess.h"

namespace radlab::grader {

namespace {

constexpr int pollMilliseconds = 100;  // how late an interrupt or the limit of time is seen
constexpr int endMilliseconds = 1;     // from the end of a process' answers to its own

struct Try {
    Job job;
    int number = 1;
};

struct Running {
    Running(Try begun, const PoolWork& work, const PoolRules& rules)
        : what(std::move(begun)), process([&] { return work.perform(what.job); }, rules.seconds, rules.mostBytes) {}
    Try what;
    JobProcess process;
};

class Pool {
public:
    Pool(const PoolWork& what, const PoolRules& how) : work(what), rules(how) {}

    bool run() {
        while (!Interrupts::caught()) {
            fill();
            if (running.empty() && exhausted && again.empty()) return true;
            wait();
            lookAtAll();
        }
        return false;
    }

private:
    // Fresh ones first, so that what fails holds up nobody.
    std::optional<Try> nextTry() {
        if (!exhausted) {
            if (std::optional<Job> job = work.next()) return Try{std::move(*job)};
            exhausted = true;
        }
        if (again.empty()) return std::nullopt;
        Try first = std::move(again.front());
        again.pop_front();
        return first;
    }

    void fill() {
        while (running.size() < rules.processes && !Interrupts::caught()) {
            std::optional<Try> one = nextTry();
            if (!one) return;
            try {
                running.emplace_back(*one, work, rules);
            } catch (const Error& error) {
                return failed(std::move(*one), error.what());
            }
        }
    }

    void wait() const {
        std::vector<pollfd> ends;
        int milliseconds = pollMilliseconds;
        for (const Running& one : running) {
            ends.push_back({one.process.descriptor(), POLLIN, 0});
            if (one.process.descriptor() < 0) milliseconds = endMilliseconds;
        }
        poll(ends.data(), ends.size(), milliseconds);
    }

    void lookAtAll() {
        for (auto one = running.begin(); one != running.end();) {
            std::optional<JobEnd> end = one->process.look();
            if (!end) {
                ++one;
                continue;
            }
            Try what = std::move(one->what);
            one = running.erase(one);
            settle(std::move(what), *end);
        }
    }

    void settle(Try what, const JobEnd& end) {
        const std::string problem = end.done ? work.accept(what.job, end.text) : end.text;
        if (!problem.empty()) failed(std::move(what), problem);
    }

    void failed(Try what, const std::string& reason) {
        const bool last = what.number == rules.tries;
        work.failed(what.job, reason, last);
        if (last) return;
        ++what.number;
        again.push_back(std::move(what));
    }

    const PoolWork& work;
    const PoolRules& rules;
    bool exhausted = false;
    std::deque<Try> again;
    std::list<Running> running;
};

}  // namespace

bool runPool(const PoolWork& work, const PoolRules& rules) {
    RADLAB_CHECK(rules.processes > 0u);
    return Pool(work, rules).run();
}

}  // namespace radlab::grader

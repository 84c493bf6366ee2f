#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>

#include "grader/protocol/Graded.h"

namespace radlab::grader {

/// A submission to be graded.
struct Job {
    std::string hash;                          ///< of the contents; names it
    std::map<std::string, std::string> files;  ///< contents by name
};

/// What an engine asks the run for, and what it tells it. Called on the thread that called the engine, one at a time.
struct EngineCallbacks {
    std::function<std::optional<Job>()> next;  ///< nothing: there are no more
    std::function<void(const Job&, const Graded&)> graded;
    /// The grader or the machine failed; `last`: and that was the last try.
    std::function<void(const Job&, const std::string& reason, bool last)> failed;
};

/// Where submissions are graded: on this machine, or on others.
class Engine {
public:
    virtual ~Engine() = default;

    /// Grades all that there is, in any order, and tells of each as soon as it is done; ends early on an interrupt.
    ///
    /// Jobs are asked for as they are needed. Each is told as graded once, or as failed, the last time with `last`; what
    /// was not told at an interrupt is left for another run.
    virtual void grade(const EngineCallbacks& with) = 0;
};

}  // namespace radlab::grader

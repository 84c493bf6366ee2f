#pragma once

#include "grader/batch/Engine.h"

namespace radlab::grader {

/// How jobs are run on this machine.
struct PoolRules {
    unsigned processes = 1;   ///< at once
    double seconds = 1800.0;  ///< that a job may run or sleep: beyond what any does that goes well
    std::size_t mostBytes = std::size_t{64} << 20;  ///< of its answer
    int tries = 3;
};

/// What is done with jobs.
struct PoolWork {
    std::function<std::optional<Job>()> next;        ///< asked as soon as there is a process to spare; nothing: no more
    std::function<std::string(const Job&)> perform;  ///< in a process of its own; its answer as bytes
    /// Takes an answer; what is wrong with it, or nothing where it is good.
    std::function<std::string(const Job&, const std::string& answer)> accept;
    std::function<void(const Job&, const std::string& reason, bool last)> failed;
};

/// Runs jobs in processes that are forked from this one, several at once.
///
/// One that dies, throws, takes too long or gives no good answer is tried again, after all others. Waits for none of
/// them alone, and holds no more jobs than run or have failed.
/// @pre    this process has one thread
/// @return false where an interrupt ended it; what ran then was killed
bool runPool(const PoolWork& work, const PoolRules& rules);

}  // namespace radlab::grader

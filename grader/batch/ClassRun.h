#pragma once

#include "grader/batch/Engine.h"
#include "grader/batch/Store.h"
#include "grader/intake/Submission.h"

namespace radlab::grader {

/// How a class is graded.
struct ClassRules {
    RunKey key;
    std::function<Taken(const Submission&)> take;        ///< called once for each submission, when its turn has come
    std::function<void(const std::string& hash)> saved;  ///< a mark is in the store; may be no function
};

/// How many students ended in which way.
struct ClassCounts {
    std::size_t graded = 0;  ///< got their mark in this run
    std::size_t kept = 0;    ///< what they handed in had its mark in the store
    std::size_t nothing = 0, refused = 0, errors = 0;
    bool interrupted = false;  ///< the rest is left for another run
};

/// Grades what the store has no mark for, and notes for every student how it ended.
///
/// Contents that several students handed in are graded once. Stopped at any moment, by a signal or the loss of power,
/// the next run goes on where this one was: what was in progress is graded again, and nothing else.
/// @pre    this process has one thread; ids are unique
/// Errors: those of the store.
/// @cost   memory for the students, and for the submissions in progress
ClassCounts gradeClass(const std::vector<Submission>& submissions, Store& store, Engine& engine,
                       const ClassRules& rules);

}  // namespace radlab::grader

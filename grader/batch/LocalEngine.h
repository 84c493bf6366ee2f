#pragma once

#include "grader/batch/Pool.h"

namespace radlab::grader {

/// Grades on this machine, each submission in a process of its own.
class LocalEngine : public Engine {
public:
    LocalEngine(std::function<Graded(const Job&)> with, const PoolRules& within)
        : gradeOne(std::move(with)), rules(within) {}

    void grade(const EngineCallbacks& with) override;

private:
    std::function<Graded(const Job&)> gradeOne;
    PoolRules rules;
};

}  // namespace radlab::grader

#include "grader/batch/LocalEngine.h"

#include "base/Error.h"

namespace radlab::grader {

void LocalEngine::grade(const EngineCallbacks& with) {
    PoolWork work;
    work.next = with.next;
    work.perform = [&](const Job& job) { return toCbor(gradeOne(job)); };
    work.accept = [&](const Job& job, const std::string& answer) -> std::string {
        Graded graded;
        try {
            graded = gradedFromCbor(answer);
        } catch (const Error& error) {
            return error.what();
        }
        with.graded(job, graded);
        return "";
    };
    work.failed = with.failed;
    runPool(work, rules);
}

}  // namespace radlab::grader

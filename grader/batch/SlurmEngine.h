#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "grader/batch/Engine.h"

namespace radlab::grader {

/// How a cluster is asked.
struct SlurmRules {
    std::filesystem::path folder;      ///< that all its machines share; for one version and seed
    std::vector<std::string> task;     ///< the command of a task; the folder and the task's number are added
    std::vector<std::string> options;  ///< of sbatch: the partition, the time
    std::size_t chunk = 8;             ///< submissions of a task
    std::size_t mostTasks = 1000;      ///< of one array; beyond, chunks grow
    int tries = 3;
    double secondsBetween = 1.0;  ///< two looks at what has come
};

/// Grades on a Slurm cluster, by an array job over a shared folder.
///
/// The folder holds each submission as it is handed to a task, the lists of the tasks, and the results, each written whole or not at
/// all. What a task does not bring, since its machine died or it was cancelled, is submitted again. A command that was killed
/// finds the results that have come in the meantime, and cancels what is left of its job.
class SlurmEngine : public Engine {
public:
    explicit SlurmEngine(SlurmRules how) : rules(std::move(how)) {}

    /// Errors: MachineError, where sbatch is missing or refuses.
    void grade(const EngineCallbacks& with) override;

private:
    SlurmRules rules;
};

/// One task of the array: grades the submissions of its list that have no result yet by an engine of this machine.
///
/// Errors: no such folder or task; a folder that cannot be written.
void runSlurmTask(const std::filesystem::path& folder, std::size_t task, Engine& engine);

}  // namespace radlab::grader

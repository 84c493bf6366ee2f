#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "grader/batch/Engine.h"

namespace radlab::grader {

/// What a command and the tasks of its array job tell each other: files of a shared folder, each there whole or not at all.
class SlurmFolder {
public:
    /// Makes what is missing of it.
    explicit SlurmFolder(std::filesystem::path where);

    void putJob(const Job& job) const;
    Job job(const std::string& hash) const;

    void putTask(std::size_t task, const std::vector<std::string>& hashes) const;
    std::vector<std::string> task(std::size_t task) const;

    void putResult(const std::string& hash, const Graded& graded) const;
    void putFault(const std::string& hash, const std::string& reason) const;
    bool hasResult(const std::string& hash) const;

    /// What a task made of a submission: a result, or why there is none.
    struct Answer {
        std::optional<Graded> graded;
        std::string fault;
    };

    /// Takes an answer out of the folder; nothing while there is none, or where a shared disk cut it short.
    std::optional<Answer> takeAnswer(const std::string& hash) const;

    /// Removes a submission, as all is known of it.
    void forget(const std::string& hash) const;

    /// The number of the array job that may still run; empty where there is none.
    std::string submitted() const;
    void setSubmitted(const std::string& number) const;

    /// Where tasks print to, %a being the task.
    std::filesystem::path logs() const { return folder / "logs"; }
    const std::filesystem::path& path() const { return folder; }

private:
    std::filesystem::path folder;
};

}  // namespace radlab::grader

#pragma once

#include <array>
#include <atomic>
#include <mutex>
#include <optional>
#include <vector>

#include "grader/judge/Judge.h"
#include "grader/judge/PictureVerdict.h"
#include "grader/judge/Worker.h"
#include "grader/stages/Pictures.h"

namespace radlab::grader {

/// A line of the manifest, what performs it, and what came of it.
struct Task {
    const ManifestStage* stage = nullptr;
    const ManifestCheck* line = nullptr;
    const Check* check = nullptr;          ///< the cases of a unit check
    const PictureCase* picture = nullptr;  ///< or the picture
    WorkerRun run;
    std::optional<PictureVerdict> verdict;  ///< of a picture that was run
};

/// Runs tasks on several threads, each task in a process of its own.
class Runner {
public:
    /// @param total how many tasks there will be, for the progress
    Runner(std::filesystem::path library, const Manifest& manifest, const Toolchain& toolchain,
           const JudgeOptions& options, std::size_t total);

    /// Runs the tasks, and judges the pictures among them.
    ///
    /// What stays undone where no worker starts is marked as the machine's fault.
    /// Errors: Interrupted.
    void run(const std::vector<Task*>& tasks);

private:
    void work(const std::vector<Task*>& tasks, Worker& worker);
    void perform(Task& task, Worker& worker);
    double secondsFor(const Task& task) const;
    void tell(const std::string& now);

    static constexpr std::size_t mostStages = 32;

    std::filesystem::path library;
    const Manifest& manifest;
    const Toolchain& toolchain;
    const JudgeOptions& options;
    std::size_t total;
    Worker alone;  // of the one thread that there is with one job
    std::atomic<std::size_t> next = 0;
    std::array<std::atomic<bool>, mostStages> hangs{};  // by the stage's number
    std::mutex telling;
    std::size_t started = 0;
};

}  // namespace radlab::grader

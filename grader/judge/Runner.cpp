#include "grader/judge/Runner.h"

#include <algorithm>
#include <thread>

#include "base/Interrupts.h"

namespace radlab::grader {

namespace {

constexpr double secondsAfterHang = 2.0;

std::vector<Step> stepsOf(const Task& task) {
    if (task.picture) return task.picture->steps();
    std::vector<Step> steps;
    for (const Case& one : task.check->cases) steps.insert(steps.end(), one.steps.begin(), one.steps.end());
    return steps;
}

}  // namespace

Runner::Runner(std::filesystem::path submission, const Manifest& within, const Toolchain& tools,
               const JudgeOptions& how, std::size_t count)
    : library(std::move(submission)),
      manifest(within),
      toolchain(tools),
      options(how),
      total(count),
      alone(library, tools, within) {
    RADLAB_CHECK(manifest.stages.size() < mostStages);
}

void Runner::run(const std::vector<Task*>& tasks) {
    next = 0;
    const unsigned cores = std::max(1u, std::thread::hardware_concurrency());
    const auto count = std::min<std::size_t>(options.jobs ? options.jobs : cores, tasks.size());
    if (options.jobs == 1) {
        work(tasks, alone);
        return Interrupts::check();
    }
    std::vector<std::thread> threads;
    for (std::size_t i = 0; i < count; ++i)
        threads.emplace_back([&] {
            Worker worker(library, toolchain, manifest);  // goes with its thread
            work(tasks, worker);
        });
    for (std::thread& thread : threads) thread.join();
    Interrupts::check();
}

void Runner::work(const std::vector<Task*>& tasks, Worker& worker) {
    for (std::size_t i = next++; i < tasks.size() && !Interrupts::caught(); i = next++) {
        tell(tasks[i]->line->name);
        try {
            perform(*tasks[i], worker);
        } catch (const std::exception& fault) {
            tasks[i]->run.machineFailed = true;
            tasks[i]->run.run.cause = fault.what();
        }
    }
}

void Runner::perform(Task& task, Worker& worker) {
    const std::vector<Step> steps = stepsOf(task);
    task.run = worker.run(steps, secondsFor(task));
    if (task.run.timedOut) hangs[static_cast<std::size_t>(task.stage->number)] = true;
    if (task.picture) task.verdict = judgePicture(*task.line, *task.picture, steps, task.run.run);
}

// Where one check of a stage has hung, nobody waits as long for the next.
double Runner::secondsFor(const Task& task) const {
    const bool hung = hangs[static_cast<std::size_t>(task.stage->number)];
    return hung ? std::min(manifest.seconds, secondsAfterHang) : manifest.seconds;
}

void Runner::tell(const std::string& now) {
    const std::scoped_lock lock(telling);
    if (options.report) options.report(started++, total, now);
}

}  // namespace radlab::grader

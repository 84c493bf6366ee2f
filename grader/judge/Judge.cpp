#include "grader/judge/Judge.h"

#include <algorithm>
#include <future>
#include <map>

#include "base/Stopwatch.h"
#include "grader/judge/Runner.h"
#include "grader/sandbox/Process.h"

namespace radlab::grader {

namespace {

CheckResult resultOf(const Task& task) {
    CheckResult result;
    result.id = task.line->id;
    result.name = task.line->name;
    result.maxScore = task.line->marks;
    result.hint = task.line->hint;
    result.output = task.run.output;
    result.seconds = task.run.seconds;
    return result;
}

void settle(CheckResult& result, Status status, const std::string& message) {
    result.status = status;
    result.message = message;
    result.score = status == Status::pass ? result.maxScore : 0.0;
}

void settlePicture(const Task& task, CheckResult& result) {
    if (task.run.machineFailed) return settle(result, Status::error, task.run.run.cause);
    settle(result, task.verdict->status, task.verdict->message);
    result.picture = task.verdict->picture;
}

Status statusOf(const std::vector<CheckResult>& checks) {
    const auto any = [&](Status status) {
        return std::any_of(checks.begin(), checks.end(), [&](const CheckResult& c) { return c.status == status; });
    };
    for (const Status status : {Status::error, Status::notStarted, Status::fail, Status::blocked, Status::skipped})
        if (any(status)) return status;
    return Status::pass;
}

// Judges the unit checks of a stage together, since a mistake shows in all of them.
void settleUnits(const Stage& stage, const std::vector<const Task*>& tasks, const std::vector<CheckResult*>& results) {
    std::vector<const Check*> checks;
    std::vector<const CheckRun*> runs;
    for (const Task* task : tasks) {
        checks.push_back(task->check);
        runs.push_back(&task->run.run);
    }
    const StageVerdict verdict = judge(stage, checks, runs);
    CheckResult* first = nullptr;
    for (std::size_t i = 0; i < tasks.size(); ++i) {
        settle(*results[i], verdict.checks[i].status, verdict.checks[i].message);
        if (tasks[i]->run.machineFailed) settle(*results[i], Status::error, tasks[i]->run.run.cause);
        if (!first && results[i]->status == Status::fail) first = results[i];
    }
    if (!first) return;
    first->diagnosis = verdict.diagnosis;
    first->example = verdict.example;
}

bool passed(const std::vector<StageResult>& stages, const std::string& name) {
    return std::any_of(stages.begin(), stages.end(),
                       [&](const StageResult& s) { return s.stage == name && s.status == Status::pass; });
}

// The stages that a line of the manifest still waits for.
std::string awaited(const ManifestCheck& line, const std::vector<StageResult>& done) {
    std::string names;
    for (const std::string& needed : line.needs)
        if (!passed(done, needed)) names += (names.empty() ? "" : ", ") + needed;
    return names;
}

void addUp(Result& result) {
    for (const StageResult& stage : result.stages) {
        result.score += stage.score;
        result.maxScore += stage.maxScore;
    }
}

}  // namespace

// The stages with their cases, and one submission at a time.
class Judge::Cases {
public:
    Cases(const Manifest& within, const JudgeOptions& how) : manifest(within), options(how) {
        keepWanted(allStages());
        keepWanted(extensionStages());
    }

    // The tasks of a submission that has not been run yet.
    std::size_t begin() {
        tasks.clear();
        for (const ManifestStage& stage : manifest.stages)
            for (const ManifestCheck& line : stage.checks)
                if (wanted(stage.stage) && (options.pictures || line.references.empty()))
                    tasks.push_back(taskOf(stage, line));
        return tasks.size();
    }

    // First what can be judged by itself, then what needs other stages to be right.
    std::vector<StageResult> judge(Runner& runner) {
        std::vector<StageResult> done;
        for (const bool second : {false, true}) {
            std::vector<Task*> now;
            for (Task& task : tasks)
                if (task.line->needs.empty() != second && awaited(*task.line, done).empty()) now.push_back(&task);
            runner.run(now);
            // With one job, one after the other, each in the memory of the one before.
            const std::launch when = options.jobs == 1 ? std::launch::deferred : std::launch::async;
            std::vector<std::future<StageResult>> judged;
            for (const ManifestStage& stage : manifest.stages)
                if (wanted(stage.stage) && waits(stage) == second)
                    judged.push_back(std::async(when, [&] { return stageResult(stage, done); }));
            std::vector<StageResult> results;
            for (std::future<StageResult>& one : judged) results.push_back(one.get());
            done.insert(done.end(), results.begin(), results.end());
        }
        return done;
    }

    // Every stage with its checks, none of them run.
    std::vector<StageResult> unjudged(Status status, const std::string& why) {
        begin();
        std::vector<StageResult> results;
        for (const ManifestStage& stage : manifest.stages) {
            if (!wanted(stage.stage)) continue;
            StageResult result = emptyResult(stage);
            for (const Task& task : tasks)
                if (task.stage == &stage) settle(result.checks.emplace_back(resultOf(task)), status, why);
            sumUp(result);
            results.push_back(result);
        }
        return results;
    }

private:
    void keepWanted(std::vector<std::unique_ptr<Stage>> all) {
        for (std::unique_ptr<Stage>& stage : all) {
            const std::string name = stage->function();
            const auto isIt = [&](const ManifestStage& line) { return line.stage == name; };
            if (std::none_of(manifest.stages.begin(), manifest.stages.end(), isIt) || !wanted(name)) continue;
            checks[name] = stage->checks(options.seed);
            stages[name] = std::move(stage);
        }
    }

    // Asked for, or needed by what is.
    bool wanted(const std::string& name) const {
        if (options.stages.empty()) return true;
        for (const std::string& asked : options.stages) {
            if (asked == name) return true;
            for (const ManifestCheck& line : manifest.find(asked).checks)
                if (std::find(line.needs.begin(), line.needs.end(), name) != line.needs.end()) return true;
        }
        return false;
    }

    static bool waits(const ManifestStage& stage) {
        return std::any_of(stage.checks.begin(), stage.checks.end(),
                           [](const ManifestCheck& c) { return !c.needs.empty(); });
    }

    Task taskOf(const ManifestStage& stage, const ManifestCheck& line) const {
        Task task;
        task.stage = &stage;
        task.line = &line;
        for (const PictureCase& picture : pictures)
            if (picture.check == line.id) task.picture = &picture;
        if (task.picture) return task;
        for (const Check& check : checks.at(stage.stage))
            if (check.id == line.id) task.check = &check;
        if (!task.check)
            throw Error(manifestFile().string() + ": check '" + line.id + "' of " + stage.stage + " has no cases");
        return task;
    }

    static StageResult emptyResult(const ManifestStage& stage) {
        StageResult result;
        result.number = stage.number;
        result.stage = stage.stage;
        result.title = stage.title;
        return result;
    }

    static void sumUp(StageResult& result) {
        result.status = statusOf(result.checks);
        for (const CheckResult& check : result.checks) {
            result.score += check.score;
            result.maxScore += check.maxScore;
        }
    }

    StageResult stageResult(const ManifestStage& stage, const std::vector<StageResult>& done) const {
        StageResult result = emptyResult(stage);
        std::vector<const Task*> own;
        for (const Task& task : tasks)
            if (task.stage == &stage) own.push_back(&task);
        for (const Task* task : own) result.checks.push_back(resultOf(*task));
        std::vector<const Task*> units;
        std::vector<CheckResult*> unitResults;
        for (std::size_t i = 0; i < own.size(); ++i) {
            const std::string names = awaited(*own[i]->line, done);
            if (!names.empty()) {
                settle(result.checks[i], Status::blocked, "judged as soon as these are right: " + names);
            } else if (own[i]->picture) {
                settlePicture(*own[i], result.checks[i]);
            } else {
                units.push_back(own[i]);
                unitResults.push_back(&result.checks[i]);
            }
        }
        if (!units.empty()) settleUnits(*stages.at(stage.stage), units, unitResults);
        sumUp(result);
        return result;
    }

    const Manifest& manifest;
    const JudgeOptions& options;
    const std::vector<PictureCase> pictures = pictureCases();
    std::map<std::string, std::unique_ptr<Stage>> stages;
    std::map<std::string, std::vector<Check>> checks;
    std::vector<Task> tasks;
};

Judge::Judge(Manifest within, Toolchain tools, JudgeOptions how)
    : manifest(std::move(within)),
      toolchain(std::move(tools)),
      options(std::move(how)),
      cases(std::make_unique<Cases>(manifest, options)) {}

Judge::~Judge() = default;

Result Judge::judge(const std::filesystem::path& library) {
    const Stopwatch watch;
    Runner runner(library, manifest, toolchain, options, cases->begin());
    Result result;
    result.stages = cases->judge(runner);
    addUp(result);
    result.seed = options.seed;
    result.protections = protections(toolchain.sandbox);
    result.seconds = watch.seconds();
    return result;
}

Result Judge::judgeFile(const std::filesystem::path& source) {
    const TemporaryFolder folder;
    const std::filesystem::path library = folder.path() / "submission.so";
    const std::string said = compileSubmission(source, library, toolchain, manifest);
    Result result = judge(library);
    result.compiler = said;
    return result;
}

Result Judge::unjudged(Status status, const std::string& why) const {
    Result result;
    result.stages = cases->unjudged(status, why);
    addUp(result);
    result.seed = options.seed;
    result.protections = protections(toolchain.sandbox);
    return result;
}

Result Judge::notCompiled(const std::string& compilerSaid) const {
    Result result = unjudged(Status::blocked, "judged as soon as it compiles");
    result.compiler = compilerSaid;
    result.compiled = false;
    return result;
}

Result Judge::notStarted() const { return unjudged(Status::notStarted, "there is no such file yet"); }

}  // namespace radlab::grader

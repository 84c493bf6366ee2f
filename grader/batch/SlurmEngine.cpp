#include "grader/batch/SlurmEngine.h"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <set>
#include <sstream>
#include <thread>

#include "base/Interrupts.h"
#include "grader/batch/SlurmFolder.h"
#include "grader/sandbox/Process.h"

namespace radlab::grader {

namespace {

namespace fs = std::filesystem;

constexpr const char* jobName = "radlab";
constexpr double secondsOfAnswer = 60.0;  // of a busy controller
constexpr int looksAfterEnd = 5;          // a shared file system may show a file later than its job's end

// Where the program lies that users call by this name.
std::string findProgram(const std::string& name) {
    const char* places = std::getenv("PATH");
    std::istringstream list(places ? places : "/usr/local/bin:/usr/bin");
    for (std::string place; std::getline(list, place, ':');)
        if (access((place + "/" + name).c_str(), X_OK) == 0) return place + "/" + name;
    throw MachineError(name +
                       ": found no such program; --engine slurm needs a machine that submits to a Slurm cluster");
}

Command slurmCommand(const std::string& program, const std::vector<std::string>& arguments) {
    Command command;
    command.arguments = {findProgram(program)};
    command.arguments.insert(command.arguments.end(), arguments.begin(), arguments.end());
    for (const char* name : {"SLURM_CONF", "HOME", "USER", "SLURM_CLUSTERS"})
        if (const char* value = std::getenv(name)) command.environment.push_back(std::string(name) + "=" + value);
    return command;
}

Ended ask(const std::string& program, const std::vector<std::string>& arguments) {
    ProcessLimits limits;
    limits.seconds = secondsOfAnswer;
    limits.file = std::size_t{1} << 20;
    limits.stoppable = false;  // or a job might be left that nobody knows of
    return run(slurmCommand(program, arguments), "", limits);
}

std::string trimmed(std::string text) {
    while (!text.empty() && (text.back() == '\n' || text.back() == ' ')) text.pop_back();
    return text;
}

std::string quotedForShell(const std::string& word) {
    std::string quoted = "'";
    for (const char letter : word) quoted += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
    return quoted + "'";
}

// A run of the engine: what has not come yet, and the job that brings it.
class Array {
public:
    Array(const SlurmRules& how, const EngineCallbacks& others) : rules(how), with(others), folder(how.folder) {}

    void run() {
        cancel(folder.submitted());
        takeJobs();
        for (int attempt = 1; attempt <= rules.tries && !missing.empty(); ++attempt) {
            submit();
            if (!waitForAll()) return cancel(number);
            fail("its task on the cluster ended without a result: see " + folder.logs().string(),
                 attempt == rules.tries);
        }
        folder.setSubmitted("");
    }

private:
    // What an earlier command got graded is there already.
    void takeJobs() {
        while (std::optional<Job> job = with.next()) {
            if (takeAnswer(*job)) continue;
            folder.putJob(*job);
            missing.insert(job->hash);
        }
    }

    bool takeAnswer(const Job& job) {
        const std::optional<SlurmFolder::Answer> answer = folder.takeAnswer(job.hash);
        if (!answer || !answer->graded) return false;
        with.graded(job, *answer->graded);
        return true;
    }

    void submit() {
        const std::vector<std::string> hashes(missing.begin(), missing.end());
        const std::size_t chunk = std::max(rules.chunk, (hashes.size() + rules.mostTasks - 1) / rules.mostTasks);
        std::size_t tasks = 0;
        for (std::size_t i = 0; i < hashes.size(); i += chunk)
            folder.putTask(tasks++, {hashes.begin() + static_cast<std::ptrdiff_t>(i),
                                     hashes.begin() + static_cast<std::ptrdiff_t>(std::min(i + chunk, hashes.size()))});
        std::string script;
        for (const std::string& word : rules.task) script += quotedForShell(word) + " ";
        script = "exec " + script + quotedForShell(folder.path().string()) + " \"$SLURM_ARRAY_TASK_ID\"";
        std::vector<std::string> arguments = {"--parsable",
                                              "--propagate=NONE",
                                              std::string("--job-name=") + jobName,
                                              "--array=0-" + std::to_string(tasks - 1),
                                              "--output=" + (folder.logs() / "%a.txt").string(),
                                              "--chdir=" + folder.path().string()};
        arguments.insert(arguments.end(), rules.options.begin(), rules.options.end());
        arguments.insert(arguments.end(), {"--wrap", script});
        const Ended ended = ask("sbatch", arguments);
        if (ended.how != Ended::How::exited || ended.code != 0)
            throw MachineError("sbatch refused the job: " + trimmed(ended.output));
        number = trimmed(ended.output);
        number = number.substr(0, number.find(';'));  // the cluster's name may follow
        folder.setSubmitted(number);
    }

    // False where an interrupt ended it.
    bool waitForAll() {
        for (int after = 0; !missing.empty() && after < looksAfterEnd;) {
            collect();
            if (Interrupts::caught()) return false;
            if (missing.empty()) break;
            if (hasEnded()) ++after;
            std::this_thread::sleep_for(std::chrono::duration<double>(rules.secondsBetween));
        }
        return true;
    }

    void collect() {
        for (auto one = missing.begin(); one != missing.end();) {
            const Job job{*one, {}};
            const std::optional<SlurmFolder::Answer> answer = folder.takeAnswer(job.hash);
            if (!answer) {
                ++one;
                continue;
            }
            if (answer->graded)
                with.graded(job, *answer->graded);
            else
                with.failed(job, answer->fault, true);  // tried as often as it should be, by its task
            folder.forget(job.hash);
            one = missing.erase(one);
        }
    }

    void fail(const std::string& reason, bool last) {
        for (const std::string& hash : missing) with.failed({hash, {}}, reason, last);
    }

    // A controller that does not answer may do so later.
    bool hasEnded() const {
        const Ended ended = ask("squeue", {"--noheader", "--jobs=" + number, "--format=%T"});
        const bool unknown = ended.output.find("Invalid job id") != std::string::npos;
        return unknown || (ended.how == Ended::How::exited && ended.code == 0 && trimmed(ended.output).empty());
    }

    // By its name, too: numbers come round again.
    static void cancel(const std::string& job) {
        if (!job.empty()) ask("scancel", {std::string("--name=") + jobName, job});
    }

    const SlurmRules& rules;
    const EngineCallbacks& with;
    SlurmFolder folder;
    std::set<std::string> missing;
    std::string number;
};

}  // namespace

void SlurmEngine::grade(const EngineCallbacks& with) { Array(rules, with).run(); }

void runSlurmTask(const fs::path& place, std::size_t task, Engine& engine) {
    const SlurmFolder folder(place);
    std::vector<std::string> hashes = folder.task(task);
    std::erase_if(hashes, [&](const std::string& hash) { return folder.hasResult(hash); });
    std::size_t next = 0;
    EngineCallbacks with;
    with.next = [&]() -> std::optional<Job> {
        if (next == hashes.size()) return std::nullopt;
        return folder.job(hashes[next++]);
    };
    with.graded = [&](const Job& job, const Graded& graded) { folder.putResult(job.hash, graded); };
    with.failed = [&](const Job& job, const std::string& reason, bool last) {
        if (last) folder.putFault(job.hash, reason);
    };
    engine.grade(with);
}

}  // namespace radlab::grader

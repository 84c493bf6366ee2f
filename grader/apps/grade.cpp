// Marks the submissions of a class.

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <thread>

#include "apps/CommandLine.h"
#include "base/Heap.h"
#include "base/WholeFile.h"
#include "grader/apps/AboutMachine.h"
#include "grader/apps/GradeReports.h"
#include "grader/apps/GradeSummary.h"
#include "grader/apps/Grading.h"
#include "grader/apps/TryAttacks.h"
#include "grader/batch/ClassRun.h"
#include "grader/batch/SlurmEngine.h"
#include "grader/batch/Version.h"
#include "grader/sandbox/Process.h"
#include "grader/sandbox/TemporaryFolder.h"

using namespace radlab::grader;
using radlab::Error;

namespace {

struct Flags {
    std::string submissions;
    std::string out = "out";
    std::uint64_t seed = 1;
    unsigned jobs = 0;
    bool regrade = false, selfTest = false;
    std::string engine = "local";
    std::vector<std::string> require, only;
    std::string canvas, moodle, assignment;
    std::vector<std::string> slurm;
    std::string task;
};

std::string joined(const std::vector<std::string>& words, const char* between) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : between) + word;
    return text;
}

void describe(CLI::App& app, Flags& flags) {
    app.add_option(
        "submissions", flags.submissions,
        "The folder with a folder, repository or archive per student, as Canvas, Moodle or Classroom 50 give it");
    app.add_option("--out", flags.out, "The folder of the store (grades.db) and of the pages (grades/)")
        ->capture_default_str();
    app.add_option("--seed", flags.seed, "What the cases are drawn from; another seed marks all anew")
        ->capture_default_str();
    app.add_option("--jobs", flags.jobs, "Submissions at once; 0 is one a core")->capture_default_str();
    app.add_flag("--regrade", flags.regrade, "Mark all again, and keep the older marks beside the new");
    app.add_option("--only", flags.only, "This student alone, by the id on the class page; may be given several times")
        ->allow_extra_args(false);
    app.add_option("--engine", flags.engine, "Where to grade: on this machine, or on a cluster")
        ->check(CLI::IsMember({"local", "slurm"}))
        ->capture_default_str();
    app.add_option("--require", flags.require, "Do not grade without these protections, separated by commas")
        ->delimiter(',')
        ->allow_extra_args(false);
    app.add_flag("--self-test", flags.selfTest, "Run the attacks that the sandbox is to stop, and say which were");
    app.add_option("--canvas", flags.canvas, "Fill in this gradebook, as downloaded from Canvas")
        ->check(CLI::ExistingFile);
    app.add_option("--moodle", flags.moodle, "Fill in this worksheet, as downloaded from Moodle")
        ->check(CLI::ExistingFile);
    app.add_option("--assignment", flags.assignment,
                   "Which assignment of that gradebook, by its title or number, where it has several");
    app.add_option("--slurm", flags.slurm, "An option for sbatch, such as --slurm=--partition=all; may be repeated")
        ->allow_extra_args(false);
    app.add_option("--task", flags.task)->group("");  // of a cluster, followed by the task's number
    app.footer(
        "What has a mark in the store is not graded again: after a stop of any kind, the same command goes on.\n"
        "Exit codes: 0 every submission has its mark, whatever it is; 2 wrong flags or no submissions; 3 the grader "
        "or\n"
        "the machine failed for some student, who has no mark; 130 stopped by Ctrl-C.\n"
        "Examples: ./radlab grade submissions/\n          ./radlab grade submissions/ --seed 2026 --canvas "
        "grades.csv\n          ./radlab grade submissions/ --only student-07 --regrade");
}

std::vector<Submission> chosen(std::vector<Submission> all, const std::vector<std::string>& ids) {
    if (ids.empty()) return all;
    for (const std::string& id : ids)
        if (std::none_of(all.begin(), all.end(), [&](const Submission& one) { return one.student.id == id; }))
            throw Error("--only " + id + ": no such student among the " + std::to_string(all.size()) +
                        ", the first of whom is " + all.front().student.id);
    std::erase_if(
        all, [&](const Submission& one) { return std::find(ids.begin(), ids.end(), one.student.id) == ids.end(); });
    return all;
}

PoolRules poolRules(const Flags& flags, const Toolchain& toolchain) {
    PoolRules rules;
    rules.processes = flags.jobs > 0 ? flags.jobs : std::max(1u, std::thread::hardware_concurrency());
    if (toolchain.sanitized) rules.seconds *= 6;
    return rules;
}

// The command that a task of the cluster runs.
std::vector<std::string> taskCommand(const Flags& flags) {
    std::vector<std::string> command = {ownProgram().string(), "--seed", std::to_string(flags.seed)};
    if (flags.jobs) command.insert(command.end(), {"--jobs", std::to_string(flags.jobs)});
    if (!flags.require.empty()) command.insert(command.end(), {"--require", joined(flags.require, ",")});
    command.emplace_back("--task");
    return command;
}

SlurmRules slurmRules(const Flags& flags, const RunKey& key) {
    SlurmRules rules;
    rules.folder = std::filesystem::path(flags.out) / "slurm" /
                   (key.version + "-" + std::to_string(key.seed) + (key.regrade ? "-again" : ""));
    rules.task = taskCommand(flags);
    rules.options = flags.slurm;
    return rules;
}

// Temporary folders lie in one that goes with what a killed process left there.
class Scratch {
public:
    Scratch() { setenv("TMPDIR", folder.path().c_str(), 1); }

private:
    TemporaryFolder folder;
};

std::string titleOf(const std::filesystem::path& submissions) {
    const std::filesystem::path folder = std::filesystem::absolute(submissions).lexically_normal();
    return (folder.has_filename() ? folder : folder.parent_path()).filename().string();
}

ReportFiles reportFiles(const Flags& flags, const std::string& version) {
    return {std::filesystem::path(flags.out) / "grades",
            titleOf(flags.submissions),
            version,
            flags.canvas,
            flags.moodle,
            flags.assignment};
}

int gradeSubmissions(const Flags& flags) {
    const std::vector<Submission> all = findSubmissions(flags.submissions), some = chosen(all, flags.only);
    const Scratch scratch;
    radlab::makeFolder(flags.out);
    IntakeRules intake;
    intake.unpack = RADLAB_UNPACK_PROGRAM;
    Grading grading(flags.seed);
    intake.files = grading.handedIn();
    ClassRules rules;
    rules.key = {versionOf(filesOfGrader(grading.tools())), flags.seed, flags.regrade};
    const ReportFiles files = reportFiles(flags, rules.key.version);
    checkGradebooks(files);
    rules.take = [&](const Submission& submission) { return take(submission, intake); };
    Store store(std::filesystem::path(flags.out) / "grades.db");
    LocalEngine local([&](const Job& job) { return grading.grade(job); }, poolRules(flags, grading.tools()));
    Rehearsed here(grading, local);
    SlurmEngine cluster(slurmRules(flags, rules.key));
    Engine& engine = flags.engine == "slurm" ? static_cast<Engine&>(cluster) : here;
    const ClassCounts counts = gradeClass(some, store, engine, rules);
    if (counts.interrupted) {
        std::cerr << "stopped: " << counts.graded + counts.kept
                  << " have their mark, and keep it; the same command goes on with the others\n";
        return 130;
    }
    const std::vector<std::string> notes = writeClassReports(all, store, files);
    std::cout << classSummary(counts, all, store);
    for (const std::string& note : notes) std::cout << note << '\n';
    return counts.errors > 0 ? 3 : 0;
}

int gradeTask(const Flags& flags) {
    const Scratch scratch;
    Grading grading(flags.seed);
    LocalEngine local([&](const Job& job) { return grading.grade(job); }, poolRules(flags, grading.tools()));
    Rehearsed engine(grading, local);
    runSlurmTask(flags.task, std::stoul(flags.submissions), engine);
    return 0;
}

int grade(const Flags& flags) {
    try {
        requireProtections(flags.require, machineSandbox());
        if (flags.selfTest) return tryAttacks();
        if (flags.submissions.empty())
            throw Error("no folder of submissions was named: ./radlab grade --help shows how");
        tellLacks();
        return flags.task.empty() ? gradeSubmissions(flags) : gradeTask(flags);
    } catch (const MachineError& error) {
        std::cerr << "error: " << error.what() << '\n';
        return 3;
    }
}

}  // namespace

int main(int argc, char** argv) {
    radlab::keepFreedMemory();
    CLI::App app("Marks the submissions of a class.");
    Flags flags;
    describe(app, flags);
    app.set_version_flag("--version", aboutMachine);
    return radlab::runCommandLine(app, argc, argv, [&] { return grade(flags); });
}

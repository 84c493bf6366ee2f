#include "grader/batch/SlurmEngine.h"

#include <csignal>
#include <cstdlib>

#include <doctest/doctest.h>

#include "base/Interrupts.h"
#include "base/TestFolder.h"
#include "base/WholeFile.h"
#include "grader/batch/SlurmFolder.h"
#include "grader/sandbox/Process.h"

using namespace radlab;
using namespace radlab::grader;

namespace {

Graded marked(double score) {
    Graded graded;
    graded.result.score = score;
    return graded;
}

// Programs that stand in for Slurm's: the n-th job brings what lies in the folder "brings-n".
class Cluster {
public:
    Cluster() {
        rules.folder = place / "shared";
        rules.task = {(place / "task it's").string(), "--seed", "7"};
        rules.secondsBetween = 0.005;
        makeFolder(place / "bin");
        program("sbatch",
                "printf '%s\\n' \"$*\" | tr '\\n' ' ' >>sbatch.log; echo >>sbatch.log\n"
                "[ ! -e refuses ] || { echo 'sbatch: error: invalid partition'; exit 1; }\n"
                "number=$(grep -c . sbatch.log)\n"
                "for script; do :; done\n"
                "[ ! -e starts ] || SLURM_ARRAY_TASK_ID=0 sh -c \"$script\"\n"
                "[ ! -d brings-$number ] || cp -r brings-$number/. shared/\n"
                "echo \"40$number;here\"\n");
        program("squeue", "exit 0\n");
        program("scancel", "echo \"$*\" >>scancel.log\n");
        setenv("PATH", ((place / "bin").string() + ":" + older).c_str(), 1);
    }
    ~Cluster() { setenv("PATH", older.c_str(), 1); }

    void program(const std::string& name, const std::string& script) {
        const std::filesystem::path file = place / ("bin/" + name);
        writeFile(file, "#!/bin/sh\ncd '" + (place / "").string() + "'\n" + script);
        std::filesystem::permissions(file, std::filesystem::perms::all);
    }

    SlurmFolder brings(int job) const { return SlurmFolder(place / ("brings-" + std::to_string(job))); }
    SlurmFolder shared() const { return SlurmFolder(rules.folder); }
    std::string log(const std::string& name) const {
        return std::filesystem::exists(place / name) ? readFile(place / name) : "";
    }

    // Grades these, one letter each, and says what was told of them.
    std::string grade(const std::string& letters) {
        std::string told;
        std::size_t at = 0;
        EngineCallbacks with;
        with.next = [&]() -> std::optional<Job> {
            if (at == letters.size()) return std::nullopt;
            const std::string hash(1, letters[at++]);
            return Job{hash, {{"ProgRef.cpp", "// " + hash}}};
        };
        with.graded = [&](const Job& job, const Graded& graded) {
            told += job.hash + std::to_string(static_cast<int>(graded.result.score)) + " ";
        };
        with.failed = [&](const Job& job, const std::string& reason, bool last) {
            told += job.hash + (last ? "!" : "? ");
            if (last) told += "(" + reason.substr(0, 20) + ") ";
        };
        SlurmEngine(rules).grade(with);
        return told;
    }

    test::Folder place;
    SlurmRules rules;

private:
    std::string older = std::getenv("PATH");
};

}  // namespace

TEST_CASE("slurm: what the tasks of an array bring is told once, and nothing of it is left") {
    Cluster cluster;
    cluster.rules.chunk = 2;
    cluster.rules.options = {"--partition=all"};
    cluster.brings(1).putResult("a", marked(1));
    cluster.brings(1).putResult("b", marked(2));
    cluster.brings(1).putFault("c", "the machine's disk is full");
    CHECK(cluster.grade("abc") == "a1 b2 c!(the machine's disk i) ");
    const std::string call = cluster.log("sbatch.log");
    CHECK(call.find("--array=0-1 ") != std::string::npos);
    CHECK(call.find(" --partition=all --wrap ") != std::string::npos);
    CHECK(cluster.shared().task(0) == std::vector<std::string>{"a", "b"});
    CHECK(cluster.shared().task(1) == std::vector<std::string>{"c"});
    CHECK(std::filesystem::is_empty(cluster.place / "shared/jobs"));
    CHECK(std::filesystem::is_empty(cluster.place / "shared/results"));
    CHECK(cluster.shared().submitted().empty());
    CHECK(cluster.log("scancel.log").empty());
}

TEST_CASE("slurm: the script starts the task's command, whatever letters its path has") {
    Cluster cluster;
    cluster.rules.tries = 1;
    writeFile(cluster.place / "starts", "");
    writeFile(cluster.place / "task it's",
              "#!/bin/sh\nprintf '<%s>' \"$@\" >'" + (cluster.place / "started").string() + "'\n");
    std::filesystem::permissions(cluster.place / "task it's", std::filesystem::perms::all);
    cluster.grade("a");
    CHECK(cluster.log("started") == "<--seed><7><" + (cluster.place / "shared").string() + "><0>");
}

TEST_CASE("slurm: what a lost task had is submitted again, and fails after the last try alone") {
    Cluster cluster;
    cluster.brings(1).putResult("a", marked(1));
    cluster.brings(2).putResult("b", marked(2));
    CHECK(cluster.grade("abc") == "a1 b? c? b2 c? c!(its task on the clus) ");
    CHECK(cluster.shared().task(0) == std::vector<std::string>{"c"});
    CHECK(cluster.shared().job("c").files.at("ProgRef.cpp") == "// c");
}

TEST_CASE("slurm: what came after the command was killed is found, and the rest of its job cancelled") {
    Cluster cluster;
    cluster.shared().setSubmitted("4711");
    cluster.shared().putResult("a", marked(1));
    CHECK(cluster.grade("a") == "a1 ");
    CHECK(cluster.log("scancel.log") == "--name=radlab 4711\n");
    CHECK(cluster.log("sbatch.log").empty());
    CHECK(cluster.shared().submitted().empty());
}

TEST_CASE("slurm: a result that a shared disk cut short is made again") {
    Cluster cluster;
    cluster.brings(1).putResult("a", marked(1));
    const std::string whole = readFile(cluster.place / "brings-1/results/a");
    writeFile(cluster.place / "brings-1/results/a", whole.substr(0, whole.size() / 2));
    cluster.brings(2).putResult("a", marked(2));
    CHECK(cluster.grade("a") == "a? a2 ");
}

TEST_CASE("slurm: an interrupt cancels the job, and leaves what is not there for another run") {
    Cluster cluster;
    cluster.program("squeue", "echo RUNNING\n");
    const radlab::Interrupts interrupts;
    std::raise(SIGTERM);
    CHECK(cluster.grade("ab").empty());
    CHECK(cluster.log("scancel.log") == "--name=radlab 401\n");
}

TEST_CASE("slurm: where a cluster refuses, or there is none, is said") {
    Cluster cluster;
    writeFile(cluster.place / "refuses", "");
    CHECK_THROWS_WITH_AS(cluster.grade("a"), doctest::Contains("invalid partition"), MachineError);
    std::filesystem::remove(cluster.place / "bin/sbatch");
    setenv("PATH", (cluster.place / "bin").c_str(), 1);
    CHECK_THROWS_WITH_AS(cluster.grade("a"), doctest::Contains("sbatch: found no such program"), MachineError);
}

TEST_CASE("slurm: a task grades what has no result yet, and writes down what failed") {
    struct OnePasses : Engine {
        void grade(const EngineCallbacks& with) override {
            while (const std::optional<Job> job = with.next()) {
                seen += job->hash;
                if (job->hash == "b") with.graded(*job, marked(2));
                if (job->hash != "b") with.failed(*job, "first", false), with.failed(*job, "the last reason", true);
            }
        }
        std::string seen;
    } engine;
    const test::Folder place;
    const SlurmFolder shared(place / "shared");
    for (const char* hash : {"a", "b", "c", "d"}) shared.putJob({hash, {{"ProgRef.cpp", hash}}});
    shared.putTask(3, {"a", "b", "c"});
    shared.putResult("a", marked(1));
    runSlurmTask(place / "shared", 3, engine);
    CHECK(engine.seen == "bc");
    CHECK(shared.takeAnswer("b")->graded->result.score == 2.0);
    CHECK(shared.takeAnswer("c")->fault == "the last reason");
    CHECK_FALSE(shared.takeAnswer("d"));
    CHECK_THROWS_WITH(runSlurmTask(place / "shared", 4, engine), doctest::Contains("no such file"));
}

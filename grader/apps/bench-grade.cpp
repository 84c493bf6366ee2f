// How fast a class is graded, with how much memory, and what kill -9 costs: the program grade over a class of solutions, stubs
// and mutants, each of them another file.

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <optional>
#include <random>
#include <thread>

#include <SQLiteCpp/SQLiteCpp.h>

#include "apps/CommandLine.h"
#include "base/Error.h"
#include "base/Interrupts.h"
#include "base/ProgressBar.h"
#include "base/Stopwatch.h"
#include "base/WholeFile.h"
#include "grader/mutants/Mutant.h"
#include "grader/sandbox/TemporaryFolder.h"

using namespace radlab::grader;

namespace {

namespace fs = std::filesystem;

struct Flags {
    std::size_t submissions = 60;
    unsigned jobs = 0, kills = 0;
    std::uint64_t seed = 1;
};

// Every third is right or a stub, the others are wrong in ways that students are.
std::vector<std::string> texts(std::size_t count) {
    const std::string solution = radlab::readFile(RADLAB_SOURCE_DIR "/solutions/ProgRef.cpp"),
                      stub = radlab::readFile(RADLAB_SOURCE_DIR "/exercises/ProgRef.cpp");
    const std::vector<Mutant> mutants = projectMutants();
    std::vector<std::string> all;
    for (std::size_t i = 0; i < count; ++i) {
        const Mutant& mutant = mutants[i * 7919 % mutants.size()];
        const std::string& base = i % 6 == 0 ? solution : i % 6 == 3 ? stub : mutant.source;
        all.push_back(base + "\n// " + std::to_string(i) + "\n");
    }
    return all;
}

void writeClass(const fs::path& folder, std::size_t count) {
    std::size_t number = 0;
    for (const std::string& text : texts(count)) {
        char name[32];
        std::snprintf(name, sizeof name, "student-%04zu", ++number);
        fs::create_directories(folder / name);
        radlab::writeFile(folder / name / "ProgRef.cpp", text);
    }
}

// The program grade at work, without a word; asked to stop when this goes.
class Grade {
public:
    Grade(const fs::path& folder, const fs::path& out, const Flags& flags) : number(fork()) {
        if (number != 0) return;
        std::freopen("/dev/null", "w", stdout);
        std::freopen("/dev/null", "w", stderr);
        const std::string jobs = std::to_string(flags.jobs);
        execl(RADLAB_GRADE_PROGRAM, RADLAB_GRADE_PROGRAM, folder.c_str(), "--out", out.c_str(), "--jobs", jobs.c_str(),
              static_cast<char*>(nullptr));
        _exit(127);
    }
    ~Grade() { end(SIGTERM); }
    Grade(const Grade&) = delete;
    Grade& operator=(const Grade&) = delete;

    pid_t process() const { return number; }

    void end(int signal) {
        if (code) return;
        kill(number, signal);
        int status = 0;
        waitpid(number, &status, 0);
        code = codeOf(status);
    }

    // Its exit code once it has ended.
    std::optional<int> ended() {
        radlab::Interrupts::check();
        int status = 0;
        if (!code && waitpid(number, &status, WNOHANG) == number) code = codeOf(status);
        return code;
    }

private:
    static int codeOf(int status) { return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status); }

    pid_t number;
    std::optional<int> code;
};

double mebibytesOf(pid_t process) {
    std::ifstream file("/proc/" + std::to_string(process) + "/status");
    for (std::string word; file >> word;)
        if (word == "VmRSS:" && file >> word) return std::stod(word) / 1024.0;
    return 0.0;
}

std::size_t gradedIn(const fs::path& out) {
    try {
        const SQLite::Database store(out / "grades.db", SQLite::OPEN_READONLY, 1000);
        SQLite::Statement count(store, "SELECT count(*) FROM results");
        return count.executeStep() ? static_cast<std::size_t>(count.getColumn(0).getInt64()) : 0;
    } catch (const SQLite::Exception&) {
        return 0;  // not there yet
    }
}

void measureRate(const Flags& flags) {
    const TemporaryFolder place;
    writeClass(place.path() / "class", flags.submissions);
    const radlab::Stopwatch watch;
    Grade grade(place.path() / "class", place.path() / "out", flags);
    radlab::ProgressBar bar("grading", static_cast<double>(flags.submissions), "submissions");
    double firstTenth = 0.0, most = 0.0, gradingSeconds = 0.0;
    while (!grade.ended()) {
        const std::size_t done = gradedIn(place.path() / "out");
        const double memory = mebibytesOf(grade.process());
        if (done < flags.submissions) gradingSeconds = watch.seconds();
        if (done * 10 <= flags.submissions) firstTenth = std::max(firstTenth, memory);
        most = std::max(most, memory);
        bar.show(static_cast<double>(done));
        std::this_thread::sleep_for(std::chrono::milliseconds(200));
    }
    if (grade.ended() != 0) throw radlab::Error("grade ended with exit code " + std::to_string(*grade.ended()));
    std::printf("%zu submissions: %.1f s, %.1f a minute; with their pages %.1f s\n", flags.submissions, gradingSeconds,
                60.0 * static_cast<double>(flags.submissions) / gradingSeconds, watch.seconds());
    std::printf("memory of the judge: %.1f MiB in the first tenth, %.1f MiB at most\n", firstTenth, most);
}

// Kills the command at random moments, until it has been killed so often; then lets it end.
void measureKills(const Flags& flags) {
    const TemporaryFolder place;
    const fs::path out = place.path() / "out";
    writeClass(place.path() / "class", flags.submissions);
    std::mt19937_64 random(flags.seed);
    std::size_t before = 0, lost = 0, killed = 0;
    radlab::ProgressBar bar("killing", flags.kills, "kills");
    while (killed < flags.kills) {
        Grade grade(place.path() / "class", out, flags);
        std::this_thread::sleep_for(std::chrono::milliseconds(std::uniform_int_distribution<int>(0, 6000)(random)));
        if (grade.ended()) break;
        grade.end(SIGKILL);
        bar.show(static_cast<double>(++killed));
        const std::size_t now = gradedIn(out);
        lost += now < before ? before - now : 0;
        before = now;
    }
    Grade grade(place.path() / "class", out, flags);
    while (!grade.ended()) std::this_thread::sleep_for(std::chrono::milliseconds(50));
    const SQLite::Database store(out / "grades.db");
    SQLite::Statement check(store, "PRAGMA integrity_check");
    check.executeStep();
    std::printf("%zu kills: %zu marks lost, %zu of %zu submissions graded, store: %s, exit code %d\n", killed, lost,
                gradedIn(out), flags.submissions, check.getColumn(0).getText(), *grade.ended());
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app("Measures the grading of a class.");
    Flags flags;
    app.add_option("--submissions", flags.submissions, "How many students hand something in")->capture_default_str();
    app.add_option("--jobs", flags.jobs, "Submissions at once; 0 is one a core")->capture_default_str();
    app.add_option("--kills", flags.kills, "Kill the command so often, instead of measuring its rate");
    app.add_option("--seed", flags.seed, "Of the moments of the kills")->capture_default_str();
    app.footer("The attacks: ./radlab grade --self-test");
    return radlab::runCommandLine(app, argc, argv, [&] {
        const radlab::Interrupts interrupts;
        if (flags.kills)
            measureKills(flags);
        else
            measureRate(flags);
        return 0;
    });
}

// The grading of a class, killed fifty times: this program starts itself again as the one that is killed.

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <random>
#include <set>
#include <thread>

#include <SQLiteCpp/SQLiteCpp.h>
#include <doctest/doctest.h>

#include "base/Error.h"
#include "base/TestFolder.h"
#include "base/TestStderr.h"
#include "base/WholeFile.h"
#include "grader/batch/ClassRun.h"
#include "grader/batch/LocalEngine.h"
#include "grader/intake/Hash.h"
#include "grader/sandbox/Pipes.h"
#include "grader/sandbox/Process.h"

using namespace radlab;
using namespace radlab::grader;

namespace {

constexpr int submissions = 200, kills = 50;
constexpr unsigned processes = 4;
constexpr std::size_t pictureBytes = 200000;  // long to write, so that kills come in the middle of it

constexpr int allowance = 8, report = 9;  // descriptors of the program that is killed
constexpr const char* hiddenCase = "--test-case=the program that is killed";
constexpr const char* folderVariable = "RADLAB_KILLED_FOLDER";

Graded gradeSlowly(const Job& job, const std::filesystem::path& log) {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    std::ofstream(log, std::ios::app) << job.hash << std::endl;
    Graded graded;
    graded.result.score = 1.0;
    graded.pictures = {{"stage", "check", "", 0.0, 0.0, {{"yours", std::string(pictureBytes, 'x') + job.hash, 1, 1}}}};
    return graded;
}

std::vector<Submission> classOf(int count) {
    std::vector<Submission> all(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) all[static_cast<std::size_t>(i)].student.id = "student-" + std::to_string(i);
    return all;
}

std::string hashOf(const Submission& submission) { return sha256(submission.student.id); }

// Grades the class, and says what is saved; with each word it waits until it may go on.
void gradeStepByStep(const std::filesystem::path& folder) {
    const test::CapturedStderr quiet;
    Store store(folder / "grades.db");
    PoolRules pool;
    pool.processes = processes;
    LocalEngine engine([&](const Job& job) { return gradeSlowly(job, folder / "log"); }, pool);
    ClassRules rules;
    rules.key = {"v1", 1};
    rules.take = [](const Submission& one) { return Taken{Outcome::graded, {{"ProgRef.cpp", ""}}, {}, hashOf(one)}; };
    rules.saved = [](const std::string& hash) {
        const std::string line = hash + "\n";
        char allowed = 0;
        if (write(report, line.data(), line.size()) < 0 || read(allowance, &allowed, 1) < 0) _exit(1);
    };
    gradeClass(classOf(submissions), store, engine, rules);
}

// A start of that program: it may save so many, and then waits.
class Started {
public:
    Started(const std::filesystem::path& folder, int steps) : toIt(makePipe()), fromIt(makePipe()) {
        const std::string allowed(static_cast<std::size_t>(steps), '+');
        REQUIRE(write(toIt.writing.get(), allowed.data(), allowed.size()) == steps);
        process = fork();
        if (process == 0) become(folder);
        toIt.reading.close();
        fromIt.writing.close();
    }
    ~Started() { kill(); }
    Started(const Started&) = delete;
    Started& operator=(const Started&) = delete;

    /// What it has saved; nothing when it has ended.
    std::string line() {
        std::string text;
        char letter = 0;
        while (read(fromIt.reading.get(), &letter, 1) == 1 && letter != '\n') text.push_back(letter);
        return text;
    }

    std::vector<std::string> toItsEnd() {
        toIt.writing.close();
        std::vector<std::string> lines;
        for (std::string one = line(); !one.empty(); one = line()) lines.push_back(one);
        return lines;
    }

    /// How it ended, as waitpid says.
    int kill() {
        if (process < 0) return 0;
        ::kill(process, SIGKILL);
        int status = 0;
        waitpid(process, &status, 0);
        process = -1;
        return status;
    }

private:
    void become(const std::filesystem::path& folder) const {
        setenv(folderVariable, folder.c_str(), 1);
        dup2(toIt.reading.get(), allowance);
        dup2(fromIt.writing.get(), report);
        dup2(open("/dev/null", O_WRONLY), 1);
        execl(ownProgram().c_str(), "grader-batch-test", "--no-skip", hiddenCase, nullptr);
        _exit(127);
    }

    Pipe toIt, fromIt;
    pid_t process = -1;
};

std::vector<std::string> gradings(const std::filesystem::path& log) {
    std::ifstream lines(log);
    std::vector<std::string> all;
    for (std::string line; std::getline(lines, line);) all.push_back(line);
    return all;
}

std::set<std::string> saved(const std::filesystem::path& file) {
    SQLite::Database database(file);
    SQLite::Statement query(database, "SELECT hash FROM submissions JOIN results ON submission = submissions.id");
    std::set<std::string> hashes;
    while (query.executeStep()) CHECK_MESSAGE(hashes.insert(query.getColumn(0).getString()).second, "graded twice");
    return hashes;
}

// All submissions have one mark, their student's, with its picture.
void checkWhole(const std::filesystem::path& file) {
    CHECK(SQLite::Database(file).execAndGet("PRAGMA integrity_check").getString() == "ok");
    const std::set<std::string> kept = saved(file);
    CHECK(kept.size() == submissions);
    const StoreReader reader(file);
    for (const Submission& one : classOf(submissions)) {
        CHECK(kept.count(hashOf(one)) == 1);
        CHECK(reader.find(one.student.id).value().outcome == Outcome::graded);
        CHECK(reader.pictures(one.student.id).at(0).images.at(0).png.substr(pictureBytes) == hashOf(one));
    }
}

}  // namespace

TEST_CASE("the program that is killed" * doctest::skip()) {
    const char* folder = std::getenv(folderVariable);
    REQUIRE(folder);
    gradeStepByStep(folder);
}

TEST_CASE("killed fifty times at random, nothing that was saved is lost or graded again") {
    const test::Folder folder;
    const std::filesystem::path file = folder / "grades.db", log = folder / "log";
    std::mt19937 random(7);
    std::set<std::string> told, kept;
    for (int i = 0; i < kills; ++i) {
        CAPTURE(i);
        const std::size_t before = gradings(log).size();
        const int steps = 1 + static_cast<int>(random() % 2);  // and one more, so that all kills find something to do
        Started program(folder / ".", steps);
        for (int k = 0; k < steps; ++k) told.insert(program.line());
        std::this_thread::sleep_for(std::chrono::microseconds(random() % 3000));
        REQUIRE(WIFSIGNALED(program.kill()));
        const std::vector<std::string> graded = gradings(log);
        for (std::size_t k = before; k < graded.size(); ++k) CHECK(kept.count(graded[k]) == 0);
        kept = saved(file);
        CHECK(std::includes(kept.begin(), kept.end(), told.begin(), told.end()));
        CHECK(graded.size() <= kept.size() + static_cast<std::size_t>(i + 1) * processes);
    }
    CHECK(told.count("") == 0);
    CHECK(told.size() >= kills);
    for (int i = 0; i < kills / 5; ++i) {  // at its very beginning, too
        Started program(folder / ".", 1);
        std::this_thread::sleep_for(std::chrono::microseconds(random() % 30000));
        program.kill();
    }
    Started last(folder / ".", 0);
    const std::vector<std::string> rest = last.toItsEnd();
    CHECK(rest.size() <= submissions - told.size());
    checkWhole(file);
}

#include "grader/batch/Pool.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <set>
#include <thread>

#include <doctest/doctest.h>

#include "base/Error.h"
#include "base/Interrupts.h"
#include "base/Stopwatch.h"
#include "base/TestFolder.h"
#include "base/TestLoad.h"
#include "base/WholeFile.h"
#include "grader/batch/JobProcess.h"

using namespace radlab;
using namespace radlab::grader;

namespace {

#ifdef __SANITIZE_ADDRESS__
constexpr int many = 120;  // a fork takes ten times as long, as the sanitizer's memory goes with it
#else
constexpr int many = 1200;
#endif

// A pool over the jobs "0", "1", …, and all that it told.
struct Told {
    PoolRules rules;
    std::function<std::string(const Job&)> perform = [](const Job& job) { return job.hash; };
    int jobs = 1;

    std::vector<std::string> events;  // "3 asked", "3 = answer", "3 failed: reason", "3 failed last: reason"
    int unsettled = 0, mostUnsettled = 0;

    bool run() {
        PoolWork work;
        int asked = 0;
        work.next = [&]() -> std::optional<Job> {
            if (asked == jobs) return std::nullopt;
            mostUnsettled = std::max(mostUnsettled, ++unsettled);
            return Job{std::to_string(asked++), {}};
        };
        work.perform = perform;
        work.accept = [&](const Job& job, const std::string& answer) -> std::string {
            if (answer == "garbage") return "that is garbage";
            --unsettled;
            events.push_back(job.hash + " = " + answer);
            return "";
        };
        work.failed = [&](const Job& job, const std::string& reason, bool last) {
            unsettled -= last ? 1 : 0;
            events.push_back(job.hash + (last ? " failed last: " : " failed: ") + reason);
        };
        return runPool(work, rules);
    }
};

std::vector<std::string> threeTimes(const std::string& reason) {
    return {"0 failed: " + reason, "0 failed: " + reason, "0 failed last: " + reason};
}

// Whether a process is gone, or dead and not yet buried.
bool isGone(const std::string& process) {
    try {
        const std::string about = readFile("/proc/" + process + "/stat");
        return about.at(about.rfind(')') + 2) == 'Z';
    } catch (const Error&) {
        return true;
    }
}

// Whether it comes true; nobody waits forever for what is wrong.
template <class Claim>
bool comesTrue(const Claim& claim) {
    for (int i = 0; i < 150000 && !claim(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(2));
    return claim();
}

std::string waitFor(const std::filesystem::path& file) {
    (void)comesTrue([&] { return std::filesystem::exists(file); });
    return readFile(file);
}

}  // namespace

TEST_CASE("every job is answered once, by as many processes as there are jobs") {
    Told told;
    told.jobs = 50;
    told.rules.processes = 4;
    told.perform = [](const Job& job) { return job.hash + " by " + std::to_string(getpid()); };
    CHECK(told.run());
    CHECK(told.events.size() == 50);
    std::set<std::string> jobs, processes;
    for (const std::string& event : told.events) {
        jobs.insert(event.substr(0, event.find(' ')));
        processes.insert(event.substr(event.rfind(' ')));
    }
    CHECK(jobs.size() == 50);
    CHECK(processes.size() == 50);
    CHECK(processes.count(" " + std::to_string(getpid())) == 0);
}

TEST_CASE("a job is made when a process is free for it, and not before, over more than a thousand") {
    Told told;
    told.jobs = many;
    told.rules.processes = 3;
    CHECK(told.run());
    CHECK(told.events.size() == many);
    CHECK(told.mostUnsettled == 3);
}

TEST_CASE("an answer of many megabytes arrives whole, and one beyond the limit is a fault") {
    Told told;
    std::size_t length = 5 << 20;
    told.perform = [&](const Job&) { return std::string(length, 'x'); };
    CHECK(told.run());
    REQUIRE(told.events.size() == 1);
    CHECK(told.events[0].size() == length + 4);
    told.events.clear();
    told.rules.mostBytes = 1000;
    length = 1001;
    CHECK(told.run());
    CHECK(told.events == threeTimes("the answer is too long: found 1001 bytes, expected at most 1000"));
}

TEST_CASE("a job that throws is tried three times, and its reason is told") {
    Told told;
    told.perform = [](const Job&) -> std::string { throw Error("this machine is too \x1b busy"); };
    CHECK(told.run());
    CHECK(told.events == threeTimes("this machine is too \\x1b busy"));
    told.events.clear();
    told.perform = [](const Job&) -> std::string { throw 7; };
    CHECK(told.run());
    CHECK(told.events == threeTimes("something was thrown that is no exception"));
}

TEST_CASE("a job that dies, exits or answers garbage is tried three times, and what it printed is told") {
    Told told;
    told.perform = [](const Job&) -> std::string {
        (void)!write(2, "out of luck\n", 12);
        raise(SIGKILL);
        return "";
    };
    CHECK(told.run());
    CHECK(told.events ==
          threeTimes("the judge's process was stopped by signal 9 without an answer; its last words: out of luck\n"));
    told.events.clear();
    told.perform = [](const Job&) -> std::string { _exit(5); };
    CHECK(told.run());
    CHECK(told.events == threeTimes("the judge's process ended with exit code 5 without an answer"));
    told.events.clear();
    told.perform = [](const Job&) { return "garbage"; };
    CHECK(told.run());
    CHECK(told.events == threeTimes("that is garbage"));
}

TEST_CASE("a job that hangs, or stops to answer and lives on, is killed at the limit and tried again") {
    Told told;
    told.rules.seconds = 0.1;
    told.perform = [](const Job&) -> std::string {
        close_range(3, ~0u, 0);
        while (true) pause();
    };
    CHECK(told.run());
    CHECK(told.events == threeTimes("took longer than 0.1 s"));
}

TEST_CASE("a job that others keep from the processors does not run into its limit") {
    Told told;
    const test::BusyProcessor busy;
    told.rules.seconds = 1.0;
    told.perform = [&](const Job&) -> std::string {
        const Stopwatch watch;
        test::stayOn(busy.number());
        while (watch.seconds() < 4.0) {
        }
        return "late";
    };
    CHECK(told.run());
    CHECK(told.events == std::vector<std::string>{"0 = late"});
}

TEST_CASE("what failed is tried again after all others, and may go well then") {
    const test::Folder folder;
    Told told;
    told.jobs = 5;
    told.perform = [&](const Job& job) -> std::string {
        if (job.hash != "1" || std::filesystem::exists(folder / "tried")) return "fine";
        writeFile(folder / "tried", "");
        throw Error("not yet");
    };
    CHECK(told.run());
    CHECK(told.events ==
          std::vector<std::string>{"0 = fine", "1 failed: not yet", "2 = fine", "3 = fine", "4 = fine", "1 = fine"});
}

TEST_CASE("jobs that fail take turns") {
    Told told;
    told.jobs = 2;
    told.perform = [](const Job&) -> std::string { throw Error("no"); };
    CHECK(told.run());
    CHECK(told.events == std::vector<std::string>{"0 failed: no", "1 failed: no", "0 failed: no", "1 failed: no",
                                                  "0 failed last: no", "1 failed last: no"});
}

TEST_CASE("a job that waits holds up no other") {
    const test::Folder folder;
    Told told;
    told.jobs = 20;
    told.rules.processes = 2;
    told.perform = [&](const Job& job) -> std::string {
        if (job.hash == "0") return waitFor(folder / "go");
        if (job.hash == "19") writeFile(folder / "go", "went");
        return "fine";
    };
    CHECK(told.run());
    CHECK(told.events.size() == 20);
    CHECK(told.events.front() != "0 = went");
}

TEST_CASE("a job finds nothing open that this process had open, and a group of its own") {
    const int secret = open("/etc/passwd", O_RDONLY);
    REQUIRE(secret >= 0);
    const int high = fcntl(secret, F_DUPFD, 500);
    Told told;
    told.perform = [](const Job&) {
        int others = 0;
        for (int i = 3; i < 1024; ++i) others += fcntl(i, F_GETFD) >= 0 ? 1 : 0;
        return std::to_string(others) + " " + (getpgrp() == getpid() ? "own" : "shared");
    };
    CHECK(told.run());
    close(secret);
    close(high);
    CHECK(told.events == std::vector<std::string>{"0 = 1 own"});
}

TEST_CASE("an interrupt ends the pool, and what runs then is killed") {
    const test::Folder folder;
    const radlab::Interrupts interrupts;
    Told told;
    told.jobs = 10;
    told.rules.processes = 2;
    told.perform = [&](const Job& job) -> std::string {
        if (job.hash == "1") return "fine";
        writeFile(folder / job.hash, std::to_string(getpid()));
        if (job.hash == "2" && !waitFor(folder / "0").empty()) kill(getppid(), SIGTERM);
        while (true) pause();
    };
    CHECK_FALSE(told.run());
    CHECK(told.events == std::vector<std::string>{"1 = fine"});
    CHECK(isGone(waitFor(folder / "0")));
    CHECK(isGone(waitFor(folder / "2")));
}

TEST_CASE("a job goes with this process, even where that is killed") {
    const test::Folder folder;
    const pid_t parent = fork();
    if (parent == 0) {
        Told told;
        told.perform = [&](const Job&) -> std::string {
            writeFile(folder / "job", std::to_string(getpid()));
            while (true) pause();
        };
        told.run();
        _exit(0);
    }
    const std::string job = waitFor(folder / "job");
    CHECK_FALSE(isGone(job));
    kill(parent, SIGKILL);
    waitpid(parent, nullptr, 0);
    CHECK(comesTrue([&] { return isGone(job); }));
}

TEST_CASE("nothing is forked from a process with several threads") {
    std::atomic<bool> end = false;
    std::thread other([&] {
        while (!end) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    });
    CHECK_THROWS_AS(JobProcess([] { return std::string(); }, 1.0, 100), std::logic_error);
    end = true;
    other.join();
}

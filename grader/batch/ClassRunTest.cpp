#include "grader/batch/ClassRun.h"

#include <algorithm>
#include <csignal>
#include <fstream>
#include <sstream>

#include <doctest/doctest.h>

#include "base/Error.h"
#include "base/TestFolder.h"
#include "base/TestStderr.h"
#include "base/WholeFile.h"
#include "grader/batch/ClassProgress.h"
#include "grader/batch/LocalEngine.h"

using namespace radlab;
using namespace radlab::grader;

namespace {

// A class whose submissions are what `contents` says: by id, empty for nothing handed in, "?" for what is refused.
struct Class {
    test::Folder folder;
    std::filesystem::path file = folder / "grades.db", log = folder / "log";
    std::map<std::string, std::string> contents;
    RunKey key{"v1", 1};
    std::function<void(const std::string&)> onTake = [](const std::string&) {};
    std::function<Graded(const Job&)> gradeOne = [](const Job& job) {
        Graded graded;
        graded.result.submission = "ProgRef.cpp";
        graded.result.score = static_cast<double>(job.files.at("ProgRef.cpp").size());
        return graded;
    };

    ClassCounts run() {
        const test::CapturedStderr quiet;
        Store store(file);
        ClassRules rules;
        rules.key = key;
        rules.take = [&](const Submission& submission) { return take(submission); };
        PoolRules pool;
        pool.processes = 3;
        LocalEngine engine(
            [&](const Job& job) {
                Graded graded = gradeOne(job);
                std::ofstream(log, std::ios::app) << job.hash << std::endl;
                return graded;
            },
            pool);
        return gradeClass(submissions(), store, engine, rules);
    }

    // How often anything was graded since the last call.
    std::size_t gradings() const {
        std::error_code none;
        const std::string text = std::filesystem::exists(log) ? readFile(log) : "";
        std::filesystem::remove(log, none);
        return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
    }

    StudentResult of(const std::string& id) const { return StoreReader(file).find(id).value(); }

private:
    std::vector<Submission> submissions() const {
        std::vector<Submission> all;
        for (const auto& one : contents) all.emplace_back().student.id = one.first;
        return all;
    }

    Taken take(const Submission& submission) const {
        const std::string text = contents.at(submission.student.id);
        onTake(submission.student.id);
        if (text.empty()) return {};
        if (text == "?") return {Outcome::refused, {}, {"a link was left out"}, ""};
        return {Outcome::graded, {{"ProgRef.cpp", text}}, {}, "hash of " + text};
    }
};

std::string all(const ClassCounts& counts) {
    std::ostringstream text;
    text << counts.graded << " graded, " << counts.kept << " kept, " << counts.nothing << " nothing, " << counts.refused
         << " refused, " << counts.errors << " errors" << (counts.interrupted ? ", interrupted" : "");
    return text.str();
}

}  // namespace

TEST_CASE_FIXTURE(Class, "every student ends in the store, and contents that are alike are graded once") {
    contents = {{"student-01", "int a;"},  {"student-02", ""},       {"student-03", "?"},
                {"student-04", "int bc;"}, {"student-05", "int a;"}, {"student-06", "int a;"}};
    CHECK(all(run()) == "4 graded, 0 kept, 1 nothing, 1 refused, 0 errors");
    CHECK(gradings() == 2);
    CHECK(of("student-01").result.score == 6.0);
    CHECK(of("student-06").result.score == 6.0);
    CHECK(of("student-04").result.score == 7.0);
    CHECK(of("student-02").outcome == Outcome::nothing);
    CHECK(of("student-03").outcome == Outcome::refused);
    CHECK(of("student-03").student.remarks == std::vector<std::string>{"a link was left out"});
}

TEST_CASE_FIXTURE(Class, "a second run grades what changed, and nothing else") {
    contents = {{"student-01", "one"}, {"student-02", "two"}, {"student-03", ""}};
    run();
    CHECK(gradings() == 2);
    CHECK(all(run()) == "0 graded, 2 kept, 1 nothing, 0 refused, 0 errors");
    CHECK(gradings() == 0);
    contents["student-02"] = "new work";
    contents["student-03"] = "one";
    CHECK(all(run()) == "1 graded, 2 kept, 0 nothing, 0 refused, 0 errors");
    CHECK(gradings() == 1);
    CHECK(of("student-02").result.score == 8.0);
    CHECK(of("student-02").earlier.at(0).score == 3.0);
    CHECK(of("student-03").result.score == 3.0);
    key.seed = 2;
    CHECK(all(run()) == "3 graded, 0 kept, 0 nothing, 0 refused, 0 errors");
    CHECK(gradings() == 2);
}

TEST_CASE_FIXTURE(Class, "grading again grades all, and keeps the older marks") {
    contents = {{"student-01", "one"}, {"student-02", "four"}};
    run();
    key.regrade = true;
    CHECK(all(run()) == "2 graded, 0 kept, 0 nothing, 0 refused, 0 errors");
    CHECK(gradings() == 4);
    CHECK(of("student-02").earlier.size() == 1);
}

TEST_CASE_FIXTURE(Class,
                  "what the grader fails at three times is an error without a mark, and graded by the next run") {
    contents = {{"student-01", "good"}, {"student-02", "bad"}, {"student-03", "bad"}};
    const auto good = gradeOne;
    gradeOne = [&](const Job& job) {
        if (job.hash == "hash of bad") throw Error("the compiler does not start");
        return good(job);
    };
    CHECK(all(run()) == "1 graded, 0 kept, 0 nothing, 0 refused, 2 errors");
    CHECK(of("student-01").outcome == Outcome::graded);
    CHECK(of("student-02").outcome == Outcome::error);
    CHECK(of("student-03").fault == "the compiler does not start");
    gradeOne = good;
    CHECK(all(run()) == "2 graded, 1 kept, 0 nothing, 0 refused, 0 errors");
    CHECK(of("student-03").result.score == 3.0);
    CHECK(of("student-03").earlier.empty());
}

TEST_CASE_FIXTURE(Class, "what cannot be read three times is an error, what can be at the second try is not") {
    contents = {{"student-01", "one"}, {"student-02", "two"}};
    int first = 0, second = 0;
    onTake = [&](const std::string& id) {
        if (id == "student-01" && ++first <= 3) throw Error("the disk fails");
        if (id == "student-02" && ++second <= 1) throw Error("the disk fails");
    };
    CHECK(all(run()) == "1 graded, 0 kept, 0 nothing, 0 refused, 1 errors");
    CHECK(of("student-01").fault == "the disk fails");
    CHECK(all(run()) == "1 graded, 1 kept, 0 nothing, 0 refused, 0 errors");
}

TEST_CASE_FIXTURE(Class, "an interrupt keeps what is done, and the next run does the rest") {
    for (int i = 10; i < 40; ++i) contents["student-" + std::to_string(i)] = std::to_string(i);
    onTake = [](const std::string& id) {
        if (id == "student-20") raise(SIGINT);
    };
    key.regrade = true;
    const ClassCounts counts = run();
    CHECK(counts.interrupted);
    CHECK(counts.graded >= 5);
    CHECK(counts.graded <= 11);
    onTake = [](const std::string&) {};
    CHECK(all(run()) == std::to_string(30 - counts.graded) + " graded, " + std::to_string(counts.graded) +
                            " kept, 0 nothing, 0 refused, 0 errors");
}

TEST_CASE("away from a terminal, progress is a line for every tenth") {
    std::ostringstream out;
    ClassProgress progress(40, out, false);
    for (int i = 0; i < 20; ++i) progress.skip();
    for (int i = 0; i < 20; ++i) progress.done(i == 3);
    std::istringstream lines(out.str());
    std::vector<std::string> all;
    for (std::string line; std::getline(lines, line);) all.push_back(line);
    REQUIRE(all.size() == 10);
    CHECK(all[7].find("grading: 32 of 40 done, 1 failed, ") == 0);
    CHECK(all[7].find(" left") != std::string::npos);
    CHECK(all[4] == "grading: 20 of 40 done, 0 failed");
    CHECK(all[9] == "grading: 40 of 40 done, 1 failed");
}

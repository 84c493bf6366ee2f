#include "grader/batch/Store.h"

#include <cmath>
#include <limits>

#include <unistd.h>

#include <SQLiteCpp/SQLiteCpp.h>
#include <doctest/doctest.h>

#include "base/Error.h"
#include "base/TestFolder.h"
#include "base/WholeFile.h"

using namespace radlab;
using namespace radlab::grader;

namespace {

const std::string anyBytes("a\0\xff<b>\x1b", 7);

Graded graded(double score, const std::string& png = "png") {
    Graded made;
    made.result.submission = "ProgRef.cpp";
    made.result.score = score;
    made.result.maxScore = 100.0;
    made.pictures = {{"calcFF",
                      "hemi.picture",
                      "form factors",
                      0.25,
                      0.01,
                      {{"reference", "reference's png", 4, 3}, {"yours", png, 4, 3}}}};
    return made;
}

Student student(const std::string& id, const std::string& submitted = "") {
    Student made;
    made.id = id;
    made.submitted = submitted;
    return made;
}

struct Fixture {
    test::Folder folder;
    std::filesystem::path file = folder / "grades.db";

    int count(const std::string& query) const { return SQLite::Database(file).execAndGet(query).getInt(); }
    void change(const std::string& command) const { SQLite::Database(file, SQLite::OPEN_READWRITE).exec(command); }

    // A run that gives a mark to student-07.
    void run(const RunKey& key, const std::string& hash, double score, const std::string& submitted = "") const {
        Store store(file);
        store.begin(key);
        store.save(hash, graded(score), {student("student-07", submitted)});
        store.finish();
    }

    std::string errorOf(bool writing) const {
        try {
            if (writing)
                Store store(file);
            else
                (void)StoreReader(file).students();
        } catch (const Error& error) {
            return error.what();
        }
        return "";
    }
};

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_CASE_FIXTURE(Fixture, "what was saved of a student comes back, any bytes and a large seed included") {
    Student one = student("student-07", "2026-11-23T08:15:00Z");
    one.name = anyBytes;
    one.account = "4711";
    one.late = true;
    one.remarks = {"a link was left out", anyBytes};
    Graded given = graded(63.5, anyBytes);
    given.pictures[0].rms = std::numeric_limits<double>::quiet_NaN();
    {
        Store store(file);
        store.begin({"v1", ~std::uint64_t{0}});
        CHECK_FALSE(store.isGraded("hash"));
        store.save("hash", given, {one});
        CHECK(store.isGraded("hash"));
    }
    const StoreReader reader(file);
    CHECK(reader.students() == std::vector<std::string>{"student-07"});
    const StudentResult back = reader.find("student-07").value();
    CHECK(back.student.name == anyBytes);
    CHECK(back.student.account == "4711");
    CHECK(back.student.submitted == "2026-11-23T08:15:00Z");
    CHECK(back.student.late);
    CHECK(back.student.remarks == one.remarks);
    CHECK(back.outcome == Outcome::graded);
    CHECK(back.result.score == 63.5);
    CHECK(back.graded.size() == 20);
    CHECK(back.earlier.empty());
    const std::vector<CheckPicture> pictures = reader.pictures("student-07");
    REQUIRE(pictures.size() == 1);
    CHECK(pictures[0].check == "hemi.picture");
    CHECK(pictures[0].caption == "form factors");
    CHECK(std::isnan(pictures[0].rms));
    CHECK(pictures[0].tolerance == 0.01);
    REQUIRE(pictures[0].images.size() == 2);
    CHECK(pictures[0].images[0].title == "reference");
    CHECK(pictures[0].images[1].png == anyBytes);
    CHECK(pictures[0].images[1].width == 4);
    CHECK_FALSE(reader.find("student-08"));
    CHECK(reader.pictures("student-08").empty());
}

TEST_CASE_FIXTURE(Fixture, "a student without a mark is kept with the reason, and a fault of the grader, too") {
    {
        Store store(file);
        store.begin({"v1"});
        store.note({{student("student-01"), Outcome::nothing, "", ""},
                    {student("student-02"), Outcome::refused, "", ""},
                    {student("student-03"), Outcome::error, "hash", "the disk is full"}});
        store.addFault("hash", "the disk is full");
    }
    const StoreReader reader(file);
    CHECK(reader.find("student-01")->outcome == Outcome::nothing);
    CHECK(reader.find("student-02")->outcome == Outcome::refused);
    CHECK(reader.find("student-03")->outcome == Outcome::error);
    CHECK(reader.find("student-03")->fault == "the disk is full");
    CHECK(count("SELECT count(*) FROM faults") == 1);
}

TEST_CASE_FIXTURE(Fixture, "a mark counts for its contents, version and seed alone") {
    run({"v1", 1}, "hash", 50.0);
    Store store(file);
    for (const auto& [key, counts] :
         {std::pair<RunKey, bool>{{"v1", 1}, true}, {{"v2", 1}, false}, {{"v1", 2}, false}}) {
        store.begin(key);
        CHECK(store.isGraded("hash") == counts);
        CHECK_FALSE(store.isGraded("other"));
    }
}

TEST_CASE_FIXTURE(Fixture, "a picture that many results share is stored once") {
    Store store(file);
    store.begin({"v1"});
    for (const std::string hash : {"one", "two", "three"}) store.save(hash, graded(50.0), {student(hash)});
    CHECK(count("SELECT count(*) FROM images") == 2);
    CHECK(count("SELECT count(*) FROM pictures") == 3);
    CHECK(store.pictures("three").at(0).images.at(1).png == "png");
}

TEST_CASE_FIXTURE(Fixture, "grading again keeps the older marks, with their times, seeds and versions, newest first") {
    run({"v1", 1}, "first", 10.0, "2026-11-01T00:00:00Z");
    run({"v1", 1}, "second", 20.0, "2026-11-02T00:00:00Z");
    run({"v2", 7}, "second", 30.0, "2026-11-02T00:00:00Z");
    run({"v2", 7, true}, "second", 40.0, "2026-11-02T00:00:00Z");
    const StudentResult result = StoreReader(file).find("student-07").value();
    CHECK(result.result.score == 40.0);
    REQUIRE(result.earlier.size() == 3);
    CHECK(result.earlier[0].score == 30.0);
    CHECK(result.earlier[0].version == "v2");
    CHECK(result.earlier[0].seed == 7);
    CHECK(result.earlier[1].score == 20.0);
    CHECK(result.earlier[1].submitted == "2026-11-02T00:00:00Z");
    CHECK(result.earlier[2].score == 10.0);
    CHECK(result.earlier[2].submitted == "2026-11-01T00:00:00Z");
    CHECK(result.earlier[2].maxScore == 100.0);
    CHECK(result.earlier[2].graded.size() == 20);
}

TEST_CASE_FIXTURE(Fixture, "who goes back to earlier contents has their mark again, and the other one beside it") {
    run({"v1"}, "first", 10.0);
    run({"v1"}, "second", 20.0);
    {
        Store store(file);
        store.begin({"v1"});
        store.note({{student("student-07"), Outcome::graded, "first", ""}});
    }
    const StudentResult result = StoreReader(file).find("student-07").value();
    CHECK(result.result.score == 10.0);
    REQUIRE(result.earlier.size() == 1);
    CHECK(result.earlier[0].score == 20.0);
}

TEST_CASE_FIXTURE(Fixture, "grading again goes on where it was stopped, and begins anew once it was finished") {
    run({"v1"}, "hash", 10.0);
    const RunKey again{"v1", 1, true};
    Store store(file);
    store.begin(again);
    CHECK_FALSE(store.isGraded("hash"));
    store.save("hash", graded(20.0), {student("student-07")});
    CHECK(store.isGraded("hash"));
    store.begin(again);
    CHECK(store.isGraded("hash"));
    CHECK_FALSE(store.isGraded("other"));
    store.begin(again);
    CHECK(store.isGraded("hash"));
    store.finish();
    store.begin(again);
    CHECK_FALSE(store.isGraded("hash"));
}

TEST_CASE_FIXTURE(Fixture, "saving is all or nothing") {
    Store store(file);
    store.begin({"v1"});
    CHECK_THROWS_AS(store.save("hash", graded(50.0), {student("student-07"), student("student-07")}), Error);
    CHECK_FALSE(store.isGraded("hash"));
    CHECK(store.students().empty());
    CHECK(count("SELECT count(*) FROM images") == 0);
    store.save("hash", graded(50.0), {student("student-07")});
    CHECK(store.isGraded("hash"));
}

TEST_CASE_FIXTURE(Fixture, "a store that a newer radlab or another program wrote is refused, and left as it is") {
    run({"v1"}, "hash", 10.0);
    change("PRAGMA user_version = 7");
    for (const bool writing : {true, false}) {
        CAPTURE(writing);
        CHECK(has(errorOf(writing), "grades.db: was written by a newer radlab: found schema 7, expected at most 1"));
    }
    CHECK(count("PRAGMA user_version") == 7);
    change("PRAGMA application_id = 5; PRAGMA user_version = 1");
    for (const bool writing : {true, false}) CHECK(has(errorOf(writing), "another program"));
}

TEST_CASE_FIXTURE(Fixture, "a file that is no store, or damaged, is an error that names it") {
    CHECK(has(errorOf(false), "grades.db: no such file"));
    writeFile(file, std::string(5000, 'x'));
    for (const bool writing : {true, false})
        CHECK(has(errorOf(writing), "grades.db: is no store of grades, or is damaged"));
    std::filesystem::remove(file);
    for (const std::string hash : {"one", "two", "three"}) run({"v1"}, hash, 10.0);
    change("PRAGMA wal_checkpoint(TRUNCATE)");
    std::string bytes = readFile(file);
    REQUIRE(bytes.size() > 8192);
    for (std::size_t i = 4096; i < bytes.size(); ++i) bytes[i] = '\x55';
    writeFile(file, bytes);
    CHECK(has(errorOf(false), "damaged"));
    CHECK_THROWS_AS(StoreReader(file).find("student-07"), Error);
}

TEST_CASE_FIXTURE(Fixture, "a store whose making was interrupted is made anew") {
    writeFile(file, "");
    CHECK(has(errorOf(false), "holds no grades yet"));
    run({"v1"}, "hash", 10.0);
    CHECK(StoreReader(file).find("student-07")->result.score == 10.0);
}

TEST_CASE_FIXTURE(Fixture, "the last run is known, and whether it came to its end") {
    run({"v1", 1}, "hash", 10.0);
    CHECK(StoreReader(file).lastRun()->finished.size() == 20);
    Store store(file);
    store.begin({"v2", 7});
    const RunInfo last = StoreReader(file).lastRun().value();
    CHECK(last.version == "v2");
    CHECK(last.seed == 7);
    CHECK(last.started.size() == 20);
    CHECK(last.finished.empty());
}

TEST_CASE_FIXTURE(Fixture, "two runs at once are refused, readers beside one are not") {
    Store store(file);
    store.begin({"v1"});
    store.save("hash", graded(10.0), {student("student-07")});
    CHECK(has(errorOf(true), "another grade command (process " + std::to_string(getpid()) + ") is at work here"));
    CHECK(StoreReader(file).find("student-07")->result.score == 10.0);
    store.save("other", graded(20.0), {student("student-08")});
    CHECK(StoreReader(file).students().size() == 2);
}

TEST_CASE_FIXTURE(Fixture, "a run leaves the store whole, and lets go of it") {
    run({"v1"}, "hash", 10.0);
    run({"v1"}, "other", 20.0);
    CHECK(SQLite::Database(file).execAndGet("PRAGMA integrity_check").getString() == "ok");
    CHECK(count("SELECT count(*) FROM pragma_foreign_key_check") == 0);
}

#include "grader/batch/Store.h"

#include <ctime>

#include <nlohmann/json.hpp>

#include "base/Error.h"
#include "grader/batch/StoreFile.h"
#include "grader/intake/Hash.h"

namespace radlab::grader {

namespace {

using SQLite::Database;
using SQLite::Statement;
using SQLite::Transaction;

std::string nowInUtc() {
    const std::time_t now = std::time(nullptr);
    std::tm parts{};
    gmtime_r(&now, &parts);
    char text[32];
    return {text, std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &parts)};
}

template <class Value>
void bindOne(Statement& statement, int place, const Value& value) {
    if constexpr (std::is_same_v<Value, std::uint64_t>)
        statement.bind(place, static_cast<std::int64_t>(value));
    else
        statement.bind(place, value);
}

template <class... Values>
Statement prepared(const Database& database, const char* text, const Values&... values) {
    Statement statement(database, text);
    [[maybe_unused]] int place = 0;  // where there are no values
    (bindOne(statement, ++place, values), ...);
    return statement;
}

template <class... Values>
void change(const Database& database, const char* text, const Values&... values) {
    prepared(database, text, values...).exec();
}

/// @return the first column of the first row; 0 where there is none
template <class... Values>
std::int64_t number(const Database& database, const char* text, const Values&... values) {
    Statement query = prepared(database, text, values...);
    return query.executeStep() ? query.getColumn(0).getInt64() : 0;
}

}  // namespace

Store::Store(const std::filesystem::path& at)
    : FileLock(at.string() + ".lock", "another grade command"), StoreReader(at, openStoreForWriting(at)) {}

void Store::begin(const RunKey& chosen) {
    key = chosen;
    onStore(path(), [&] {
        Transaction transaction(opened(), SQLite::TransactionBehavior::IMMEDIATE);
        // A run that grades again and was stopped has marks from its first begin on; they count, or it would never end.
        since = !key.regrade ? 0
                             : number(opened(),
                                      "SELECT since FROM runs WHERE id = (SELECT max(id) FROM runs) AND since > 0 AND "
                                      "finished IS NULL AND version = ? AND seed = ?",
                                      key.version, key.seed);
        run = number(opened(), "SELECT ifnull(max(id), 0) + 1 FROM runs");
        if (key.regrade && since == 0) since = run;
        change(opened(), "INSERT INTO runs (id, started, version, seed, since) VALUES (?, ?, ?, ?, ?)", run, nowInUtc(),
               key.version, key.seed, since);
        transaction.commit();
    });
}

bool Store::isGraded(const std::string& hash) const {
    return onStore(path(), [&] { return newestResult(hash) != 0; });
}

void Store::save(const std::string& hash, const Graded& graded, const std::vector<Student>& students) {
    onStore(path(), [&] {
        Transaction transaction(opened(), SQLite::TransactionBehavior::IMMEDIATE);
        const std::int64_t result = addResult(hash, graded.result);
        for (const CheckPicture& picture : graded.pictures) addPicture(result, picture);
        for (const Student& student : students) addStudent({student, Outcome::graded, hash, ""}, result);
        transaction.commit();
    });
}

void Store::note(const std::vector<StudentNote>& notes) {
    if (notes.empty()) return;
    onStore(path(), [&] {
        Transaction transaction(opened(), SQLite::TransactionBehavior::IMMEDIATE);
        for (const StudentNote& note : notes) {
            const std::int64_t result = note.outcome == Outcome::graded ? newestResult(note.hash) : 0;
            RADLAB_CHECK((result != 0) == (note.outcome == Outcome::graded));
            addStudent(note, result);
        }
        transaction.commit();
    });
}

void Store::addFault(const std::string& what, const std::string& reason) {
    onStore(path(), [&] {
        change(opened(), "INSERT INTO faults (run, at, what, reason) VALUES (?, ?, ?, ?)", run, nowInUtc(), what,
               reason);
    });
}

void Store::finish() {
    onStore(path(), [&] { change(opened(), "UPDATE runs SET finished = ? WHERE id = ?", nowInUtc(), run); });
}

std::int64_t Store::submission(const std::string& hash) {
    change(opened(), "INSERT INTO submissions (hash) VALUES (?) ON CONFLICT DO NOTHING", hash);
    return number(opened(), "SELECT id FROM submissions WHERE hash = ?", hash);
}

std::int64_t Store::newestResult(const std::string& hash) const {
    return number(opened(),
                  "SELECT results.id FROM results JOIN submissions ON submissions.id = submission WHERE hash = ? AND "
                  "version = ? AND seed = ? AND run >= ? ORDER BY attempt DESC LIMIT 1",
                  hash, key.version, key.seed, since);
}

std::int64_t Store::addResult(const std::string& hash, const Result& result) {
    const std::int64_t of = submission(hash);
    const std::int64_t attempt = number(
        opened(), "SELECT ifnull(max(attempt), 0) + 1 FROM results WHERE submission = ? AND version = ? AND seed = ?",
        of, key.version, key.seed);
    change(opened(),
           "INSERT INTO results (submission, version, seed, attempt, run, graded, score, max_score, result) "
           "VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?)",
           of, key.version, key.seed, attempt, run, nowInUtc(), result.score, result.maxScore,
           resultToJson(result).dump());
    return opened().getLastInsertRowid();
}

void Store::addPicture(std::int64_t result, const CheckPicture& picture) {
    change(opened(),
           "INSERT INTO pictures (result, stage, check_id, caption, rms, tolerance) VALUES (?, ?, ?, ?, ?, ?)", result,
           picture.stage, picture.check, picture.caption, picture.rms, picture.tolerance);
    const std::int64_t id = opened().getLastInsertRowid();
    int place = 0;
    for (const PngImage& one : picture.images)
        change(opened(),
               "INSERT INTO picture_images (picture, place, title, width, height, image) VALUES (?, ?, ?, ?, ?, ?)", id,
               place++, one.title, one.width, one.height, image(one.png));
}

std::int64_t Store::image(const std::string& png) {
    const std::string hash = sha256(png);
    if (const std::int64_t known = number(opened(), "SELECT id FROM images WHERE sha256 = ?", hash)) return known;
    Statement insertion(opened(), "INSERT INTO images (sha256, png) VALUES (?, ?)");
    insertion.bind(1, hash);
    insertion.bind(2, png.data(), static_cast<int>(png.size()));
    insertion.exec();
    return opened().getLastInsertRowid();
}

void Store::addStudent(const StudentNote& note, std::int64_t result) {
    const Student& student = note.student;
    const std::int64_t of = note.hash.empty() ? 0 : submission(note.hash);
    change(opened(),
           "INSERT INTO students (id, run, name, account, submitted, late, outcome, submission, result, fault) "
           "VALUES (?, ?, ?, ?, ?, ?, ?, nullif(?, 0), nullif(?, 0), ?)",
           student.id, run, student.name, student.account, student.submitted, static_cast<int>(student.late),
           outcomeText(note.outcome), of, result, note.fault);
    int place = 0;
    for (const std::string& remark : student.remarks)
        change(opened(), "INSERT INTO remarks (student, run, place, text) VALUES (?, ?, ?, ?)", student.id, run,
               place++, remark);
}

}  // namespace radlab::grader

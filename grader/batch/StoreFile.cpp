#include "grader/batch/StoreFile.h"

#include <sqlite3.h>

#include "grader/sandbox/Process.h"

namespace radlab::grader {

namespace {

constexpr int application = 0x5241444c;  // "RADL"
constexpr int schemaVersion = 1;
constexpr int busyMilliseconds = 10000;

// A seed has 64 bits, and is kept as the signed number of the same bits. SQLite has no NaN: an error of a picture that
// is none is NULL.
constexpr const char* schema = R"(
CREATE TABLE runs (
    id INTEGER PRIMARY KEY, started TEXT NOT NULL, finished TEXT, version TEXT NOT NULL, seed INTEGER NOT NULL,
    since INTEGER NOT NULL  -- results of earlier runs do not count in this one
) STRICT;
CREATE TABLE submissions (id INTEGER PRIMARY KEY, hash TEXT NOT NULL UNIQUE) STRICT;
CREATE TABLE results (
    id INTEGER PRIMARY KEY, submission INTEGER NOT NULL REFERENCES submissions, version TEXT NOT NULL,
    seed INTEGER NOT NULL, attempt INTEGER NOT NULL, run INTEGER NOT NULL REFERENCES runs, graded TEXT NOT NULL,
    score REAL NOT NULL, max_score REAL NOT NULL, result TEXT NOT NULL,
    UNIQUE (submission, version, seed, attempt)
) STRICT;
CREATE TABLE images (id INTEGER PRIMARY KEY, sha256 TEXT NOT NULL UNIQUE, png BLOB NOT NULL) STRICT;
CREATE TABLE pictures (
    id INTEGER PRIMARY KEY, result INTEGER NOT NULL REFERENCES results, stage TEXT NOT NULL, check_id TEXT NOT NULL,
    caption TEXT NOT NULL, rms REAL, tolerance REAL
) STRICT;
CREATE INDEX pictures_of_results ON pictures (result);
CREATE TABLE picture_images (
    picture INTEGER NOT NULL REFERENCES pictures, place INTEGER NOT NULL, title TEXT NOT NULL, width INTEGER NOT NULL,
    height INTEGER NOT NULL, image INTEGER NOT NULL REFERENCES images, PRIMARY KEY (picture, place)
) STRICT, WITHOUT ROWID;
CREATE TABLE students (
    id TEXT NOT NULL, run INTEGER NOT NULL REFERENCES runs, name TEXT NOT NULL, account TEXT NOT NULL,
    submitted TEXT NOT NULL, late INTEGER NOT NULL, outcome TEXT NOT NULL, submission INTEGER REFERENCES submissions,
    result INTEGER REFERENCES results, fault TEXT NOT NULL, PRIMARY KEY (id, run)
) STRICT, WITHOUT ROWID;
CREATE TABLE remarks (
    student TEXT NOT NULL, run INTEGER NOT NULL, place INTEGER NOT NULL, text TEXT NOT NULL,
    PRIMARY KEY (student, run, place), FOREIGN KEY (student, run) REFERENCES students
) STRICT, WITHOUT ROWID;
CREATE TABLE faults (
    id INTEGER PRIMARY KEY, run INTEGER NOT NULL REFERENCES runs, at TEXT NOT NULL, what TEXT NOT NULL,
    reason TEXT NOT NULL
) STRICT;
)";

int number(SQLite::Database& database, const char* query) { return database.execAndGet(query).getInt(); }

// Whether there is nothing in it yet, as where its making was interrupted.
bool isEmpty(SQLite::Database& database, const std::filesystem::path& file) {
    const int owner = number(database, "PRAGMA application_id"), version = number(database, "PRAGMA user_version");
    const bool empty = number(database, "SELECT count(*) FROM sqlite_schema") == 0;
    if (owner == 0 && empty) return true;
    if (owner != application) throw Error({file.string()}, "is the database of another program, no store of grades");
    if (version > schemaVersion)
        throw Error({file.string()}, "was written by a newer radlab: found schema " + std::to_string(version) +
                                         ", expected at most " + std::to_string(schemaVersion));
    return false;
}

void create(SQLite::Database& database) {
    SQLite::Transaction transaction(database, SQLite::TransactionBehavior::IMMEDIATE);
    database.exec(schema);
    database.exec("PRAGMA application_id = " + std::to_string(application));
    database.exec("PRAGMA user_version = " + std::to_string(schemaVersion));
    transaction.commit();
}

}  // namespace

SQLite::Database openStore(const std::filesystem::path& file) {
    std::error_code failure;
    if (!std::filesystem::exists(file, failure)) throw Error({file.string()}, "no such file: grade a class first");
    return onStore(file, [&] {
        SQLite::Database database(file, SQLite::OPEN_READONLY, busyMilliseconds);
        if (isEmpty(database, file)) throw Error({file.string()}, "holds no grades yet: grade a class first");
        return database;
    });
}

SQLite::Database openStoreForWriting(const std::filesystem::path& file) {
    return onStore(file, [&] {
        SQLite::Database database(file, SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE, busyMilliseconds);
        const bool empty = isEmpty(database, file);
        // Writing ahead, a kill at any moment leaves what is committed; synced at each commit, so does a loss of power.
        database.exec("PRAGMA journal_mode = WAL; PRAGMA synchronous = FULL; PRAGMA foreign_keys = ON");
        if (empty) create(database);
        return database;
    });
}

void throwStoreError(const std::filesystem::path& file, const SQLite::Exception& failure) {
    const std::string reason = failure.what();
    switch (failure.getErrorCode()) {
        case SQLITE_NOTADB:
        case SQLITE_CORRUPT:
            throw Error({file.string()}, "is no store of grades, or is damaged: " + reason +
                                             "; move it away, and all are graded again into a new one");
        case SQLITE_BUSY:
        case SQLITE_LOCKED: throw Error({file.string()}, "another program is writing to it: " + reason);
        case SQLITE_FULL:
            throw MachineError({file.string()}, "the disk is full; make room, and the same command goes on");
        default: throw MachineError({file.string()}, reason);
    }
}

}  // namespace radlab::grader

#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "grader/protocol/Graded.h"
#include "grader/protocol/Student.h"

namespace SQLite {
class Database;
}

namespace radlab::grader {

/// When a class was graded, and by what.
struct RunInfo {
    std::string started;
    std::string finished;  ///< empty where it was stopped, or is not at its end; both ISO 8601 in UTC
    std::string version;   ///< of the grader
    std::uint64_t seed = 0;
};

/// Reads what a class was given, one student at a time, so that memory does not grow with the class.
///
/// May be used while a run is writing: each call sees what is committed by then.
/// Errors of all: a store that is damaged; MachineError, where the disk fails.
class StoreReader {
public:
    /// Errors: no such file, one that is no store or damaged, one that a newer radlab wrote.
    explicit StoreReader(const std::filesystem::path& file);
    ~StoreReader();

    /// The last run; nothing where there was none.
    std::optional<RunInfo> lastRun() const;

    /// The ids of all students that any run has met, sorted.
    std::vector<std::string> students() const;

    /// What the last run that met a student made of what was handed in, with all earlier marks; without pictures.
    ///
    /// @return nothing where no run has met such a student
    std::optional<StudentResult> find(const std::string& student) const;

    /// The pictures of the same result; none where there is no mark.
    std::vector<CheckPicture> pictures(const std::string& student) const;

    const std::filesystem::path& path() const { return file; }

protected:
    StoreReader(std::filesystem::path at, SQLite::Database opened);
    SQLite::Database& opened() const { return *database; }

private:
    std::filesystem::path file;
    std::unique_ptr<SQLite::Database> database;
};

}  // namespace radlab::grader

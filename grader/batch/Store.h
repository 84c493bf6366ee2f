#pragma once

#include <string>
#include <vector>

#include "grader/batch/FileLock.h"
#include "grader/batch/StoreReader.h"

namespace radlab::grader {

/// What a run grades by: a mark holds for the contents of a submission, and one of these.
struct RunKey {
    std::string version;  ///< of the grader
    std::uint64_t seed = 1;
    bool regrade = false;  ///< marks of earlier runs do not count, and are kept beside the new ones
};

/// What a run notes of a student.
struct StudentNote {
    Student student;
    Outcome outcome = Outcome::nothing;
    std::string hash;   ///< of what was handed in; where graded
    std::string fault;  ///< where error
};

/// Keeps a class' grades in a file, for one run at a time: whatever ends that run, what was saved stays.
///
/// @pre    never touched by a process that was forked after its making
/// Errors of all: those of StoreReader; MachineError, where the disk fails or is full.
class Store : private FileLock, public StoreReader {  // locked before it is opened
public:
    /// Opens the file, or makes it, and keeps other runs off it.
    ///
    /// Errors: another run is at work on it; those of StoreReader.
    explicit Store(const std::filesystem::path& file);

    /// Begins a run. One that grades again goes on where the last one of its kind was stopped.
    void begin(const RunKey& key);

    /// Whether these contents have a mark that counts in this run.
    bool isGraded(const std::string& hash) const;

    /// Saves a mark, and that it was given to these students: all of it or nothing.
    void save(const std::string& hash, const Graded& graded, const std::vector<Student>& students);

    /// Notes how it ended for students, where no mark is new: all of it or nothing.
    ///
    /// @pre where graded, the contents have a mark
    void note(const std::vector<StudentNote>& notes);

    /// Keeps a fault of the grader or machine.
    ///
    /// @param what  was being graded: the hash of its contents, or a student's id
    void addFault(const std::string& what, const std::string& reason);

    /// Says that the run got to its end.
    void finish();

private:
    std::int64_t submission(const std::string& hash);
    std::int64_t newestResult(const std::string& hash) const;
    std::int64_t addResult(const std::string& hash, const Result& result);
    void addPicture(std::int64_t result, const CheckPicture& picture);
    std::int64_t image(const std::string& png);
    void addStudent(const StudentNote& note, std::int64_t result);

    RunKey key;
    std::int64_t run = 0;
    std::int64_t since = 0;  ///< the first run whose results count
};

}  // namespace radlab::grader

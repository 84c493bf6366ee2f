#include "grader/batch/StoreReader.h"

#include <limits>

#include <nlohmann/json.hpp>

#include "base/Error.h"
#include "grader/batch/StoreFile.h"

namespace radlab::grader {

namespace {

using SQLite::Column;
using SQLite::Statement;

std::uint64_t seedOf(const Column& column) { return static_cast<std::uint64_t>(column.getInt64()); }

double numberOrNone(const Column& column) {
    return column.isNull() ? std::numeric_limits<double>::quiet_NaN() : column.getDouble();
}

Outcome outcomeOf(const std::string& text) {
    for (const Outcome outcome : {Outcome::graded, Outcome::nothing, Outcome::refused})
        if (outcomeText(outcome) == text) return outcome;
    return Outcome::error;
}

std::vector<std::string> remarksOf(const SQLite::Database& database, const std::string& student, std::int64_t run) {
    Statement query(database, "SELECT text FROM remarks WHERE student = ? AND run = ? ORDER BY place");
    query.bind(1, student);
    query.bind(2, run);
    std::vector<std::string> remarks;
    while (query.executeStep()) remarks.push_back(query.getColumn(0).getString());
    return remarks;
}

void readResult(const SQLite::Database& database, std::int64_t id, StudentResult& into) {
    Statement query(database, "SELECT result, graded FROM results WHERE id = ?");
    query.bind(1, id);
    if (!query.executeStep()) return;
    into.result = resultFromJson(nlohmann::json::parse(query.getColumn(0).getString()));
    into.graded = query.getColumn(1).getString();
}

// A mark counts as given to a student once a run has noted it; `submitted` as the last of these runs knew it.
std::vector<EarlierMark> earlierMarks(const SQLite::Database& database, const std::string& student,
                                      std::int64_t current) {
    Statement query(database,
                    "SELECT results.score, results.max_score, results.graded, students.submitted, results.version, "
                    "results.seed, max(students.run) FROM students JOIN results ON results.id = students.result "
                    "WHERE students.id = ? AND results.id <> ? GROUP BY results.id ORDER BY results.id DESC");
    query.bind(1, student);
    query.bind(2, current);
    std::vector<EarlierMark> marks;
    while (query.executeStep())
        marks.push_back({query.getColumn(0).getDouble(), query.getColumn(1).getDouble(), query.getColumn(2).getString(),
                         query.getColumn(3).getString(), query.getColumn(4).getString(), seedOf(query.getColumn(5))});
    return marks;
}

std::vector<PngImage> imagesOf(const SQLite::Database& database, std::int64_t picture) {
    Statement query(database,
                    "SELECT title, png, width, height FROM picture_images JOIN images ON images.id = image "
                    "WHERE picture = ? ORDER BY place");
    query.bind(1, picture);
    std::vector<PngImage> images;
    while (query.executeStep())
        images.push_back({query.getColumn(0).getString(), query.getColumn(1).getString(), query.getColumn(2).getInt(),
                          query.getColumn(3).getInt()});
    return images;
}

}  // namespace

StoreReader::StoreReader(const std::filesystem::path& at) : StoreReader(at, openStore(at)) {}

StoreReader::StoreReader(std::filesystem::path at, SQLite::Database opened)
    : file(std::move(at)), database(std::make_unique<SQLite::Database>(std::move(opened))) {}

StoreReader::~StoreReader() = default;

std::optional<RunInfo> StoreReader::lastRun() const {
    return onStore(file, [&]() -> std::optional<RunInfo> {
        Statement query(*database, "SELECT started, ifnull(finished, ''), version, seed FROM runs ORDER BY id DESC");
        if (!query.executeStep()) return std::nullopt;
        return RunInfo{query.getColumn(0).getString(), query.getColumn(1).getString(), query.getColumn(2).getString(),
                       seedOf(query.getColumn(3))};
    });
}

std::vector<std::string> StoreReader::students() const {
    return onStore(file, [&] {
        Statement query(*database, "SELECT DISTINCT id FROM students ORDER BY id");
        std::vector<std::string> ids;
        while (query.executeStep()) ids.push_back(query.getColumn(0).getString());
        return ids;
    });
}

std::optional<StudentResult> StoreReader::find(const std::string& id) const {
    return onStore(file, [&]() -> std::optional<StudentResult> {
        Statement query(*database,
                        "SELECT name, account, submitted, late, outcome, fault, ifnull(result, 0), run FROM students "
                        "WHERE id = ? ORDER BY run DESC LIMIT 1");
        query.bind(1, id);
        if (!query.executeStep()) return std::nullopt;
        const std::int64_t result = query.getColumn(6).getInt64(), run = query.getColumn(7).getInt64();
        StudentResult found;
        found.student = {id,
                         query.getColumn(0).getString(),
                         query.getColumn(1).getString(),
                         query.getColumn(2).getString(),
                         query.getColumn(3).getInt() != 0,
                         remarksOf(*database, id, run)};
        found.outcome = outcomeOf(query.getColumn(4).getString());
        found.fault = query.getColumn(5).getString();
        found.earlier = earlierMarks(*database, id, result);
        try {
            readResult(*database, result, found);
        } catch (const nlohmann::json::exception& error) {
            throw Error({file.string()}, "the result of " + id + " is damaged: " + error.what());
        }
        return found;
    });
}

std::vector<CheckPicture> StoreReader::pictures(const std::string& student) const {
    return onStore(file, [&] {
        Statement query(*database,
                        "SELECT id, stage, check_id, caption, rms, tolerance FROM pictures WHERE result = "
                        "(SELECT result FROM students WHERE id = ? ORDER BY run DESC LIMIT 1) ORDER BY id");
        query.bind(1, student);
        std::vector<CheckPicture> pictures;
        while (query.executeStep())
            pictures.push_back({query.getColumn(1).getString(), query.getColumn(2).getString(),
                                query.getColumn(3).getString(), numberOrNone(query.getColumn(4)),
                                numberOrNone(query.getColumn(5)), imagesOf(*database, query.getColumn(0).getInt64())});
        return pictures;
    });
}

}  // namespace radlab::grader

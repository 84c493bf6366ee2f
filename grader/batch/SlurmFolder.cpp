#include "grader/batch/SlurmFolder.h"

#include <sstream>

#include <nlohmann/json.hpp>

#include "base/Error.h"
#include "base/WholeFile.h"

namespace radlab::grader {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr const char* parts[] = {"jobs", "tasks", "results", "faults", "logs"};

Json binary(const std::string& bytes) { return Json::binary({bytes.begin(), bytes.end()}); }

}  // namespace

SlurmFolder::SlurmFolder(fs::path where) : folder(fs::absolute(where)) {
    for (const char* part : parts) makeFolder(folder / part);
}

void SlurmFolder::putJob(const Job& job) const {
    Json files = Json::object();
    for (const auto& [name, contents] : job.files) files[name] = binary(contents);
    std::string bytes;
    Json::to_cbor(files, bytes);
    writeFile(folder / "jobs" / job.hash, bytes);
}

Job SlurmFolder::job(const std::string& hash) const {
    const fs::path file = folder / "jobs" / hash;
    try {
        Job job{hash, {}};
        const Json files = Json::from_cbor(readFile(file));
        for (const auto& [name, contents] : files.items())
            job.files[name].assign(contents.get_binary().begin(), contents.get_binary().end());
        return job;
    } catch (const Json::exception& error) {
        throw Error({file.string()}, error.what());
    }
}

void SlurmFolder::putTask(std::size_t task, const std::vector<std::string>& hashes) const {
    std::string lines;
    for (const std::string& hash : hashes) lines += hash + "\n";
    writeFile(folder / "tasks" / std::to_string(task), lines);
}

std::vector<std::string> SlurmFolder::task(std::size_t task) const {
    std::istringstream lines(readFile(folder / "tasks" / std::to_string(task)));
    std::vector<std::string> hashes;
    for (std::string line; std::getline(lines, line);) hashes.push_back(line);
    return hashes;
}

void SlurmFolder::putResult(const std::string& hash, const Graded& graded) const {
    writeFile(folder / "results" / hash, toCbor(graded));
}

void SlurmFolder::putFault(const std::string& hash, const std::string& reason) const {
    writeFile(folder / "faults" / hash, reason);
}

bool SlurmFolder::hasResult(const std::string& hash) const { return fs::exists(folder / "results" / hash); }

std::optional<SlurmFolder::Answer> SlurmFolder::takeAnswer(const std::string& hash) const {
    const fs::path result = folder / "results" / hash, fault = folder / "faults" / hash;
    std::optional<Answer> answer;
    if (fs::exists(result)) {
        try {
            answer = Answer{gradedFromCbor(readFile(result)), ""};
        } catch (const Error&) {  // as if it had not come
        }
        fs::remove(result);
    } else if (fs::exists(fault)) {
        answer = Answer{std::nullopt, readFile(fault)};
        fs::remove(fault);
    }
    return answer;
}

void SlurmFolder::forget(const std::string& hash) const { fs::remove(folder / "jobs" / hash); }

std::string SlurmFolder::submitted() const {
    return fs::exists(folder / "submitted") ? readFile(folder / "submitted") : "";
}

void SlurmFolder::setSubmitted(const std::string& number) const {
    if (number.empty())
        fs::remove(folder / "submitted");
    else
        writeFile(folder / "submitted", number);
}

}  // namespace radlab::grader

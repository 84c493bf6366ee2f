#include "grader/mutants/Mutant.h"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "base/Error.h"
#include "base/WholeFile.h"

namespace radlab::grader {

namespace {

using Json = nlohmann::json;

void replaceOnce(std::string& source, const std::string& from, const std::string& to) {
    const std::size_t place = source.find(from);
    if (from.empty() || place == std::string::npos) throw Error("the solution has no such text: " + from);
    if (source.find(from, place + 1) != std::string::npos) throw Error("the solution has several times: " + from);
    source.replace(place, from.size(), to);
}

// From the line that begins the definition to the closing brace at the start of a line.
void replaceFunction(std::string& source, const std::string& name, const Json& lines) {
    const std::size_t call = source.find(" " + name + "(");
    std::size_t begin = call;
    while (begin != std::string::npos && begin > 0 && source[begin - 1] != '\n') --begin;
    const std::size_t end = call == std::string::npos ? call : source.find("\n}\n", call);
    if (end == std::string::npos) throw Error("the solution defines no function " + name);
    std::string text;
    for (const Json& line : lines) text += line.get<std::string>() + "\n";
    source.replace(begin, end + 3 - begin, text);
}

Mutant mutantFrom(const Json& json, const std::string& stage, bool wrong, const std::string& solution,
                  const std::string& file) {
    Mutant mutant;
    mutant.file = file;
    mutant.stage = stage;
    mutant.wrong = wrong;
    json.at("id").get_to(mutant.id);
    if (wrong) json.at("names").get_to(mutant.names);
    mutant.source = solution;
    const Json functions = json.value("function", Json::object()), pairs = json.value("replace", Json::array());
    try {
        for (const auto& [name, lines] : functions.items()) replaceFunction(mutant.source, name, lines);
        for (const Json& pair : pairs)
            replaceOnce(mutant.source, pair.at(0).get<std::string>(), pair.at(1).get<std::string>());
    } catch (const Error& error) {
        throw Error(mutant.id + ": " + error.what());
    }
    if (mutant.source == solution) throw Error(mutant.id + ": changes nothing");
    return mutant;
}

// The solution is a file, or a folder with the file that is named.
void readFrom(const std::filesystem::path& file, const std::filesystem::path& solutions, std::vector<Mutant>& mutants) {
    try {
        const Json json = Json::parse(readFile(file));
        const bool named = std::filesystem::is_directory(solutions);
        const std::filesystem::path from = named ? solutions / json.at("file").get<std::string>() : solutions;
        const std::string solution = readFile(from);
        for (const bool wrong : {true, false})
            for (const Json& entry : json.at(wrong ? "wrong" : "right"))
                mutants.push_back(
                    mutantFrom(entry, json.at("stage").get<std::string>(), wrong, solution, from.filename().string()));
    } catch (const Json::exception& error) {
        throw Error({file.string()}, error.what());
    } catch (const Error& error) {
        throw Error({file.string()}, error.what());
    }
}

}  // namespace

std::vector<Mutant> readMutants(const std::filesystem::path& folder, const std::filesystem::path& solution) {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        if (entry.path().extension() == ".json") files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    std::vector<Mutant> mutants;
    for (const std::filesystem::path& file : files) readFrom(file, solution, mutants);
    return mutants;
}

std::vector<Mutant> projectMutants() {
    return readMutants(RADLAB_SOURCE_DIR "/grader/mutants", RADLAB_SOURCE_DIR "/solutions/ProgRef.cpp");
}

std::vector<Mutant> extensionMutants() {
    return readMutants(RADLAB_SOURCE_DIR "/grader/mutants/extensions", RADLAB_SOURCE_DIR "/solutions/extensions");
}

}  // namespace radlab::grader

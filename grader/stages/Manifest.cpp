#include "grader/stages/Manifest.h"

#include <cmath>

#include <nlohmann/json.hpp>

#include "base/Error.h"
#include "base/WholeFile.h"

namespace radlab::grader {

namespace {

using Json = nlohmann::json;

ManifestCheck checkFrom(const Json& json) {
    ManifestCheck check;
    json.at("id").get_to(check.id);
    json.at("name").get_to(check.name);
    json.at("marks").get_to(check.marks);
    check.hint = json.value("hint", "");
    check.references = json.value("references", std::vector<std::string>{});
    check.tolerance = json.value("tolerance", 0.0);
    check.needs = json.value("needs", std::vector<std::string>{});
    return check;
}

ManifestStage stageFrom(const Json& json, const std::string& file) {
    ManifestStage stage;
    json.at("stage").get_to(stage.stage);
    json.at("title").get_to(stage.title);
    json.at("marks").get_to(stage.marks);
    stage.file = json.value("file", "");
    double sum = 0.0;
    for (const Json& check : json.at("checks")) {
        stage.checks.push_back(checkFrom(check));
        sum += stage.checks.back().marks;
    }
    if (std::abs(sum - stage.marks) > 1e-9)
        throw Error({file}, stage.stage + ": marks of its checks add up to " + std::to_string(sum) + ", expected " +
                                std::to_string(stage.marks));
    return stage;
}

std::vector<ManifestStage> stagesFrom(const Json& json, int number, const std::string& file) {
    std::vector<ManifestStage> stages;
    for (const Json& stage : json) {
        stages.push_back(stageFrom(stage, file));
        stages.back().number = number++;
    }
    return stages;
}

// Names without folders: they are looked for in submissions, and written beside one another.
std::vector<std::string> filesFrom(const Json& json, const std::string& file) {
    const std::vector<std::string> names = json.get<std::vector<std::string>>();
    if (names.empty()) throw Error({file}, "files: found none, expected the one to compile, then others");
    for (const std::string& name : names)
        if (name.empty() || name == "." || name == ".." || name.find('/') != std::string::npos)
            throw Error({file}, "files: found '" + name + "', expected a name without a folder");
    return names;
}

}  // namespace

std::filesystem::path manifestFile() { return RADLAB_SOURCE_DIR "/grader/stages/manifest.json"; }

Manifest readManifest(const std::filesystem::path& file) {
    const std::string text = readFile(file);
    try {
        const Json json = Json::parse(text);
        Manifest manifest;
        manifest.files = filesFrom(json.at("files"), file.string());
        const Json& limits = json.at("limits");
        limits.at("seconds").get_to(manifest.seconds);
        limits.at("mebibytes").get_to(manifest.mebibytes);
        limits.at("compile_seconds").get_to(manifest.compileSeconds);
        manifest.stages = stagesFrom(json.at("stages"), 1, file.string());
        manifest.extensions = stagesFrom(json.value("extensions", Json::array()),
                                         static_cast<int>(manifest.stages.size()) + 1, file.string());
        return manifest;
    } catch (const Json::exception& error) {
        throw Error({file.string()}, error.what());
    }
}

const ManifestStage& Manifest::find(const std::string& nameOrNumber) const {
    const ManifestStage* found = nullptr;
    std::string names;
    std::vector<const ManifestStage*> all;
    for (const ManifestStage& stage : stages) all.push_back(&stage);
    for (const ManifestStage& extension : extensions) all.push_back(&extension);
    for (const ManifestStage* stage : all) {
        names += (names.empty() ? "" : ", ") + std::to_string(stage->number) + " " + stage->stage;
        if (stage->stage == nameOrNumber || std::to_string(stage->number) == nameOrNumber) return *stage;
        if (nameOrNumber.empty() || stage->stage.compare(0, nameOrNumber.size(), nameOrNumber) != 0) continue;
        if (found) throw Error("stage '" + nameOrNumber + "': found several, expected one of " + names);
        found = stage;
    }
    if (!found) throw Error("unknown stage '" + nameOrNumber + "': expected one of " + names);
    return *found;
}

Manifest Manifest::of(const ManifestStage& extension) const {
    Manifest alone = *this;
    alone.files = {extension.file};
    alone.stages = {extension};
    alone.extensions.clear();
    return alone;
}

}  // namespace radlab::grader

#include "grader/attacks/Attack.h"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include <nlohmann/json.hpp>

#include "base/WholeFile.h"
#include "grader/judge/Judge.h"
#include "grader/sandbox/Launch.h"
#include "grader/sandbox/Sandbox.h"

namespace radlab::grader {

namespace {

namespace fs = std::filesystem;

const fs::path root = RADLAB_SOURCE_DIR;
const fs::path folder = root / "grader/attacks";
constexpr const char* ownStage = "maxenergy_patch";
constexpr const char* otherStage = "calcAnalyticalFF";
constexpr const char* ownStart = "MyPolygon* maxenergy_patch() {";

Attack attackFrom(const nlohmann::json& json) {
    Attack attack;
    json.at("id").get_to(attack.id);
    json.at("what").get_to(attack.what);
    attack.compiles = json.value("compiles", true);
    attack.call = json.value("call", false);
    attack.twice = json.value("twice", false);
    attack.solution = json.value("base", "exercise") == "solution";
    attack.own = json.value("own", false);
    attack.other = json.value("other", false);
    attack.never = json.value("never", "");
    attack.stoppedBy = json.value("stoppedBy", std::vector<std::string>{});
    return attack;
}

std::string withStart(std::string text, const std::string& start) {
    const std::size_t place = text.find(ownStart);
    if (place == std::string::npos) throw Error("solutions/ProgRef.cpp: found no " + std::string(ownStart));
    return text.insert(place + std::string_view(ownStart).size(), "\n" + start);
}

std::string quoted(const std::string& text) { return "\"" + text + "\""; }

// What an attack leaves is called so; of this process alone, since others may try attacks at the same time.
std::string leftName() { return "radlab-breach-" + std::to_string(getpid()); }

bool isLeftBehind(const fs::path& place, std::string& why) {
    std::error_code failure;
    for (const fs::directory_entry& entry : fs::directory_iterator(place, failure))
        if (entry.path().filename().string().rfind(leftName(), 0) == 0) {
            why = entry.path().string() + " was left behind";
            fs::remove_all(entry.path(), failure);
            return true;
        }
    return false;
}

// What has ended may stay in the list until somebody asks how. The state stands after the name, which may hold anything.
bool runs(const fs::path& process) {
    std::ifstream file(process / "stat");
    std::string line;
    std::getline(file, line);
    const std::size_t end = line.rfind(") ");
    return end != std::string::npos && line.compare(end + 2, 1, "Z") != 0 && line.compare(end + 2, 1, "X") != 0;
}

// The own user of every box that this thread starts is the same; see Launch.cpp.
bool hasProcesses(uid_t user) {
    for (const fs::directory_entry& entry : fs::directory_iterator("/proc")) {
        struct stat about {};
        const std::string name = entry.path().filename().string();
        const bool process = std::all_of(name.begin(), name.end(), [](char c) { return c >= '0' && c <= '9'; });
        if (process && stat(entry.path().c_str(), &about) == 0 && about.st_uid == user && runs(entry.path()))
            return true;
    }
    return false;
}

// The kernel takes a moment to clear a namespace away, a long one on a busy machine.
bool processesStay(const Sandbox& sandbox) {
    if (!sandbox.ownUser) return false;
    for (int i = 0; i < 12000; ++i) {
        if (!hasProcesses(ownUserOfThread())) return false;
        usleep(5000);
    }
    return true;
}

std::string marksProblem(const Attack& attack, const Result& result) {
    for (const StageResult& stage : result.stages) {
        const bool right = stage.stage == ownStage ? attack.own : attack.other;
        if (stage.score != (right ? stage.maxScore : 0.0))
            return stage.stage + " has " + std::to_string(stage.score) + " of " + std::to_string(stage.maxScore) +
                   " marks, expected " + (right ? "all" : "none");
    }
    for (const StageResult& stage : result.stages)
        if (stage.status == Status::error) return stage.stage + " ended as an error of the grader";
    if (result.compiled != attack.compiles)
        return result.compiled ? "it compiles" : "it does not compile: " + result.compiler;
    return "";
}

// The line that an attack prints where it gets through; the word alone stands in its code, too, which compilers quote.
std::string breachIn(const Result& result) {
    for (const StageResult& stage : result.stages)
        for (const CheckResult& check : stage.checks)
            for (const std::string* text : {&check.output, &check.message})
                if (const std::size_t at = text->find("breach: "); at != std::string::npos)
                    return text->substr(at, text->find('\n', at) - at);
    return "";
}

std::string problemOf(const Attack& attack, const Result& result, const Sandbox& sandbox) {
    std::string why = marksProblem(attack, result);
    if (why.empty()) why = breachIn(result);
    if (why.empty() && !attack.never.empty() && resultToJson(result).dump().find(attack.never) != std::string::npos)
        why = "the result holds " + quoted(attack.never);
    for (const char* place : {"/tmp", "/var/tmp", "/dev/shm", "/", RADLAB_SOURCE_DIR, "."})
        if (why.empty() && isLeftBehind(place, why)) break;
    if (why.empty() && processesStay(sandbox)) why = "processes were left behind";
    return why;
}

std::string lackingFor(const Attack& attack, const Sandbox& sandbox) {
    const std::vector<std::string> here = protections(sandbox);
    std::string lacking;
    for (const std::string& name : attack.stoppedBy)
        if (std::find(here.begin(), here.end(), name) == here.end()) lacking += (lacking.empty() ? "" : ", ") + name;
    return lacking;
}

// The two stages with two checks each, which is enough to see through an attack.
Manifest shortened(Manifest manifest) {
    const auto isOther = [](const ManifestStage& stage) {
        return stage.stage != ownStage && stage.stage != otherStage;
    };
    manifest.stages.erase(std::remove_if(manifest.stages.begin(), manifest.stages.end(), isOther),
                          manifest.stages.end());
    for (ManifestStage& stage : manifest.stages) stage.checks.resize(std::min<std::size_t>(stage.checks.size(), 2));
    return manifest;
}

Result judged(const Attack& attack, const Toolchain& toolchain, const Manifest& manifest) {
    const TemporaryFolder place;
    writeFile(place.path() / "ProgRef.cpp", attackText(attack));
    JudgeOptions options;
    options.seed = 1;
    options.jobs = 1;
    Judge judge(manifest, toolchain, options);
    try {
        compileSubmission(place.path() / "ProgRef.cpp", place.path() / "submission.so", toolchain, manifest);
    } catch (const CompileError& error) {
        return judge.notCompiled(error.what());
    }
    return judge.judge(place.path() / "submission.so");
}

}  // namespace

std::vector<Attack> allAttacks() {
    const fs::path file = folder / "attacks.json";
    try {
        std::vector<Attack> attacks;
        const nlohmann::json list = nlohmann::json::parse(readFile(file));
        for (const nlohmann::json& one : list.at("attacks")) attacks.push_back(attackFrom(one));
        return attacks;
    } catch (const nlohmann::json::exception& error) {
        throw Error({file.string()}, error.what());
    }
}

std::string attackText(const Attack& attack) {
    std::string text = "#define ROOT " + quoted(root.string()) + "\n#define SOLUTION " +
                       quoted((root / "solutions/ProgRef.cpp").string()) + "\n#define LEFT " + quoted(leftName()) +
                       "\n" + readFile(folder / "code/prelude.h") + readFile(folder / "code" / (attack.id + ".cpp"));
    std::string start = attack.call ? "attack();\n" : "";
    if (!attack.solution) start += "throw NotImplemented(\"maxenergy_patch\");\n";
    return text + withStart(readFile(root / "solutions/ProgRef.cpp"), start);
}

AttackVerdict tryAttack(const Attack& attack, const Toolchain& toolchain, const Manifest& manifest) {
    AttackVerdict verdict;
    verdict.why = lackingFor(attack, toolchain.sandbox);
    if (!verdict.why.empty()) {
        verdict.lacksProtection = true;
        return verdict;
    }
    for (int run = 0; run < (attack.twice ? 2 : 1) && verdict.why.empty(); ++run) {
        verdict.result = judged(attack, toolchain, shortened(manifest));
        verdict.why = problemOf(attack, verdict.result, toolchain.sandbox);
    }
    verdict.stopped = verdict.why.empty();
    return verdict;
}

}  // namespace radlab::grader

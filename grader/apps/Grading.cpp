#include "grader/apps/Grading.h"

#include <algorithm>

#include "base/WholeFile.h"
#include "grader/sandbox/Process.h"
#include "grader/stages/Pictures.h"

namespace radlab::grader {

namespace {

const std::filesystem::path solutions = RADLAB_SOURCE_DIR "/solutions";

JudgeOptions oneAfterTheOther(std::uint64_t seed) {
    JudgeOptions options;
    options.seed = seed;
    options.jobs = 1;
    return options;
}

std::string firstProblem(const Result& result) {
    if (!result.compiled) return result.compiler;
    for (const StageResult& stage : result.stages)
        for (const CheckResult& check : stage.checks)
            if (check.status != Status::pass) return stage.stage + ", " + check.name + ": " + check.message;
    return "";
}

}  // namespace

Grading::Grading(std::uint64_t seed)
    : options(oneAfterTheOther(seed)),
      toolchain(readToolchain(RADLAB_TOOLCHAIN)),
      manifest(readManifest(manifestFile())),
      judge(manifest, toolchain, options) {
    encodeReferences(manifest, pictures);
}

std::vector<std::string> Grading::handedIn() const {
    std::vector<std::string> names = manifest.files;
    for (const ManifestStage& extension : manifest.extensions) names.push_back(extension.file);
    return names;
}

Graded Grading::grade(const Job& job) {
    Graded all = graded(job.files);
    addExtensions(job.files, manifest, toolchain, options, all.result);
    return all;
}

void Grading::rehearse() {
    std::map<std::string, std::string> solution;
    for (const std::string& name : manifest.files)
        if (std::filesystem::exists(solutions / name)) solution[name] = readFile(solutions / name);
    if (!solution.count(manifest.files.front())) return;
    const std::string problem = firstProblem(graded(solution).result);
    if (!problem.empty())
        throw MachineError("the solution itself loses marks on this machine, so nobody is graded: " + problem);
}

void Rehearsed::grade(const EngineCallbacks& with) {
    EngineCallbacks rehearsed = with;
    bool first = true;
    rehearsed.next = [&] {
        std::optional<Job> job = with.next();
        if (job && first) grading.rehearse();
        first = false;
        return job;
    };
    engine.grade(rehearsed);
}

std::vector<std::filesystem::path> filesOfGrader(const Toolchain& toolchain) {
    std::vector<std::filesystem::path> files, pictures;
    for (const auto& entry : std::filesystem::directory_iterator(referenceFolder()))
        if (entry.path().extension() == ".png") pictures.push_back(entry.path());
    std::sort(pictures.begin(), pictures.end());
    files = {ownProgram(), toolchain.worker, RADLAB_TOOLCHAIN, manifestFile()};
    files.insert(files.end(), pictures.begin(), pictures.end());
    return files;
}

}  // namespace radlab::grader

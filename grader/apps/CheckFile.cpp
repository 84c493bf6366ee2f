#include "grader/apps/CheckFile.h"

#include <unistd.h>

#include <cstdlib>

#include "base/ProgressBar.h"
#include "grader/apps/CompileReport.h"
#include "grader/judge/Extension.h"

namespace radlab::grader {

FileChecker::FileChecker(std::filesystem::path file, std::uint64_t chosenSeed, unsigned processes)
    : source(std::move(file)),
      seed(chosenSeed),
      jobs(processes),
      toolchain(readToolchain(RADLAB_TOOLCHAIN)),
      rules(readManifest(manifestFile())) {}

Result FileChecker::judge(const std::vector<std::string>& stages) const {
    ProgressBar bar("checking", 1.0);
    bar.show(0.0, "compiling " + source.filename().string());
    JudgeOptions reporting = options(stages);
    reporting.report = [&](std::size_t done, std::size_t total, const std::string& now) {
        bar.show(static_cast<double>(done) / static_cast<double>(total), now);
    };
    Result result = Judge(rules, toolchain, reporting).judgeFile(source);
    result.submission = shownName();
    return result;
}

Result FileChecker::notCompiled(const std::vector<std::string>& stages, const std::string& compilerSaid) const {
    Result result = Judge(rules, toolchain, options(stages)).notCompiled(compilerSaid);
    result.submission = shownName();
    return result;
}

Result FileChecker::judgeExtensions(const std::vector<ManifestStage>& extensions,
                                    const std::filesystem::path& folder) const {
    ProgressBar bar("checking", static_cast<double>(extensions.size()));
    Result all;
    for (std::size_t i = 0; i < extensions.size(); ++i) {
        const std::filesystem::path file = folder / extensions[i].file;
        JudgeOptions reporting = options({});
        reporting.report = [&](std::size_t done, std::size_t total, const std::string& now) {
            bar.show(static_cast<double>(i) + static_cast<double>(done) / static_cast<double>(total), now);
        };
        Result one = judgeExtension(extensions[i], file, rules, toolchain, reporting);
        one.extensions.insert(one.extensions.begin(), all.extensions.begin(), all.extensions.end());
        one.seconds += all.seconds;
        if (!one.compiled && all.compiled) one.compiler = shownError(one.compiler, file);
        if (!all.compiled) one.compiler = all.compiler;
        one.compiled = one.compiled && all.compiled;
        all = one;
    }
    const std::filesystem::path judged = extensions.size() == 1 ? folder / extensions[0].file : folder;
    all.submission = std::filesystem::proximate(judged).string();
    return all;
}

JudgeOptions FileChecker::options(const std::vector<std::string>& stages) const {
    JudgeOptions options;
    options.seed = seed;
    options.jobs = jobs;
    options.stages = stages;
    return options;
}

std::string FileChecker::shownName() const { return std::filesystem::proximate(source).string(); }

int exitCode(const Result& result) {
    bool right = true;
    for (const std::vector<StageResult>* stages : {&result.stages, &result.extensions})
        for (const StageResult& stage : *stages) {
            if (stage.status == Status::error) return 3;
            right = right && stage.status == Status::pass;
        }
    return right ? 0 : 1;
}

bool wantsColor() {
    const char* terminal = std::getenv("TERM");
    const char* refused = std::getenv("NO_COLOR");
    return isatty(STDOUT_FILENO) && terminal && std::string(terminal) != "dumb" && !(refused && *refused);
}

}  // namespace radlab::grader

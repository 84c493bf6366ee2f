#include "grader/judge/Extension.h"

namespace radlab::grader {

namespace {

Result judged(Judge& judge, const std::filesystem::path& file) {
    std::error_code failure;
    if (!std::filesystem::exists(file, failure)) return judge.notStarted();
    try {
        return judge.judgeFile(file);
    } catch (const CompileError& error) {
        return judge.notCompiled(error.what());
    }
}

}  // namespace

Result judgeExtension(const ManifestStage& extension, const std::filesystem::path& file, const Manifest& manifest,
                      const Toolchain& toolchain, JudgeOptions options) {
    options.stages.clear();
    Judge judge(manifest.of(extension), toolchain, std::move(options));
    Result result = judged(judge, file);
    result.extensions = std::move(result.stages);
    result.stages.clear();
    result.score = result.maxScore = 0.0;
    return result;
}

}  // namespace radlab::grader

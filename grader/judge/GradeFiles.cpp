#include "grader/judge/GradeFiles.h"

#include "base/ImageFile.h"
#include "base/WholeFile.h"
#include "grader/judge/Extension.h"
#include "grader/sandbox/Process.h"
#include "grader/stages/Pictures.h"

namespace radlab::grader {

namespace {

// Where a submission was compiled is nobody's business, and another place each time.
std::string withoutFolder(std::string text, const std::filesystem::path& folder) {
    const std::string start = folder.string() + "/";
    for (std::size_t at = text.find(start); at != text.npos; at = text.find(start, at)) text.erase(at, start.size());
    return text;
}

void refuseFaults(const Result& result) {
    for (const StageResult& stage : result.stages)
        for (const CheckResult& check : stage.checks)
            if (check.status == Status::error)
                throw MachineError(stage.stage + ", check " + check.id + ": " + check.message);
}

CheckPicture encoded(const std::string& stage, const CheckResult& check, PngCache& cache) {
    const Picture& picture = *check.picture;
    CheckPicture result{stage, check.id, picture.caption, picture.rms, picture.tolerance, {}};
    for (const auto& [title, image] : {std::pair<const char*, const Image*>{"reference", &picture.reference},
                                       {"yours", &picture.found},
                                       {"difference", &picture.difference}})
        if (!image->empty()) result.images.push_back({title, cache.bytes(*image), image->width(), image->height()});
    return result;
}

}  // namespace

Graded gradeFiles(const std::map<std::string, std::string>& files, const std::string& main, Judge& judge,
                  PngCache& pictures) {
    RADLAB_CHECK(files.count(main) == 1u);
    const TemporaryFolder folder;
    for (const auto& [name, contents] : files) {
        RADLAB_CHECK(std::filesystem::path(name).filename() == name);
        writeFile(folder.path() / name, contents);
    }
    Graded graded;
    try {
        graded.result = judge.judgeFile(folder.path() / main);
    } catch (const CompileError& error) {
        graded.result = judge.notCompiled(error.what());
    }
    refuseFaults(graded.result);
    graded.result.submission = main;
    graded.result.compiler = withoutFolder(graded.result.compiler, folder.path());
    for (StageResult& stage : graded.result.stages)
        for (CheckResult& check : stage.checks)
            if (check.picture) graded.pictures.push_back(encoded(stage.stage, check, pictures));
    return graded;
}

void addExtensions(const std::map<std::string, std::string>& files, const Manifest& manifest,
                   const Toolchain& toolchain, const JudgeOptions& options, Result& result) {
    for (const ManifestStage& extension : manifest.extensions) {
        const auto file = files.find(extension.file);
        if (file == files.end()) continue;
        const TemporaryFolder folder;
        writeFile(folder.path() / extension.file, file->second);
        const Result judged = judgeExtension(extension, folder.path() / extension.file, manifest, toolchain, options);
        result.extensions.insert(result.extensions.end(), judged.extensions.begin(), judged.extensions.end());
        const std::string said = withoutFolder(judged.compiler, folder.path());
        if (!said.empty()) result.compiler += (result.compiler.empty() ? "" : "\n") + said;
    }
}

void encodeReferences(const Manifest& manifest, PngCache& pictures) {
    for (const ManifestStage& stage : manifest.stages)
        for (const ManifestCheck& line : stage.checks)
            for (const std::string& name : line.references)
                pictures.bytes(readImage(std::filesystem::path(referenceFolder()) / name));
}

}  // namespace radlab::grader

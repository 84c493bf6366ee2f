#include "apps/EffectRun.h"

#include <algorithm>
#include <filesystem>

#include "base/Stopwatch.h"

namespace radlab {

namespace {

SceneInput inputOf(const std::string& file, double about, const std::vector<std::string>& force) {
    SceneFlags flags;
    flags.file = file;
    flags.patches = about;
    flags.force = force;
    return readSceneInput(flags);
}

}  // namespace

EffectRun::EffectRun(const std::string& file, double about, const std::vector<std::string>& force)
    : input(inputOf(file, about, force)) {
    const Stopwatch watch;
    PictureFlags flags;
    flags.width = flags.height = 200;
    solution = solveByFormFactors(input, {});
    picture = drawSolution(flags, input, solution);
    seconds = watch.seconds();
}

std::vector<std::string> projectScenes() {
    std::vector<std::string> files;
    for (const auto& entry : std::filesystem::directory_iterator(RADLAB_SOURCE_DIR "/resources/scenes"))
        if (entry.path().extension() == ".x3d") files.push_back(entry.path().string());
    std::sort(files.begin(), files.end());
    return files;
}

}  // namespace radlab

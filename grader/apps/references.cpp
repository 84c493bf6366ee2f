// Makes the reference images of the grader from the solution, and those of the older shooting rule from OlderStyle.cpp.

#include <algorithm>
#include <iostream>

#include "apps/CommandLine.h"
#include "base/ImageFile.h"
#include "grader/judge/Worker.h"
#include "grader/stages/Pictures.h"

using namespace radlab::grader;

namespace {

class Maker {
public:
    Maker() : toolchain(readToolchain(RADLAB_TOOLCHAIN)), manifest(readManifest(manifestFile())) {
        compileSubmission(RADLAB_SOURCE_DIR "/solutions/ProgRef.cpp", byPower(), toolchain, manifest);
        compileSubmission(RADLAB_SOURCE_DIR "/solutions/OlderStyle.cpp", byRadiosity(), toolchain, manifest);
    }

    // A check has one reference, or two where the shooting rule shows.
    void make(const ManifestCheck& check, const std::string& folder) const {
        const std::vector<PictureCase> cases = pictureCases();
        const auto found =
            std::find_if(cases.begin(), cases.end(), [&](const PictureCase& c) { return c.check == check.id; });
        if (found == cases.end()) throw radlab::Error(check.id + ": no such picture");
        for (std::size_t i = 0; i < check.references.size(); ++i)
            make(*found, i ? byRadiosity() : byPower(), folder + "/" + check.references[i]);
    }

    const Manifest& lines() const { return manifest; }

private:
    std::filesystem::path byPower() const { return libraries.path() / "power.so"; }
    std::filesystem::path byRadiosity() const { return libraries.path() / "radiosity.so"; }

    void make(const PictureCase& picture, const std::filesystem::path& library, const std::string& file) const {
        const std::vector<Step> steps = picture.steps();
        const WorkerRun made = Worker(library, toolchain, manifest).run(steps, manifest.seconds);
        if (made.run.answers.size() != steps.size()) throw radlab::Error(picture.check + ": " + made.run.cause);
        const std::string problem = picture.problem ? picture.problem(steps, made.run.answers) : "";
        if (!problem.empty()) throw radlab::Error(picture.check + ": " + problem);
        radlab::writeImage(file, picture.draw(steps, made.run.answers));
        std::cout << "made " << file << '\n';
    }

    TemporaryFolder libraries;
    Toolchain toolchain;
    Manifest manifest;
};

}  // namespace

int main(int argc, char** argv) {
    CLI::App flags("Makes the reference images of the grader from the solutions.");
    std::string folder = referenceFolder();
    flags.add_option("--out", folder, "The folder to write to")->capture_default_str();
    return radlab::runCommandLine(flags, argc, argv, [&] {
        const Maker maker;
        for (const ManifestStage& stage : maker.lines().stages)
            for (const ManifestCheck& check : stage.checks)
                if (!check.references.empty()) maker.make(check, folder);
        return 0;
    });
}

#pragma once

#include <string>
#include <vector>

#include "grader/batch/LocalEngine.h"
#include "grader/judge/GradeFiles.h"

namespace radlab::grader {

/// Grades submissions on this machine, one check after the other in each.
class Grading {
public:
    explicit Grading(std::uint64_t seed);

    const Toolchain& tools() const { return toolchain; }
    const Manifest& rules() const { return manifest; }

    /// What is handed in: the file to compile, then others, last those of the extensions.
    std::vector<std::string> handedIn() const;

    Graded grade(const Job& job);

    /// Makes sure that grading is fair here, and does once what all submissions need: the solution gets all marks.
    ///
    /// Errors: MachineError, where it does not.
    /// @cost two seconds; nothing where there is no solution, as in the package that students get
    void rehearse();

private:
    Graded graded(const std::map<std::string, std::string>& files) {
        return gradeFiles(files, manifest.files.front(), judge, pictures);
    }

    JudgeOptions options;
    Toolchain toolchain;
    Manifest manifest;
    Judge judge;
    PngCache pictures;
};

/// An engine that rehearses before its first job.
class Rehearsed : public Engine {
public:
    Rehearsed(Grading& with, Engine& then) : grading(with), engine(then) {}

    void grade(const EngineCallbacks& with) override;

private:
    Grading& grading;
    Engine& engine;
};

/// All that decides on a mark: the judge, the worker, how submissions are compiled, marks, and reference pictures.
std::vector<std::filesystem::path> filesOfGrader(const Toolchain& toolchain);

}  // namespace radlab::grader

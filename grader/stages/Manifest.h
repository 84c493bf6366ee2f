#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace radlab::grader {

/// A line of the manifest: one claim and its marks.
struct ManifestCheck {
    std::string id;
    std::string name;
    double marks = 0.0;
    std::string hint;
    std::vector<std::string> references;  ///< of a picture: files in resources/reference, each of which is right
    double tolerance = 0.0;               ///< of a picture: the largest RMS difference that passes
    std::vector<std::string> needs;       ///< stages that must pass before it can be judged
};

/// A stage of the exercise, or all of them together.
struct ManifestStage {
    int number = 0;
    std::string stage;
    std::string title;
    double marks = 0.0;
    std::vector<ManifestCheck> checks;
};

/// Order, titles, marks, checks and hints of the grader, out of one data file.
struct Manifest {
    std::vector<std::string> files;  ///< what is handed in; the first is compiled, and finds the others beside it
    std::vector<ManifestStage> stages;
    double seconds = 0.0;    ///< limit of a check
    double mebibytes = 0.0;  ///< limit of a check's memory
    double compileSeconds = 0.0;

    /// The stage of that name, number, or beginning of a name.
    ///
    /// Errors: none or several, with the names that there are.
    const ManifestStage& find(const std::string& nameOrNumber) const;
};

/// Reads the manifest.
///
/// Errors: with the file's name, what is missing or of the wrong kind; marks of checks that do not add up to their stage's.
Manifest readManifest(const std::filesystem::path& file);

/// The one that the project comes with.
std::filesystem::path manifestFile();

}  // namespace radlab::grader

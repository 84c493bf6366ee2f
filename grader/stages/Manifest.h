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

/// A stage of the exercise, all of them together, or an extension.
struct ManifestStage {
    int number = 0;
    std::string stage;
    std::string title;
    double marks = 0.0;  ///< of an extension: they say how much of it is right, and count for nothing
    std::vector<ManifestCheck> checks;
    std::string file;  ///< of an extension: its own, in exercises/extensions; else empty

    bool isExtension() const { return !file.empty(); }
};

/// Order, titles, marks, checks and hints of the grader, out of one data file.
struct Manifest {
    std::vector<std::string> files;  ///< what is handed in; the first is compiled, and finds the others beside it
    std::vector<ManifestStage> stages;
    std::vector<ManifestStage> extensions;  ///< numbered on after the stages
    double seconds = 0.0;                   ///< limit of a check
    double mebibytes = 0.0;                 ///< limit of a check's memory
    double compileSeconds = 0.0;

    /// The stage or extension of that name, number, or beginning of a name.
    ///
    /// Errors: none or several, with the names that there are.
    const ManifestStage& find(const std::string& nameOrNumber) const;

    /// The manifest of an extension alone: its file is what is handed in, and it is the one stage.
    Manifest of(const ManifestStage& extension) const;
};

/// Reads the manifest.
///
/// Errors: with the file's name, what is missing or of the wrong kind; marks of checks that do not add up to their stage's.
Manifest readManifest(const std::filesystem::path& file);

/// The one that the project comes with.
std::filesystem::path manifestFile();

}  // namespace radlab::grader

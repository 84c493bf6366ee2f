#pragma once

#include <filesystem>
#include <future>
#include <optional>
#include <string>

namespace radlab {

/// How a library with the six functions is made.
struct LibraryRecipe {
    std::filesystem::path source;   ///< the file that is watched
    std::filesystem::path folder;   ///< of the build
    std::string target;             ///< of the build, which makes the library of the source
    std::filesystem::path library;  ///< that the target writes
};

/// What came of a build.
struct LibraryOutcome {
    std::filesystem::path library;  ///< a copy under a name that was not used before; empty where the build failed
    std::string error;              ///< the compiler's first error, with its file and line
    std::string stamp;              ///< of the source that was built; another text has another one
};

/// Builds the library in the background, at first and whenever the source is saved.
class LibraryBuild {
public:
    explicit LibraryBuild(LibraryRecipe recipe);
    ~LibraryBuild();
    LibraryBuild(const LibraryBuild&) = delete;
    LibraryBuild& operator=(const LibraryBuild&) = delete;

    /// Starts a build where the source has changed, and says what came of one that has ended since the last call.
    ///
    /// Takes no time; to be called again and again.
    std::optional<LibraryOutcome> poll();

    bool isBuilding() const { return running.valid(); }

    /// Builds nothing while the source is what it was when it had that stamp.
    void passOver(const std::string& stamp) { built = stamp; }

private:
    std::string stampOf() const;

    const LibraryRecipe recipe;
    std::string built, seen;  // stamps of the source
    int copies = 0;
    std::future<LibraryOutcome> running;
};

/// The first error in what a build printed, with the lines that explain it, paths counted from the project.
///
/// @return all of it, shortened, where no line looks like an error
std::string firstErrorIn(const std::string& output, const std::string& project);

}  // namespace radlab

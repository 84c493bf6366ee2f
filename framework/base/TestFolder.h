#pragma once

// A folder of its own for a test that writes files.

#include <filesystem>
#include <random>
#include <string>
#include <vector>

namespace radlab::test {

/// An empty folder that goes with everything in it.
class Folder {
public:
    Folder()
        : path(std::filesystem::temp_directory_path() / ("radlab-test-" + std::to_string(std::random_device()()))) {
        std::filesystem::create_directory(path);
    }
    ~Folder() {
        std::error_code ignored;
        std::filesystem::remove_all(path, ignored);
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    std::filesystem::path operator/(const std::string& name) const { return path / name; }

    /// How many files and folders lie in it.
    std::size_t entries() const {
        std::size_t count = 0;
        for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(path)) ++count;
        return count;
    }

private:
    std::filesystem::path path;
};

}  // namespace radlab::test

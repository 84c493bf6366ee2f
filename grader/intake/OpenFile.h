#pragma once

#include <sys/stat.h>

#include <exception>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace radlab::grader {

// Files and folders of strangers: nothing is followed, and nothing is opened that could block or act.

/// A file descriptor, closed when it goes.
class OpenFile {
public:
    OpenFile() = default;
    explicit OpenFile(int owned) : descriptor(owned) {}
    ~OpenFile();
    OpenFile(OpenFile&& other) noexcept : descriptor(std::exchange(other.descriptor, -1)) {}
    OpenFile& operator=(OpenFile&& other) noexcept {
        std::swap(descriptor, other.descriptor);
        return *this;
    }
    int get() const { return descriptor; }

private:
    int descriptor = -1;
};

/// Something that cannot be taken for what it is; what() says why, and begins with no name.
class NotTaken : public std::exception {
public:
    explicit NotTaken(std::string reason) : text(std::move(reason)) {}
    const char* what() const noexcept override { return text.c_str(); }

private:
    std::string text;
};

/// An entry of a folder.
struct FolderEntry {
    std::string name;
    struct stat about = {};
};

/// "a symbolic link, which is not followed" and the like; empty for files and folders.
std::string refusedKind(mode_t mode);

/// Opens a file or folder of a class' folder: links on the way there are the instructor's own.
///
/// Errors: as openBelow.
OpenFile openPlace(const std::string& path);

/// Opens a file or folder below another, no link on the way followed.
///
/// @param path with '/'; "" for the folder itself
/// Errors: NotTaken for links, special files and what may not be read; MachineError for what the disk does.
OpenFile openBelow(const OpenFile& folder, const std::string& path);

/// What lies in a folder, in no order, "." and ".." left out.
///
/// @return nothing where there are more than `most`
/// Errors: as openBelow.
std::optional<std::vector<FolderEntry>> entriesOf(const OpenFile& folder, std::size_t most);

/// The contents of a regular file.
///
/// Errors: as openBelow; NotTaken for one of more than `most` bytes.
std::string contentsOf(const OpenFile& file, std::size_t most);

}  // namespace radlab::grader

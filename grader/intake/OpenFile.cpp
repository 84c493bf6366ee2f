#include "grader/intake/OpenFile.h"

#include <dirent.h>
#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <memory>

#include "grader/intake/Remarks.h"
#include "grader/sandbox/Process.h"

namespace radlab::grader {

namespace {

constexpr int harmless = O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC | O_NOCTTY;

// What the one who handed it in could cause is told; all else is the machine's fault.
[[noreturn]] void fail(const std::string& what) {
    const int cause = errno;
    if (cause == EACCES || cause == EPERM) throw NotTaken("may not be read");
    if (cause == ELOOP || cause == ENOTDIR || cause == ENXIO) throw NotTaken("changed while it was looked at");
    throw MachineError(shownName(what) + ": " + std::strerror(cause));
}

struct stat aboutNamed(int folder, const std::string& name) {
    struct stat about = {};
    if (fstatat(folder, name.c_str(), &about, AT_SYMLINK_NOFOLLOW) != 0) fail(name);
    return about;
}

OpenFile opened(int folder, const std::string& name) {
    const std::string refused = refusedKind(aboutNamed(folder, name).st_mode);  // opening some devices has effects
    if (!refused.empty()) throw NotTaken(refused);
    OpenFile file(openat(folder, name.c_str(), harmless));
    if (file.get() < 0) fail(name);
    struct stat about = {};
    if (fstat(file.get(), &about) != 0) fail(name);
    if (!refusedKind(about.st_mode).empty()) throw NotTaken("changed while it was looked at");
    return file;
}

struct Close {
    void operator()(DIR* listing) const { closedir(listing); }
};

bool isDots(const char* name) { return std::strcmp(name, ".") == 0 || std::strcmp(name, "..") == 0; }

}  // namespace

OpenFile::~OpenFile() {
    if (descriptor >= 0) close(descriptor);
}

std::string refusedKind(mode_t mode) {
    if (S_ISREG(mode) || S_ISDIR(mode)) return "";
    if (S_ISLNK(mode)) return "a symbolic link, which is not followed";
    if (S_ISFIFO(mode)) return "a named pipe, which is not read";
    if (S_ISSOCK(mode)) return "a socket, which is not read";
    return "a device, which is not read";
}

OpenFile openPlace(const std::string& path) { return opened(AT_FDCWD, path); }

OpenFile openBelow(const OpenFile& folder, const std::string& path) {
    if (path.empty()) return opened(folder.get(), ".");
    OpenFile above;
    std::size_t begin = 0;
    const auto here = [&] { return above.get() < 0 ? folder.get() : above.get(); };
    for (std::size_t slash; (slash = path.find('/', begin)) != std::string::npos; begin = slash + 1)
        above = opened(here(), path.substr(begin, slash - begin));
    return opened(here(), path.substr(begin));
}

std::optional<std::vector<FolderEntry>> entriesOf(const OpenFile& folder, std::size_t most) {
    const int copy = openat(folder.get(), ".", harmless | O_DIRECTORY);  // closed by closedir
    if (copy < 0) fail("a folder");
    const std::unique_ptr<DIR, Close> listing(fdopendir(copy));
    if (!listing) fail("a folder");
    std::vector<FolderEntry> entries;
    for (errno = 0; const dirent* entry = readdir(listing.get()); errno = 0) {
        if (isDots(entry->d_name)) continue;
        if (entries.size() == most) return {};
        entries.push_back({entry->d_name, aboutNamed(folder.get(), entry->d_name)});
    }
    if (errno != 0) fail("a folder");
    return entries;
}

std::string contentsOf(const OpenFile& file, std::size_t most) {
    struct stat about = {};
    if (fstat(file.get(), &about) != 0) fail("a file");
    if (!S_ISREG(about.st_mode)) throw NotTaken("is no file");
    const std::string tooLarge =
        "too large: found " + std::to_string(about.st_size) + " bytes, expected at most " + std::to_string(most);
    if (static_cast<std::uintmax_t>(about.st_size) > most) throw NotTaken(tooLarge);
    std::string contents;
    std::array<char, 1 << 16> block;
    for (ssize_t got; (got = read(file.get(), block.data(), block.size())) != 0;) {
        if (got < 0) fail("a file");
        contents.append(block.data(), static_cast<std::size_t>(got));
        if (contents.size() > most) throw NotTaken("it grew while it was read");
    }
    return contents;
}

}  // namespace radlab::grader

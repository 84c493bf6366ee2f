#include "grader/sandbox/TemporaryFolder.h"

#include <sys/stat.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <string>

#include "base/TemporaryPlace.h"
#include "grader/sandbox/Pipes.h"

namespace radlab::grader {

namespace {

namespace fs = std::filesystem;

constexpr const char* prefix = "radlab-";
constexpr std::chrono::hours oldEnough{24};  // whose maker has gone, or forgotten it

void removeLeftOvers(const fs::path& among) {
    std::error_code failure;
    for (const fs::directory_entry& entry : fs::directory_iterator(among, failure)) {
        struct stat about {};
        if (entry.path().filename().string().rfind(prefix, 0) != 0 || lstat(entry.path().c_str(), &about) != 0)
            continue;
        if (!S_ISDIR(about.st_mode) || about.st_uid != geteuid()) continue;
        const auto age = std::chrono::system_clock::now() - std::chrono::system_clock::from_time_t(about.st_mtime);
        if (age > oldEnough) fs::remove_all(entry.path(), failure);
    }
}

}  // namespace

TemporaryFolder::TemporaryFolder() : maker(getpid()) {
    static const bool removed = (removeLeftOvers(temporaryPlace()), true);
    (void)removed;
    std::string name = (temporaryPlace() / prefix).string() + "XXXXXX";
    if (!mkdtemp(name.data()) || chmod(name.c_str(), 0711) != 0) failWithErrno(name + ": the folder cannot be made");
    folder = name;
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;
    if (getpid() == maker) fs::remove_all(folder, ignored);
}

}  // namespace radlab::grader

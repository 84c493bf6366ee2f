#include "base/TemporaryPlace.h"

#include "base/Error.h"

#ifdef __linux__
#include <sys/statvfs.h>
#include <unistd.h>
#endif

namespace radlab {

#ifdef __linux__

namespace {

bool mayHoldPrograms(const std::filesystem::path& folder) {
    struct statvfs about {};
    return access(folder.c_str(), W_OK | X_OK) == 0 && statvfs(folder.c_str(), &about) == 0 &&
           (about.f_flag & ST_NOEXEC) == 0;
}

// What root starts as another user has to get there.
bool othersMayEnter(std::filesystem::path folder) {
    std::error_code failure;
    for (; folder.has_relative_path(); folder = folder.parent_path())
        if ((std::filesystem::status(folder, failure).permissions() & std::filesystem::perms::others_exec) ==
            std::filesystem::perms::none)
            return false;
    return true;
}

}  // namespace

std::filesystem::path temporaryPlace() {
    std::error_code failure;
    const std::filesystem::path own = std::filesystem::temp_directory_path(failure);
    for (const bool forOthers : {true, false})
        for (const std::filesystem::path& place :
             {own, std::filesystem::path("/var/tmp"), std::filesystem::path("/dev/shm")}) {
            if (place.empty() || !mayHoldPrograms(place)) continue;
            if (!forOthers || geteuid() != 0 || othersMayEnter(place)) return place;
        }
    throw Error(
        "no program can be started from " + (own.empty() ? "/tmp" : own.string()) +
        ", /var/tmp or /dev/shm: set TMPDIR to a folder that you may write to, on a file system without noexec");
}

#else

std::filesystem::path temporaryPlace() { return std::filesystem::temp_directory_path(); }

#endif

}  // namespace radlab

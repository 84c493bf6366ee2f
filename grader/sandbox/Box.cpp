#include "grader/sandbox/Box.h"

#include <map>
#include <mutex>

#include "grader/sandbox/Process.h"
#include "grader/sandbox/TemporaryFolder.h"

namespace radlab::grader {

namespace {

namespace fs = std::filesystem;

using Arguments = std::vector<std::string>;

void add(Arguments& arguments, const Arguments& more) { arguments.insert(arguments.end(), more.begin(), more.end()); }

// The same under the same name; a link is made again, as the folder that it leads to may not be there otherwise.
void show(Arguments& arguments, const fs::path& path) {
    std::error_code failure;
    if (fs::is_symlink(path, failure))
        add(arguments, {"--symlink", fs::read_symlink(path).string(), path.string()});
    else if (fs::exists(path, failure))
        add(arguments, {"--ro-bind", path.string(), path.string()});
}

bool all(const fs::path& path, fs::perms wanted) {
    std::error_code failure;
    return (fs::status(path, failure).permissions() & wanted) == wanted;
}

bool allMayRead(const fs::path& path) {
    constexpr fs::perms enter = fs::perms::others_exec, read = fs::perms::others_read;
    for (fs::path above = path.parent_path(); above.has_relative_path(); above = above.parent_path())
        if (!all(above, enter)) return false;
    if (!fs::is_directory(path)) return all(path, read);
    if (!all(path, read | enter)) return false;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(path))
        if (!all(entry.path(), entry.is_directory() ? read | enter : read)) return false;
    return true;
}

void letAllRead(const fs::path& path) {
    fs::permissions(path, fs::perms::group_read | fs::perms::others_read, fs::perm_options::add);
    if (fs::is_directory(path) || all(path, fs::perms::owner_exec))
        fs::permissions(path, fs::perms::group_exec | fs::perms::others_exec, fs::perm_options::add);
}

void copyForAll(const fs::path& from, const fs::path& to) {
    fs::copy(from, to, fs::copy_options::recursive);
    letAllRead(to);
    if (fs::is_directory(to))
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator(to)) letAllRead(entry.path());
}

}  // namespace

fs::path Box::show(const fs::path& here, const fs::path& there) {
    readOnly.push_back({here, there});
    return sandbox.bubblewrap.empty() ? here : there;
}

fs::path readableByAll(const fs::path& path, const Sandbox& sandbox) {
    static std::mutex one;
    static const TemporaryFolder copies;
    static std::map<fs::path, fs::path> known;
    const std::scoped_lock lock(one);
    if (!sandbox.ownUser) return path;
    const auto [place, isNew] = known.try_emplace(path, path);
    try {
        if (!isNew || allMayRead(path)) return place->second;
        const fs::path copy = copies.path() / std::to_string(known.size()) / path.filename();
        fs::create_directories(copy.parent_path());
        letAllRead(copy.parent_path());
        copyForAll(path, copy);
        return place->second = copy;
    } catch (const fs::filesystem_error& error) {
        known.erase(place);
        throw MachineError(std::string("what a program in its box needs cannot be copied: ") + error.what());
    }
}

std::vector<std::string> bubblewrapArguments(const Box& box, int filter) {
    Arguments arguments = {box.sandbox.bubblewrap.string(),
                           "--unshare-all",
                           "--unshare-user",
                           "--disable-userns",
                           "--die-with-parent",
                           "--new-session",
                           "--hostname",
                           "radlab",
                           "--cap-drop",
                           "ALL"};
    for (const char* library :
         {"/usr/lib", "/usr/lib64", "/lib", "/lib64", "/etc/ld.so.cache", "/usr/share/glvnd", "/etc/glvnd"})
        show(arguments, library);
    if (box.programs)
        for (const char* folder : {"/usr/bin", "/bin", "/usr/include", "/usr/libexec", "/usr/local/bin",
                                   "/usr/local/lib", "/usr/local/include", "/etc/alternatives"})
            show(arguments, folder);
    // First, or else it would cover what is shown of a project that lies below /tmp itself.
    if (box.scratch) add(arguments, {"--size", std::to_string(box.scratch), "--tmpfs", "/tmp"});
    for (const Box::Shown& shown : box.readOnly)
        add(arguments, {"--ro-bind", shown.here.string(), shown.there.string()});
    add(arguments, {"--size", "65536", "--tmpfs", "/dev"});
    for (const char* device : {"/dev/null", "/dev/zero", "/dev/full", "/dev/random", "/dev/urandom"})
        add(arguments, {"--dev-bind", device, device});
    add(arguments, {"--remount-ro", "/dev"});
    if (box.processFiles) add(arguments, {"--proc", "/proc"});
    if (filter >= 0) add(arguments, {"--seccomp", std::to_string(filter)});
    add(arguments, {"--remount-ro", "/", "--"});
    return arguments;
}

}  // namespace radlab::grader

#include "grader/sandbox/ControlGroup.h"

#include <unistd.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <fstream>
#include <sstream>
#include <thread>

#include "grader/sandbox/Pipes.h"
#include "grader/sandbox/Process.h"

namespace radlab::grader {

namespace {

namespace fs = std::filesystem;

constexpr const char prefix[] = "radlab-";
constexpr int triesToRemove = 12000;  // of 5 ms: what was killed takes a moment to go, a long one on a busy machine

// A file of the kernel takes a value whole, or says no at once.
bool put(const fs::path& file, const std::string& value) {
    std::ofstream out(file);
    out << value;
    out.flush();
    return out.good();
}

std::string contents(const fs::path& file) {
    std::ifstream in(file);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

bool hasWord(const std::string& list, const std::string& word, char separator) {
    std::istringstream words(list);
    for (std::string one; std::getline(words, one, separator);)
        if (one == word) return true;
    return false;
}

struct Mount {
    fs::path root, place;
    std::string kind, options;
};

// Lines of mountinfo: id, parent, device, root, place, …, "-", kind, source, options.
std::vector<Mount> mounts(const fs::path& root) {
    std::vector<Mount> all;
    std::istringstream lines(contents(root / "proc/self/mountinfo"));
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string skipped, word;
        Mount mount;
        words >> skipped >> skipped >> skipped >> mount.root >> mount.place;
        while (words >> word && word != "-") {
        }
        words >> mount.kind >> skipped >> mount.options;
        all.push_back(mount);
    }
    return all;
}

// The group that this process is in, as a folder; empty where there is none. Lines of cgroup: number, controllers, path.
fs::path ownGroup(const fs::path& root, const std::string& controller) {
    std::istringstream lines(contents(root / "proc/self/cgroup"));
    for (std::string line; std::getline(lines, line);) {
        const std::size_t first = line.find(':'), second = line.find(':', first + 1);
        if (second == std::string::npos) continue;
        const std::string controllers = line.substr(first + 1, second - first - 1);
        if (controller.empty() ? !controllers.empty() : !hasWord(controllers, controller, ',')) continue;
        for (const Mount& mount : mounts(root)) {
            const bool fits = controller.empty() ? mount.kind == "cgroup2"
                                                 : mount.kind == "cgroup" && hasWord(mount.options, controller, ',');
            if (!fits) continue;
            const fs::path place = root / mount.place.relative_path();
            const fs::path inside = fs::path(line.substr(second + 1)).lexically_relative(mount.root);
            std::error_code failure;
            const bool shown = !inside.empty() && *inside.begin() != ".." && fs::exists(place / inside, failure);
            return shown ? (place / inside).lexically_normal() : place;
        }
    }
    return {};
}

std::string newName() {
    static std::atomic<unsigned> count = 0;
    return prefix + std::to_string(getpid()) + "-" + std::to_string(count++);
}

// What a judge left that was killed itself: groups named after a process that is no more.
void removeLeftOvers(const fs::path& place) {
    std::error_code failure;
    for (const fs::directory_entry& entry : fs::directory_iterator(place, failure)) {
        const std::string name = entry.path().filename().string();
        pid_t judge = 0;
        if (name.rfind(prefix, 0) != 0 || !(std::istringstream(name.substr(std::size(prefix) - 1)) >> judge)) continue;
        if (kill(judge, 0) != 0 && errno == ESRCH) rmdir(entry.path().c_str());
    }
}

// Whether a group can be made there that has such a limit.
bool offers(const fs::path& place, const std::string& limit) {
    if (place.empty()) return false;
    removeLeftOvers(place);
    const fs::path trial = place / newName();
    std::error_code failure;
    if (!fs::create_directory(trial, failure)) return false;
    const bool there = fs::exists(trial / limit, failure) && access((trial / limit).c_str(), W_OK) == 0;
    fs::remove(trial, failure);
    return there;
}

}  // namespace

ControlGroupPlaces findControlGroupPlaces(const fs::path& root) {
    ControlGroupPlaces places;
    const fs::path unified = ownGroup(root, "");
    // Fails where the group holds processes of its own and is not the root of all: then its parts have no limits.
    if (!unified.empty()) put(unified / "cgroup.subtree_control", "+pids +memory");
    if (offers(unified, "pids.max")) places.pids = unified;
    if (offers(unified, "memory.max")) places.memory = unified;
    places.unified = places.any();
    if (places.any()) return places;
    const fs::path pids = ownGroup(root, "pids"), memory = ownGroup(root, "memory");
    if (offers(pids, "pids.max")) places.pids = pids;
    if (offers(memory, "memory.limit_in_bytes")) places.memory = memory;
    return places;
}

ControlGroup::ControlGroup(const ControlGroupPlaces& places, std::size_t processes, std::size_t bytes) {
    const std::string most = std::to_string(bytes);
    if (!places.pids.empty()) {
        makeFolder(places.pids);
        put(folders.back() / "pids.max", std::to_string(processes));
    }
    if (places.memory.empty()) return;
    if (places.memory != places.pids) makeFolder(places.memory);
    const fs::path& group = folders.back();
    const bool set = put(group / (places.unified ? "memory.max" : "memory.limit_in_bytes"), most);
    if (!set) throw MachineError(group.string() + ": the limit of memory cannot be set");
    // Only where the kernel counts swap.
    put(group / (places.unified ? "memory.swap.max" : "memory.memsw.limit_in_bytes"), places.unified ? "0" : most);
}

void ControlGroup::makeFolder(const fs::path& place) {
    const fs::path folder = place / newName();
    std::error_code failure;
    fs::create_directory(folder, failure);
    if (failure) throw MachineError(folder.string() + ": the control group cannot be made: " + failure.message());
    folders.push_back(folder);
    joins.push_back((folder / "cgroup.procs").string());
}

ControlGroup::~ControlGroup() {
    for (const fs::path& folder : folders) {
        for (int i = 0; i < triesToRemove && rmdir(folder.c_str()) != 0 && errno == EBUSY; ++i) {
            std::istringstream processes(contents(folder / "cgroup.procs"));
            for (pid_t process = 0; processes >> process;) kill(process, SIGKILL);
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        }
    }
}

}  // namespace radlab::grader

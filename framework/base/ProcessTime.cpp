#include "base/ProcessTime.h"

#include <algorithm>

#ifdef __linux__
#include <unistd.h>

#include <ctime>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#endif

namespace radlab {

namespace {

constexpr double secondsBetween = 0.1;  // a look costs less than a thousandth of that
constexpr double mostSlept = 1.0;
constexpr double ownShare = 0.25;  // of wall-clock time, where nothing else is known

struct Activity {
    bool known = false;
    double ran = 0.0;  // seconds of all processors, since it began
    bool ready = false, stopped = false;
};

#ifdef __linux__

constexpr int mostThreads = 2000;  // hostile ones could be without end

// What /proc says of processes and their threads, one added after the other.
class Tree {
public:
    Activity of(int process) {
        add(process);
        return found;
    }

private:
    void add(int process) {
        clockid_t clock = 0;
        timespec time{};
        if (clock_getcpuclockid(process, &clock) != 0 || clock_gettime(clock, &time) != 0) return;
        found.ran += static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
        std::error_code failure;
        bool first = true;
        for (const auto& thread :
             std::filesystem::directory_iterator("/proc/" + std::to_string(process) + "/task", failure)) {
            if (++threads > mostThreads) return;
            addThread(thread.path().string(), first);
            first = false;
        }
    }

    // The state stands after the name, which may hold spaces and brackets of its own.
    void addThread(const std::string& folder, bool first) {
        std::ifstream file(folder + "/stat"), children(folder + "/children");
        std::string line, ignored;
        std::getline(file, line);
        const std::size_t end = line.rfind(") ");
        if (end == std::string::npos || !children) return;
        std::istringstream words(line.substr(end + 2));
        char state = 0;
        double user = 0.0,
               system = 0.0;  // of children that it has waited for: field 16 and 17, the state being the third
        words >> state;
        for (int field = 4; field < 16; ++field) words >> ignored;
        if (first && words >> user >> system) found.ran += (user + system) / static_cast<double>(sysconf(_SC_CLK_TCK));
        found.ready = found.ready || state == 'R';
        found.stopped = found.stopped || state == 'T' || state == 't';
        found.known = true;
        for (int child = 0; children >> child;) add(child);
    }

    Activity found;
    int threads = 0;
};

Activity activityOf(int process) { return Tree().of(process); }

#else

Activity activityOf(int) { return {}; }

#endif

}  // namespace

void ProcessTime::look() {
    const double now = watch.seconds(), passed = now - looked;
    if (passed < secondsBetween) return;
    const Activity seen = activityOf(process);
    const double running = seen.known ? std::clamp(seen.ran - ran, 0.0, passed) : ownShare * passed;
    const double missing = passed - running, slept = std::min(missing, mostSlept);
    own += running;
    if (!seen.known || seen.ready)
        waiting += missing;
    else if (seen.stopped)
        halted += missing;
    else {
        own += slept;
        waiting += missing - slept;
    }
    looked = now;
    ran = seen.ran;
}

}  // namespace radlab

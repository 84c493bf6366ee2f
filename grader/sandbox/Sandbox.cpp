#include "grader/sandbox/Sandbox.h"

#include <unistd.h>

#include <algorithm>

#include "grader/sandbox/Process.h"

namespace radlab::grader {

namespace {

namespace fs = std::filesystem;

const std::vector<std::string> always = {"process group",       "no new privileges", "closed descriptors",
                                         "cleared environment", "resource limits",   "wall-clock limit",
                                         "capped output"};

struct Extra {
    const char* name;
    bool (*has)(const Sandbox&);
    void (*drop)(Sandbox&);
    const char* remedy;
    bool root;
};

// What is worth most comes last: the first are given up first.
const std::vector<Extra> extras = {
    {"memory control group", [](const Sandbox& s) { return !s.groups.memory.empty(); },
     [](Sandbox& s) { s.groups.memory.clear(); },
     "a control group that may be written: run as root, or by systemd-run --scope -p Delegate=yes", true},
    {"process control group", [](const Sandbox& s) { return !s.groups.pids.empty(); },
     [](Sandbox& s) { s.groups.pids.clear(); },
     "a control group that may be written: run as root, or by systemd-run --scope -p Delegate=yes", true},
    {"own user", [](const Sandbox& s) { return s.ownUser; }, [](Sandbox& s) { s.ownUser = false; }, "running as root",
     true},
    {"system call filter", [](const Sandbox& s) { return s.filter; }, [](Sandbox& s) { s.filter = false; },
     "libseccomp-dev, building again, and a kernel or container that lets a process filter its calls", false},
    {"namespaces", [](const Sandbox& s) { return !s.bubblewrap.empty(); }, [](Sandbox& s) { s.bubblewrap.clear(); },
     "apt-get install bubblewrap, and a kernel or container that allows user namespaces (sysctl "
     "user.max_user_namespaces)",
     false},
};

fs::path findBubblewrap() {
    for (const char* place : {"/usr/bin/bwrap", "/usr/local/bin/bwrap"})
        if (access(place, X_OK) == 0) return place;
    return {};
}

bool works(const Sandbox& sandbox) {
    try {
        Command command;
        command.arguments = {"/bin/sh", "-c", "echo in > $TMPDIR/box && cat $TMPDIR/box"};
        Box& box = command.box.emplace(sandbox);
        box.scratch = 65536;
        box.programs = true;
        ProcessLimits limits;
        limits.file = 65536;
        return run(command, "", limits).output == "in\n";
    } catch (const MachineError&) {
        return false;
    }
}

// The best of what the machine says that it has, as some of it may not work with the rest.
Sandbox tryOut() {
    Sandbox whole;
    whole.ownUser = geteuid() == 0;
    whole.bubblewrap = findBubblewrap();
    whole.filter = !filterProgram(Calls::compiler).empty();
    whole.groups = findControlGroupPlaces();
    for (unsigned dropped = 0; dropped < 1u << extras.size(); ++dropped) {
        Sandbox sandbox = whole;
        for (std::size_t i = 0; i < extras.size(); ++i)
            if (dropped >> i & 1) extras[i].drop(sandbox);
        if (works(sandbox)) return sandbox;
    }
    throw MachineError("no program can be started on this machine");
}

}  // namespace

const Sandbox& machineSandbox() {
    static const Sandbox found = tryOut();
    return found;
}

std::vector<std::string> allProtections() {
    std::vector<std::string> names = always;
    for (auto extra = extras.rbegin(); extra != extras.rend(); ++extra) names.emplace_back(extra->name);
    return names;
}

std::vector<std::string> protections(const Sandbox& sandbox) {
    std::vector<std::string> names = always;
    for (auto extra = extras.rbegin(); extra != extras.rend(); ++extra)
        if (extra->has(sandbox)) names.emplace_back(extra->name);
    return names;
}

std::vector<Lack> lacks(const Sandbox& sandbox) {
    std::vector<Lack> missing;
    for (auto extra = extras.rbegin(); extra != extras.rend(); ++extra)
        if (!extra->has(sandbox)) missing.push_back({extra->name, extra->remedy, extra->root});
    return missing;
}

std::string lackingNames(const Sandbox& sandbox) {
    std::string names;
    for (const Lack& lack : lacks(sandbox))
        if (!lack.root || geteuid() == 0) names += (names.empty() ? "" : ", ") + lack.protection;
    return names;
}

void requireProtections(const std::vector<std::string>& names, const Sandbox& sandbox) {
    const std::vector<std::string> all = allProtections();
    const std::vector<std::string>& wanted = names.size() == 1 && names[0] == "all" ? all : names;
    const auto in = [](const std::vector<std::string>& list, const std::string& name) {
        return std::find(list.begin(), list.end(), name) != list.end();
    };
    std::string known, lacking;
    for (const std::string& name : all) known += (known.empty() ? "" : ", ") + name;
    for (const std::string& name : wanted)
        if (!in(all, name)) throw Error("unknown protection '" + name + "': expected all, or some of " + known);
    for (const Lack& lack : lacks(sandbox))
        if (in(wanted, lack.protection)) lacking += "\n  " + lack.protection + ": needs " + lack.remedy;
    if (!lacking.empty()) throw Error("this machine lacks protections that --require names:" + lacking);
}

}  // namespace radlab::grader

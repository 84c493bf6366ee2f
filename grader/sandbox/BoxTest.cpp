#include "grader/sandbox/Box.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <fstream>

#include <doctest/doctest.h>

#include "base/TestFolder.h"
#include "base/TestSkip.h"
#include "base/WholeFile.h"
#include "grader/sandbox/Launch.h"
#include "grader/sandbox/Process.h"

using namespace radlab;
using namespace radlab::grader;

namespace {

// What a shell prints in a box that has its programs.
Ended boxed(const std::string& script, const Sandbox& sandbox = machineSandbox(), std::size_t scratch = 1 << 20) {
    Command command{{"/bin/sh", "-c", script}};
    Box& box = command.box.emplace(sandbox);
    box.programs = true;
    box.scratch = scratch;
    ProcessLimits limits;
    limits.file = std::size_t{1} << 30;
    limits.seconds = 20.0;
    return run(command, "", limits);
}

bool has(const Sandbox& sandbox, const std::string& name) {
    const std::vector<std::string> here = protections(sandbox);
    return std::find(here.begin(), here.end(), name) != here.end();
}

bool machineHas(const std::string& name) { return has(machineSandbox(), name); }

void skippedWithout(const std::string& name) { test::skipped("this machine lacks " + name); }

// This machine's sandbox without one of its parts.
Sandbox without(const std::string& name) {
    Sandbox sandbox = machineSandbox();
    if (name == "namespaces") sandbox.bubblewrap.clear();
    if (name == "system call filter") sandbox.filter = false;
    if (name == "own user") sandbox.ownUser = false;
    if (name == "control groups") sandbox.groups = {};
    return sandbox;
}

void worksIn(const Sandbox& sandbox) {
    const Ended ended = boxed("echo text > $TMPDIR/file; cat $TMPDIR/file; echo answer >&3; exit 7", sandbox);
    CHECK(ended.output == "text\n");
    CHECK(ended.answer == "answer\n");
    CHECK(ended.code == 7);
}

}  // namespace

TEST_CASE("a program works in its box, whatever the machine has") { worksIn(machineSandbox()); }

TEST_CASE("a program works in its box without namespaces") {
    if (!machineHas("namespaces")) return skippedWithout("namespaces");
    worksIn(without("namespaces"));
}

TEST_CASE("a program works in its box without a filter of system calls") {
    if (!machineHas("system call filter")) return skippedWithout("system call filter");
    worksIn(without("system call filter"));
}

TEST_CASE("a program works in its box without an own user") {
    if (!machineHas("own user")) return skippedWithout("own user");
    worksIn(without("own user"));
}

TEST_CASE("a program works in its box without control groups") {
    if (!machineSandbox().groups.any()) return skippedWithout("control groups");
    worksIn(without("control groups"));
}

TEST_CASE("a program works where there is no protection but those that there always are") {
    const Sandbox none;
    CHECK(boxed("echo $TMPDIR", none).output != "\n");
    CHECK(protections(none).size() + 5 == allProtections().size());
}

TEST_CASE("a box shows the toolchain and what is named, and nothing else of the machine") {
    if (!machineHas("namespaces")) return skippedWithout("namespaces");
    const test::Folder folder;
    writeFile(folder / "shown", "shown\n");
    writeFile(folder / "hidden", "hidden\n");
    Command command{
        {"/bin/sh", "-c", "cat /given; cat '" + (folder / "hidden").string() + "' /etc/passwd /proc/mounts; echo *"}};
    Box& box = command.box.emplace(machineSandbox());
    box.programs = true;
    CHECK(box.show(readableByAll(folder / "shown", box.sandbox), "/given") == "/given");
    const Ended ended = run(command, "", {});
    CHECK(ended.output.find("shown\n") == 0);
    CHECK(ended.output.find("hidden\n") == std::string::npos);
    CHECK(ended.output.find("root:") == std::string::npos);
    const std::string names = " " + ended.output.substr(ended.output.rfind('\n', ended.output.size() - 2) + 1);
    for (const char* kept : {"home", "root", "proc", "sys", "var", "run", "boot", "opt", "srv", "mnt"})
        CHECK(names.find(std::string(" ") + kept + " ") == std::string::npos);
}

TEST_CASE("without scratch nothing in the box can be written, with it no more than it has") {
    if (!machineHas("namespaces")) return skippedWithout("namespaces");
    const std::string everywhere =
        "for d in / /tmp /dev /dev/shm /usr /etc /var; do (echo x > $d/f) 2>/dev/null && echo wrote $d; done; echo end";
    CHECK(boxed(everywhere, machineSandbox(), 0).output == "end\n");
    CHECK(boxed(everywhere).output == "wrote /tmp\nend\n");
    const Ended full = boxed("head -c 3000000 /dev/zero > /tmp/f; stat -c %s /tmp/f");
    CHECK(full.output.find("No space left") != std::string::npos);
    CHECK(full.output.find("1048576\n") != std::string::npos);
}

TEST_CASE("two boxes have nothing in common") {
    if (!machineHas("namespaces")) return skippedWithout("namespaces");
    CHECK(boxed("echo word > /tmp/word; ls /tmp 2>/dev/null").output == "word\n");
    CHECK(boxed("echo /tmp/*").output == "/tmp/*\n");
}

TEST_CASE("a daemon is gone when its box is") {
    if (!machineHas("namespaces")) return skippedWithout("namespaces");
    const Ended ended = boxed("setsid sh -c 'while :; do echo still here; sleep 0.1; done' & exit 3");
    CHECK(ended.how == Ended::How::exited);  // it was not waited for up to the limit
    CHECK(ended.code == 3);
}

TEST_CASE("the number of processes is capped") {
    if (!machineHas("process control group") && !machineHas("own user"))
        return skippedWithout("a process control group and an own user");
    const Ended ended = boxed("i=0; while [ $((i += 1)) -le 200 ]; do sleep 1000 & done; echo end");
    CHECK(ended.output.find("end\n") == std::string::npos);  // the shell gives up where it cannot fork
}

TEST_CASE("the memory of all processes together is capped") {
    if (!machineHas("memory control group")) return skippedWithout("memory control group");
    // Each of four holds its own while the next one fills.
    Command command{
        {"/bin/sh", "-c",
         "fill() { x=$(head -c 20000000 /dev/zero | tr '\\0' x); [ $1 = 1 ] || (fill $(($1 - 1))); echo ${#x}; "
         "}; fill 4"}};
    Box& box = command.box.emplace(machineSandbox());
    box.programs = true;
    box.memory = 64 << 20;
    const std::string output = run(command, "", {}).output;
    std::size_t whole = 0;
    for (std::size_t at = output.find("20000000"); at != std::string::npos; at = output.find("20000000", at + 1))
        ++whole;
    CHECK(whole < 4);
}

TEST_CASE("control groups and scratch folders go with their box") {
    const ControlGroupPlaces& places = machineSandbox().groups;
    const auto count = [&] {
        std::size_t groups = 0;
        for (const std::filesystem::path& place : {places.pids, places.memory})
            if (!place.empty())
                for (const auto& entry : std::filesystem::directory_iterator(place))
                    groups +=
                        entry.path().filename().string().rfind("radlab-" + std::to_string(getpid()) + "-", 0) == 0;
        return groups;
    };
    boxed("sleep 100 & exit 0");
    CHECK(count() == 0);
    std::string scratch = boxed("echo $TMPDIR", without("namespaces")).output;
    scratch.pop_back();
    CHECK_FALSE(std::filesystem::exists(scratch));
}

TEST_CASE("version 2 of control groups is found, and taken before version 1") {
    const test::Folder root;
    const auto put = [&](const std::string& file, const std::string& text) {
        std::filesystem::create_directories((root / file).parent_path());
        std::ofstream(root / file) << text;
    };
    put("proc/self/cgroup", "4:memory:/old\n0::/user/one\n");
    put("proc/self/mountinfo",
        "30 1 0:26 / /sys/fs/cgroup rw - cgroup2 cgroup2 rw\n31 1 0:27 / /old rw - cgroup cgroup rw,memory\n");
    put("sys/fs/cgroup/user/one/cgroup.procs", "");
    // An ordinary folder has no limits in the groups that are made in it.
    CHECK_FALSE(findControlGroupPlaces(root / "").any());
    std::ifstream asked(root / "sys/fs/cgroup/user/one/cgroup.subtree_control");
    std::string text;
    std::getline(asked, text);
    CHECK(text == "+pids +memory");
}

TEST_CASE("what is asked for by name and lacking is an error that says what would bring it") {
    Sandbox none;
    CHECK_THROWS_WITH_AS(requireProtections({"namespaces"}, none), doctest::Contains("apt-get install bubblewrap"),
                         Error);
    CHECK_THROWS_WITH_AS(requireProtections({"all"}, none), doctest::Contains("own user: needs running as root"),
                         Error);
    CHECK_THROWS_WITH_AS(requireProtections({"magic"}, none), doctest::Contains("unknown protection 'magic'"), Error);
    CHECK_NOTHROW(requireProtections({"capped output", "wall-clock limit"}, none));
    CHECK_NOTHROW(requireProtections(protections(machineSandbox()), machineSandbox()));
}

TEST_CASE("what others may not read is copied for the box, once") {
    if (!machineHas("own user")) return skippedWithout("own user");
    const test::Folder folder;
    std::filesystem::create_directories(folder / "closed/inner");
    writeFile(folder / "closed/inner/file", "text\n");
    std::filesystem::permissions(folder / "closed", std::filesystem::perms(0700));
    const std::filesystem::path copy = readableByAll(folder / "closed", machineSandbox());
    CHECK(copy != folder / "closed");
    CHECK(copy == readableByAll(folder / "closed", machineSandbox()));
    CHECK(boxed("cat '" + (copy / "inner/file").string() + "'", without("namespaces")).output == "text\n");
}

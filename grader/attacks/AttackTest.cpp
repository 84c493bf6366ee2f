#include "grader/attacks/Attack.h"

#include <algorithm>

#include <doctest/doctest.h>

#include "base/TestSkip.h"
#include "base/WholeFile.h"

using namespace radlab;
using namespace radlab::grader;

namespace {

// Less patience than with students: endless loops are part of the suite.
Manifest impatient() {
    Manifest manifest = readManifest(manifestFile());
    manifest.seconds = 2.0;
    manifest.compileSeconds = 10.0;
    return manifest;
}

// What has to be there beyond that which always is, as one text.
std::string needsOf(const Attack& attack) {
    const std::vector<std::string> always = protections(Sandbox());
    std::string needs;
    for (const std::string& name : attack.stoppedBy)
        if (std::find(always.begin(), always.end(), name) == always.end()) needs += (needs.empty() ? "" : ", ") + name;
    return needs;
}

const std::string nothing, processes = "own user, process control group", filter = "system call filter";
const std::string processesAndFilter = processes + ", " + filter, memoryAndFilter = "memory control group, " + filter;

std::vector<Attack> attacksThatNeed(const std::string& needs) {
    std::vector<Attack> attacks;
    for (const Attack& attack : allAttacks())
        if (needsOf(attack) == needs) attacks.push_back(attack);
    return attacks;
}

// One in so many of those with the same needs, so that the tests share the work.
void areStopped(const std::string& needs, std::size_t first = 0, std::size_t step = 1) {
    const Toolchain toolchain = readToolchain(RADLAB_TOOLCHAIN);
    const std::vector<Attack> attacks = attacksThatNeed(needs);
    REQUIRE(attacks.size() > first);
    for (std::size_t i = first; i < attacks.size(); i += step) {
        CAPTURE(attacks[i].id);
        const AttackVerdict verdict = tryAttack(attacks[i], toolchain, impatient());
        if (verdict.lacksProtection) return test::skipped("this machine lacks " + verdict.why);
        CHECK_MESSAGE(verdict.stopped, verdict.why);
    }
}

}  // namespace

TEST_CASE("attacks are stopped everywhere, the first third of them") { areStopped(nothing, 0, 3); }
TEST_CASE("attacks are stopped everywhere, the second third of them") { areStopped(nothing, 1, 3); }
TEST_CASE("attacks are stopped everywhere, the last third of them") { areStopped(nothing, 2, 3); }
TEST_CASE("attacks are stopped by namespaces") { areStopped("namespaces"); }
TEST_CASE("attacks are stopped by a filter of system calls") { areStopped(filter); }
TEST_CASE("attacks are stopped by an own user and a limit of processes") { areStopped(processes); }
TEST_CASE("attacks are stopped by those and a filter") { areStopped(processesAndFilter); }
TEST_CASE("attacks are stopped by a limit of memory and a filter") { areStopped(memoryAndFilter); }

TEST_CASE("each attack is tried by one of these") {
    std::size_t tried = 0;
    for (const std::string& needs :
         {nothing, std::string("namespaces"), filter, processes, processesAndFilter, memoryAndFilter})
        tried += attacksThatNeed(needs).size();
    CHECK(tried == allAttacks().size());
}

// Else nothing would tell a suite that is stopped from one that does nothing.
TEST_CASE("without what stops it, an attack gets through, and is seen") {
    Toolchain toolchain = readToolchain(RADLAB_TOOLCHAIN);
    if (!toolchain.sandbox.ownUser) return test::skipped("this machine lacks an own user, and would be at risk");
    toolchain.sandbox.bubblewrap.clear();
    toolchain.sandbox.filter = false;
    for (Attack& attack : allAttacks()) {
        CAPTURE(attack.id);
        if (!(attack.id == "read-secrets" || attack.id == "sockets" || attack.id == "leave-state" ||
              attack.id == "include-passwd" || attack.id == "fill-files"))
            continue;
        CHECK(tryAttack(attack, toolchain, impatient()).lacksProtection);
        attack.stoppedBy.clear();
        const AttackVerdict verdict = tryAttack(attack, toolchain, impatient());
        CHECK_FALSE(verdict.stopped);
        CHECK_FALSE(verdict.why.empty());
    }
}

TEST_CASE("each attack has its code, and each code its line in the list") {
    std::size_t codes = 0;
    for (const auto& entry : std::filesystem::directory_iterator(RADLAB_SOURCE_DIR "/grader/attacks/code"))
        codes += entry.path().extension() == ".cpp" ? 1 : 0;
    CHECK(allAttacks().size() == codes);
    for (const Attack& attack : allAttacks())
        CHECK(attackText(attack).find(attack.call ? "attack();" : "fullMarks") != std::string::npos);
}

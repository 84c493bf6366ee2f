#include "grader/attacks/Attack.h"

#include <doctest/doctest.h>

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

// Every third attack, so that the tests share the work.
void tryEvery(std::size_t third) {
    const Toolchain toolchain = readToolchain(RADLAB_TOOLCHAIN);
    const std::vector<Attack> attacks = allAttacks();
    for (std::size_t i = third; i < attacks.size(); i += 3) {
        CAPTURE(attacks[i].id);
        const AttackVerdict verdict = tryAttack(attacks[i], toolchain, impatient());
        if (verdict.lacksProtection)
            MESSAGE(attacks[i].id, " was not tried: this machine lacks ", verdict.why);
        else
            CHECK_MESSAGE(verdict.stopped, verdict.why);
    }
}

}  // namespace

TEST_CASE("attacks are stopped, the first third of them") { tryEvery(0); }
TEST_CASE("attacks are stopped, the second third of them") { tryEvery(1); }
TEST_CASE("attacks are stopped, the last third of them") { tryEvery(2); }

// Else nothing would tell a suite that is stopped from one that does nothing.
TEST_CASE("without what stops it, an attack gets through, and is seen") {
    Toolchain toolchain = readToolchain(RADLAB_TOOLCHAIN);
    if (!toolchain.sandbox.ownUser) {
        MESSAGE("not tried: this machine lacks an own user, and would be at risk");
        return;
    }
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

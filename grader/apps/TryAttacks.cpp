#include "grader/apps/TryAttacks.h"

#include <cstdio>
#include <iostream>

#include "base/ProgressBar.h"
#include "grader/attacks/Attack.h"
#include "grader/sandbox/Sandbox.h"

namespace radlab::grader {

namespace {

// As long as it takes to see that nothing comes; students have more.
constexpr double patience = 2.0;
constexpr double compilePatience = 20.0;

void tellProtections() {
    const std::vector<std::string> here = protections(machineSandbox());
    std::cout << "protections of this machine:";
    for (const std::string& name : here) std::cout << (&name == &here.front() ? " " : ", ") << name;
    std::cout << "\n\n";
}

}  // namespace

int tryAttacks() {
    tellProtections();
    const Toolchain toolchain = readToolchain(RADLAB_TOOLCHAIN);
    Manifest manifest = readManifest(manifestFile());
    manifest.seconds = patience;
    manifest.compileSeconds = compilePatience;
    const std::vector<Attack> attacks = allAttacks();
    std::size_t stopped = 0, lacking = 0;
    for (const Attack& attack : attacks) {
        AttackVerdict verdict;
        {
            ProgressBar bar("attacks", static_cast<double>(attacks.size()));
            bar.show(static_cast<double>(&attack - attacks.data()), attack.id);
            verdict = tryAttack(attack, toolchain, manifest);
        }
        stopped += verdict.stopped;
        lacking += verdict.lacksProtection;
        const char* word = verdict.stopped ? "stopped" : verdict.lacksProtection ? "not tried" : "GOT THROUGH";
        std::printf("%-12s %-26s %s\n", word, attack.id.c_str(), attack.what.c_str());
        if (!verdict.stopped)
            std::printf("%-12s %s%s\n", "", verdict.lacksProtection ? "this machine lacks " : "", verdict.why.c_str());
        std::fflush(stdout);
    }
    std::cout << "\nstopped: " << stopped << " of " << attacks.size();
    if (lacking) std::cout << "; not tried, as this machine lacks what stops them: " << lacking;
    std::cout << '\n';
    return stopped + lacking == attacks.size() ? 0 : 3;
}

}  // namespace radlab::grader

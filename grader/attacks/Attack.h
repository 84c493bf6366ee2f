#pragma once

#include <string>
#include <vector>

#include "grader/judge/Compile.h"
#include "grader/protocol/Result.h"
#include "grader/stages/Manifest.h"

namespace radlab::grader {

/// A submission that tries what it must not, and what has to come of it.
///
/// It is judged in two stages: the attack runs in maxenergy_patch (or at load), and calcAnalyticalFF is the solution's.
struct Attack {
    std::string id;    ///< names its file, code/<id>.cpp
    std::string what;  ///< in words
    bool compiles = true;
    bool call = false;      ///< attack() is called in maxenergy_patch; else all happens at load, or in the compiler
    bool twice = false;     ///< judged two times, since the second run looks for what the first left
    bool solution = false;  ///< maxenergy_patch goes on as the solution's; else it is a stub, and worth nothing
    bool own = false, other = false;     ///< whether the two stages have all their marks; else they have none
    std::string never;                   ///< what may stand nowhere in the result
    std::vector<std::string> stoppedBy;  ///< protections, all of which have to be there; empty: it is always stopped
};

/// What came of an attack.
struct AttackVerdict {
    bool stopped = false;
    bool lacksProtection = false;  ///< not tried: this machine lacks what stops it
    std::string why;               ///< what got through, or which protections are lacking
    Result result;                 ///< of the submission
};

/// All attacks, in the order of their list.
std::vector<Attack> allAttacks();

/// The submission, whole.
std::string attackText(const Attack& attack);

/// Judges an attack as any submission, by two checks of each stage, and looks for what it left behind.
///
/// It counts as stopped where both stages have exactly the marks that they should, nothing says "breach", and neither files nor
/// processes are left.
/// Errors: MachineError.
AttackVerdict tryAttack(const Attack& attack, const Toolchain& toolchain, const Manifest& manifest);

}  // namespace radlab::grader

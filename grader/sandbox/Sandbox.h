#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "grader/sandbox/ControlGroup.h"

namespace radlab::grader {

/// Which ways of keeping a program in its box this machine has; what it lacks is left out.
struct Sandbox {
    bool ownUser = false;              ///< a real user without privileges that nobody else is
    std::filesystem::path bubblewrap;  ///< the program that makes namespaces; empty: none
    bool filter = false;               ///< of system calls
    ControlGroupPlaces groups;
};

/// What works here, tried out once by starting a program in such a box.
const Sandbox& machineSandbox();

/// Names of all protections, those that `run` always gives first: for the result file and for `--require`.
std::vector<std::string> allProtections();

/// Those that a sandbox has.
std::vector<std::string> protections(const Sandbox& sandbox);

/// A protection that a machine lacks, and what would bring it.
struct Lack {
    std::string protection, remedy;
    bool root = false;  ///< only root can have it
};

/// What a sandbox lacks, the most important first.
std::vector<Lack> lacks(const Sandbox& sandbox);

/// Those names, separated by commas; without those that only root can have where this process is not root's.
std::string lackingNames(const Sandbox& sandbox);

/// Makes sure that the protections of a list are there; "all" stands for all.
///
/// Errors: names that this machine lacks, with what would bring them; unknown names.
void requireProtections(const std::vector<std::string>& names, const Sandbox& sandbox);

}  // namespace radlab::grader

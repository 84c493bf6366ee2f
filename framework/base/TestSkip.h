#pragma once

// For tests that not every machine can run.

#include <string>

#include <doctest/doctest.h>

namespace radlab::test {

/// Says why a case cannot run on this machine, so that ctest counts it as skipped. The case has to claim nothing before and to end now:
///
///     if (!machineHas("namespaces")) return skipped("this machine lacks namespaces");
inline void skipped(const std::string& reason) { MESSAGE("-- skipped: " << reason); }

}  // namespace radlab::test

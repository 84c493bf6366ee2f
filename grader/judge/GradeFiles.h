#pragma once

#include <map>
#include <string>

#include "grader/judge/Judge.h"
#include "grader/judge/PngCache.h"
#include "grader/protocol/Graded.h"

namespace radlab::grader {

/// Grades what was handed in: contents of files by their names, the first of which is `main`, the one to compile.
///
/// What does not compile is graded, too: each check is blocked, and the compiler's words are in the result.
///
/// @pre    all are plain names, without folders
/// Errors: MachineError, also where a check found the grader or the machine at fault: there is no mark then.
/// @cost   seconds
Graded gradeFiles(const std::map<std::string, std::string>& files, const std::string& main, Judge& judge,
                  PngCache& pictures);

/// Judges the extensions among what was handed in, by the names of their files, and adds them to the result; its marks,
/// and what is in it already, stay as they are.
///
/// @pre   all are plain names, without folders
/// Errors: MachineError.
/// @cost  a second for each
void addExtensions(const std::map<std::string, std::string>& files, const Manifest& manifest,
                   const Toolchain& toolchain, const JudgeOptions& options, Result& result);

/// Encodes the reference pictures, which nearly every submission needs.
///
/// Errors: one that is missing.
void encodeReferences(const Manifest& manifest, PngCache& pictures);

}  // namespace radlab::grader

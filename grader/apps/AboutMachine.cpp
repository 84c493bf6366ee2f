#include "grader/apps/AboutMachine.h"

#include <iostream>
#include <sstream>

#include "grader/judge/WorkerOpenGl.h"
#include "grader/sandbox/Process.h"

namespace radlab::grader {

std::string aboutMachine() {
    std::ostringstream text;
    text << "radlab " RADLAB_VERSION "\n";
    try {
        const Toolchain toolchain = readToolchain(RADLAB_TOOLCHAIN);
        text << "compiler: " << toolchain.compiler << "\ndrawing: " << openGlOf(toolchain) << "protections:";
        const char* between = " ";
        for (const std::string& name : protections(toolchain.sandbox)) {
            text << between << name;
            between = ", ";
        }
        for (const Lack& lack : lacks(toolchain.sandbox))
            text << "\nmissing: " << lack.protection << ", which needs " << lack.remedy;
    } catch (const Error& error) {
        text << "error: " << error.what();
    }
    return text.str();
}

void tellLacks() {
    const std::string names = lackingNames(machineSandbox());
    if (!names.empty())
        std::cerr << "note: submissions run with less protection here, without " << names
                  << "; --version says what would bring it\n";
}

}  // namespace radlab::grader

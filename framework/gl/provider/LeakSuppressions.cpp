// Part of every provider of OpenGL where the sanitizers are on: what the drivers keep to the end is not our leak.

// NOLINTNEXTLINE(bugprone-reserved-identifier): the sanitizer asks for this name
extern "C" const char* __lsan_default_suppressions() {
    return "leak:libOSMesa\n"
           "leak:libEGL\n"
           "leak:libGL\n"
           "leak:libLLVM\n"
           "leak:_dri.so\n"
           "leak:libX11\n";
}

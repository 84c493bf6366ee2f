#include "viewer/CourseLibrary.h"

#ifdef _WIN32
#ifndef NOMINMAX
#define NOMINMAX
#endif
#include <windows.h>
#else
#include <dlfcn.h>
#endif

#include <string>

#include "base/Error.h"

namespace radlab {

namespace {

#ifdef _WIN32
void* opened(const std::filesystem::path& library) { return LoadLibraryW(library.c_str()); }
void* found(void* library, const char* name) {
    return reinterpret_cast<void*>(GetProcAddress(static_cast<HMODULE>(library), name));
}
std::string reason() { return "Windows error " + std::to_string(GetLastError()); }
#else
void* opened(const std::filesystem::path& library) { return dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL); }
void* found(void* library, const char* name) { return dlsym(library, name); }
std::string reason() {
    const char* text = dlerror();
    return text ? text : "no reason given";
}
#endif

}  // namespace

CourseFunctions loadCourseFunctions(const std::filesystem::path& library) {
    void* handle = opened(library);
    if (!handle) throw Error("the functions cannot be loaded: " + reason());
    const auto entry = reinterpret_cast<const CourseFunctions* (*)()>(found(handle, "radlabCourseFunctions"));
    if (!entry) throw Error("the functions cannot be loaded: " + reason());
    return *entry();
}

}  // namespace radlab

#include "viewer/LibraryBuild.h"

#include <array>
#include <chrono>
#include <cstdio>
#include <random>
#include <sstream>

#include "base/Error.h"
#include "base/TemporaryPlace.h"

#ifdef _WIN32
#define popen _popen
#define pclose _pclose
#endif

namespace radlab {

namespace {

constexpr std::size_t mostLines = 8, mostText = 2000;

struct ShellEnd {
    int status;
    std::string output;
};

ShellEnd runShell(const std::string& command) {
    FILE* pipe = popen((command + " 2>&1").c_str(), "r");
    if (!pipe) return {-1, "the build could not be started: " + command};
    ShellEnd ended{0, ""};
    std::array<char, 4096> part;
    while (const std::size_t got = std::fread(part.data(), 1, part.size(), pipe)) ended.output.append(part.data(), got);
    ended.status = pclose(pipe);
    return ended;
}

std::string quoted(const std::string& text) { return "\"" + text + "\""; }

bool isError(const std::string& line) {
    return line.find(": error") != std::string::npos || line.find(": fatal error") != std::string::npos ||
           line.find("undefined reference") != std::string::npos;
}

std::string without(std::string text, const std::string& part) {
    if (part.empty()) return text;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at))
        text.erase(at, part.size());
    return text;
}

LibraryOutcome build(const LibraryRecipe& recipe, const std::filesystem::path& copy) {
    const ShellEnd ended = runShell("cmake --build " + quoted(recipe.folder.string()) + " --target " + recipe.target);
    if (ended.status != 0) return {{}, firstErrorIn(ended.output, RADLAB_SOURCE_DIR "/"), ""};
    std::error_code failure;
    std::filesystem::copy_file(recipe.library, copy, std::filesystem::copy_options::overwrite_existing, failure);
    if (failure) return {{}, copy.string() + ": cannot be written: " + failure.message(), ""};
    return {copy, "", ""};
}

}  // namespace

std::string firstErrorIn(const std::string& output, const std::string& project) {
    std::istringstream lines(output);
    std::string line, text;
    std::size_t count = 0;
    while (count < mostLines && std::getline(lines, line)) {
        if (count > 0 && (isError(line) || line.rfind("ninja: ", 0) == 0)) break;
        if (count == 0 && !isError(line)) continue;
        text += (count++ ? "\n" : "") + line;
    }
    if (text.empty()) text = output.substr(0, mostText);
    return without(text, project);
}

LibraryBuild::LibraryBuild(LibraryRecipe how) : recipe(std::move(how)) {}

LibraryBuild::~LibraryBuild() {
    if (running.valid()) running.wait();
}

std::string LibraryBuild::stampOf() const {
    std::error_code failure;
    const auto size = std::filesystem::file_size(recipe.source, failure);
    if (failure) return "";
    const auto time = std::filesystem::last_write_time(recipe.source, failure).time_since_epoch().count();
    return failure ? "" : std::to_string(size) + " " + std::to_string(time);
}

std::optional<LibraryOutcome> LibraryBuild::poll() {
    if (running.valid()) {
        if (running.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return std::nullopt;
        LibraryOutcome outcome = running.get();
        outcome.stamp = built;
        return outcome;
    }
    const std::string stamp = stampOf();
    const bool quiet = stamp == seen;  // editors write a file in several steps
    seen = stamp;
    if (stamp.empty() || stamp == built || !quiet) return std::nullopt;
    built = stamp;
    const std::filesystem::path copy =
        temporaryPlace() / ("radlab-view-" + std::to_string(std::random_device()()) + "-" + std::to_string(copies++) +
                            recipe.library.extension().string());
    running = std::async(std::launch::async, [this, copy] { return build(recipe, copy); });
    return std::nullopt;
}

}  // namespace radlab

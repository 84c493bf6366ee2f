#include "grader/judge/Compile.h"

#include <nlohmann/json.hpp>
#include <sstream>

#include "base/ProgressBar.h"
#include "base/WholeFile.h"
#include "grader/protocol/PlainText.h"
#include "grader/sandbox/Process.h"

namespace radlab::grader {

namespace {

constexpr std::size_t mostErrorLines = 8;
constexpr std::size_t mostLibrary = std::size_t{64} << 20;
constexpr std::size_t mostScratch = std::size_t{256} << 20;
constexpr std::size_t mostSaid = std::size_t{256} << 10;

// The byte says that the box stands: what fails before it is no fault of the submission's. The compiler itself never sees
// the way to the judge, and leaves no file outside its box.
constexpr char begun = '!';
constexpr const char* compileScript =
    "printf '!' >&3 && \"$@\" -o \"$TMPDIR/submission.so\" 3>&- && cat \"$TMPDIR/submission.so\" >&3";

bool isError(const std::string& line) {
    return line.find(": error: ") != std::string::npos || line.find(": fatal error: ") != std::string::npos;
}

void writeForAll(const std::filesystem::path& file, std::string_view contents) {
    writeFile(file, contents);
    std::filesystem::permissions(file, std::filesystem::perms(0644));
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
        text.replace(at, from.size(), to);
    return text;
}

// Names of files and folders in the box, each with the one that it has outside.
using Names = std::vector<std::pair<std::string, std::string>>;

std::string outside(std::string text, const Names& names) {
    for (const auto& [shown, own] : names) text = replaced(text, shown, own);
    return text;
}

// The one to compile comes first.
Names showSources(Box& box, const std::filesystem::path& source, const std::filesystem::path& folder,
                  const std::vector<std::string>& names) {
    Names sources;
    for (const std::string& name : names) {
        const std::filesystem::path from = sources.empty() ? source : source.parent_path() / name, copy = folder / name;
        if (!sources.empty() && !std::filesystem::is_regular_file(from)) continue;
        writeForAll(copy, readFile(from));
        sources.emplace_back(box.show(copy, "/submission/" + name).string(), from.string());
    }
    return sources;
}

Names showHeaders(Box& box, const std::vector<std::filesystem::path>& folders) {
    Names headers;
    for (const std::filesystem::path& folder : folders)
        headers.emplace_back(box.show(readableByAll(folder, box.sandbox), folder).string(), folder.string());
    return headers;
}

std::vector<std::string> compilerCall(const Toolchain& toolchain, const Names& headers, const std::string& source) {
    std::vector<std::string> call = {"/bin/sh", "-c", compileScript, "sh", toolchain.compiler};
    for (std::string flag : toolchain.flags) {
        for (const auto& [shown, own] : headers) flag = replaced(flag, own, shown);
        call.push_back(flag);
    }
    call.insert(call.end(), {"-pipe", "-shared", "-x", "c++", source});
    return call;
}

struct Compilation {
    Ended ended;
    std::string said;  // by the compiler, under the files' own names
    bool succeeded() const { return ended.how == Ended::How::exited && ended.code == 0; }
};

Compilation compile(const std::filesystem::path& source, const std::vector<std::string>& names,
                    const Toolchain& toolchain, double seconds) {
    const TemporaryFolder folder;
    Command command;
    Box& box = command.box.emplace(toolchain.sandbox);
    box.calls = Calls::compiler;
    box.programs = true;
    box.scratch = mostScratch;
    const Names sources = showSources(box, source, folder.path(), names), headers = showHeaders(box, toolchain.reads);
    command.arguments = compilerCall(toolchain, headers, sources.front().first);
    ProcessLimits limits;
    limits.seconds = seconds;
    limits.file = limits.answer = mostLibrary;
    limits.output = mostSaid;
    Compilation made{run(command, "", limits), ""};
    made.said = outside(outside(made.ended.output, sources), headers);
    if (made.ended.how != Ended::How::timedOut && (made.ended.answer.empty() || made.ended.answer[0] != begun))
        throw MachineError("the compiler could not be started: " +
                           (made.said.empty() ? howItEnded(made.ended) : made.said));
    return made;
}

// Whether the fault is the machine's: there, the course's own header does not compile either.
void requireCompiler(const Toolchain& toolchain, double seconds) {
    const TemporaryFolder folder;
    const std::filesystem::path control = folder.path() / "control.cpp";
    writeFile(control, "#include \"course/ProgRef.h\"\n");
    const Compilation made = compile(control, {"control.cpp"}, toolchain, seconds);
    if (!made.succeeded())
        throw MachineError("the course's own headers do not compile on this machine: " +
                           (made.said.empty() ? howItEnded(made.ended) : visibleText(firstError(made.said))));
}

}  // namespace

Toolchain readToolchain(const std::filesystem::path& file) {
    try {
        const nlohmann::json json = nlohmann::json::parse(readFile(file));
        Toolchain toolchain;
        toolchain.sandbox = machineSandbox();
        json.at("compiler").get_to(toolchain.compiler);
        json.at("flags").get_to(toolchain.flags);
        toolchain.worker = json.at("worker").get<std::string>();
        for (const std::string& folder : json.at("reads").get<std::vector<std::string>>())
            toolchain.reads.emplace_back(folder);
        json.at("sanitized").get_to(toolchain.sanitized);
        return toolchain;
    } catch (const nlohmann::json::exception& error) {
        throw Error({file.string()}, error.what());
    }
}

std::string firstError(const std::string& output) {
    std::istringstream lines(output);
    std::string line, text;
    std::size_t count = 0;
    while (std::getline(lines, line)) {
        if (isError(line) && count > 0) break;
        if (!isError(line) && count == 0) continue;
        text += (count ? "\n" : "") + line;
        if (++count == mostErrorLines) break;
    }
    return text.empty() ? output.substr(0, 2000) : text;
}

std::string compileSubmission(const std::filesystem::path& file, const std::filesystem::path& library,
                              const Toolchain& toolchain, const Manifest& manifest) {
    std::error_code failure;
    const std::filesystem::path source = std::filesystem::absolute(file, failure);
    if (!std::filesystem::is_regular_file(source, failure))
        throw Error(file.string() + ": found no such file, expected a C++ file with the six functions");
    const Compilation made = compile(source, manifest.files, toolchain, manifest.compileSeconds);
    if (made.ended.how == Ended::How::timedOut)
        throw CompileError(file.string() + ": compiling took longer than " + durationText(manifest.compileSeconds));
    if (!made.succeeded()) {
        requireCompiler(toolchain, manifest.compileSeconds);
        throw CompileError(visibleText(firstError(made.said)));
    }
    writeForAll(library, std::string_view(made.ended.answer).substr(1));
    return made.said;
}

}  // namespace radlab::grader

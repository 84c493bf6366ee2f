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

// The files in the box, the one to compile first, each under the first name for one that has the second outside.
using Sources = std::vector<std::pair<std::string, std::string>>;

Sources showSources(Box& box, const std::filesystem::path& source, const std::filesystem::path& folder,
                    const std::vector<std::string>& names) {
    Sources sources;
    for (const std::string& name : names) {
        const std::filesystem::path from = sources.empty() ? source : source.parent_path() / name, copy = folder / name;
        if (!sources.empty() && !std::filesystem::is_regular_file(from)) continue;
        writeForAll(copy, readFile(from));
        sources.emplace_back(box.show(copy, "/submission/" + name).string(), from.string());
    }
    return sources;
}

std::vector<std::string> compilerCall(const Toolchain& toolchain, Box& box, const std::string& source) {
    box.calls = Calls::compiler;
    box.programs = true;
    box.scratch = mostScratch;
    for (const std::filesystem::path& folder : toolchain.reads) box.show(readableByAll(folder, box.sandbox), folder);
    std::vector<std::string> call = {"/bin/sh", "-c", compileScript, "sh", toolchain.compiler};
    call.insert(call.end(), toolchain.flags.begin(), toolchain.flags.end());
    call.insert(call.end(), {"-pipe", "-shared", "-x", "c++", source});
    return call;
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
    const TemporaryFolder folder;
    Command command;
    Box& box = command.box.emplace(toolchain.sandbox);
    const Sources sources = showSources(box, source, folder.path(), manifest.files);
    command.arguments = compilerCall(toolchain, box, sources.front().first);
    ProcessLimits limits;
    limits.seconds = manifest.compileSeconds;
    limits.file = limits.answer = mostLibrary;
    limits.output = mostSaid;
    const Ended ended = run(command, "", limits);
    std::string said = ended.output;
    for (const auto& [shown, own] : sources) said = replaced(said, shown, own);
    if (ended.how == Ended::How::timedOut)
        throw CompileError(file.string() + ": compiling took longer than " + durationText(limits.seconds));
    if (ended.answer.empty() || ended.answer[0] != begun)
        throw MachineError("the compiler could not be started: " + (said.empty() ? "no reason given" : said));
    if (ended.how == Ended::How::signalled || ended.code != 0) throw CompileError(visibleText(firstError(said)));
    writeForAll(library, std::string_view(ended.answer).substr(1));
    return said;
}

}  // namespace radlab::grader

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

bool isError(const std::string& line) {
    return line.find(": error: ") != std::string::npos || line.find(": fatal error: ") != std::string::npos;
}

}  // namespace

Toolchain readToolchain(const std::filesystem::path& file) {
    try {
        const nlohmann::json json = nlohmann::json::parse(readFile(file));
        Toolchain toolchain;
        json.at("compiler").get_to(toolchain.compiler);
        json.at("flags").get_to(toolchain.flags);
        toolchain.worker = json.at("worker").get<std::string>();
        json.at("sanitized").get_to(toolchain.sanitized);
        return toolchain;
    } catch (const nlohmann::json::exception& error) {
        throw Error({file.string()}, error.what());
    }
}

TemporaryFolder::TemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "radlab-XXXXXX").string();
    if (!mkdtemp(name.data())) throw Error(name + ": the folder cannot be made");
    folder = name;
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(folder, ignored);
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

void compileSubmission(const std::filesystem::path& file, const std::filesystem::path& library,
                       const Toolchain& toolchain, const Manifest& manifest) {
    std::error_code failure;
    const std::filesystem::path source = std::filesystem::absolute(file, failure);
    if (!std::filesystem::is_regular_file(source, failure))
        throw Error(file.string() + ": found no such file, expected a C++ file with the six functions");
    Command command;
    command.arguments = {toolchain.compiler};
    command.arguments.insert(command.arguments.end(), toolchain.flags.begin(), toolchain.flags.end());
    for (const std::string& last : {std::string("-shared"), std::string("-x"), std::string("c++"), source.string(),
                                    std::string("-o"), library.string()})
        command.arguments.push_back(last);
    ProcessLimits limits;
    limits.seconds = manifest.compileSeconds;
    limits.file = std::size_t{256} << 20;
    const Ended ended = run(command, "", limits);
    if (ended.how == Ended::How::timedOut)
        throw CompileError(file.string() + ": compiling took longer than " + durationText(limits.seconds));
    if (ended.how == Ended::How::signalled || ended.code != 0)
        throw CompileError(visibleText(firstError(ended.output)));
}

}  // namespace radlab::grader

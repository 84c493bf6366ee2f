#include "grader/apps/Watch.h"

#include <chrono>
#include <ctime>
#include <functional>
#include <iostream>
#include <optional>
#include <thread>

#include "base/Interrupts.h"
#include "base/WholeFile.h"
#include "grader/apps/CompileReport.h"
#include "grader/sandbox/Process.h"

namespace radlab::grader {

namespace {

constexpr std::chrono::milliseconds pollTime(150);
constexpr int quietPolls = 2;  // editors write a file in several steps

std::optional<std::string> textOf(const std::filesystem::path& file) {
    try {
        return readFile(file);
    } catch (const Error&) {
        return std::nullopt;  // between two steps of an editor
    }
}

// The text of the file once it is another than before and stays so for a moment.
std::string nextText(const std::filesystem::path& file, const std::optional<std::string>& before) {
    std::optional<std::string> last = before;
    for (int quiet = 0;; std::this_thread::sleep_for(pollTime)) {
        Interrupts::check();
        const std::optional<std::string> now = textOf(file);
        quiet = now && now == last ? quiet + 1 : 0;
        last = now;
        if (quiet >= quietPolls && now != before) return *now;
    }
}

void announce(const std::string& what, bool color) {
    const std::time_t now = std::time(nullptr);
    char time[16];
    std::strftime(time, sizeof time, "%H:%M:%S", std::localtime(&now));
    std::cout << (color ? "\x1b[1m" : "") << "--- " << time << ' ' << what << (color ? "\x1b[0m" : "") << std::endl;
}

const StageResult* firstOpen(const Result& result) {
    for (const StageResult& stage : result.stages)
        if (stage.status != Status::pass) return &stage;
    return nullptr;
}

std::string afterLast(const std::string& verdict) {
    return verdict.empty() ? "" : "the last verdict, of the text before:\n" + verdict;
}

// Judges the open stage, and while it turns out right, the next one.
Result judgeFrom(const FileChecker& checker, std::string& open) {
    for (;;) {
        Result result = checker.judge({open});
        if (firstOpen(result)) return result;
        const Result whole = checker.judge({});
        const StageResult* next = firstOpen(whole);
        if (!next) return whole;
        if (next->stage == open) return whole;
        open = next->stage;
    }
}

struct Watched {
    std::filesystem::path file;
    std::function<Result()> judge;               // throws CompileError, MachineError
    std::function<bool(const Result&)> isRight;  // so that there is nothing left to watch
};

void judgeUntilRight(const Watched& watched, const ReportOptions& options) {
    std::string verdict;
    for (std::optional<std::string> text;;) {
        text = nextText(watched.file, text);
        try {
            const Result result = watched.judge();
            verdict = terminalReport(result, options);
            announce("judged", options.color);
            std::cout << verdict << std::flush;
            if (watched.isRight(result)) return;
        } catch (const CompileError& error) {
            announce("does not compile", options.color);
            std::cout << compileReport(error.what(), watched.file) << afterLast(verdict) << std::flush;
        } catch (const MachineError& error) {
            announce("not judged", options.color);
            std::cout << error.what() << '\n' << afterLast(verdict) << std::flush;
        }
    }
}

int watched(const Watched& what, const ReportOptions& options) {
    std::cout << "watching " << std::filesystem::proximate(what.file).string() << "; Ctrl-C ends it" << std::endl;
    if (doneWhole([&] { judgeUntilRight(what, options); })) return 0;
    std::cout << "stopped by Ctrl-C" << std::endl;
    return 130;
}

}  // namespace

int watch(const FileChecker& checker, const ReportOptions& options) {
    std::string open = checker.manifest().stages.front().stage;
    const std::size_t stages = checker.manifest().stages.size();
    return watched({checker.file(), [&] { return judgeFrom(checker, open); },
                    [&](const Result& result) { return exitCode(result) == 0 && result.stages.size() == stages; }},
                   options);
}

int watchExtension(const FileChecker& checker, const ManifestStage& extension, const std::filesystem::path& folder,
                   const ReportOptions& options) {
    const auto judge = [&] {
        Result result = checker.judgeExtensions({extension}, folder);
        if (!result.compiled) throw CompileError(result.compiler);
        return result;
    };
    return watched({folder / extension.file, judge, [](const Result& result) { return exitCode(result) == 0; }},
                   options);
}

}  // namespace radlab::grader

// Says which stages of the exercise are right, and what is wrong with the others.

#include <cstdlib>
#include <iostream>

#include "apps/CommandLine.h"
#include "base/Heap.h"
#include "base/Interrupts.h"
#include "base/WholeFile.h"
#include "grader/apps/AboutMachine.h"
#include "grader/apps/CheckFile.h"
#include "grader/apps/CheckReports.h"
#include "grader/apps/CompileReport.h"
#include "grader/apps/Watch.h"
#include "grader/report/Terminal.h"
#include "grader/sandbox/Process.h"

using namespace radlab::grader;

namespace {

struct Flags {
    std::string stage;
    std::string file = RADLAB_SOURCE_DIR "/exercises/ProgRef.cpp";
    std::string extensions;
    std::uint64_t seed = 1;
    unsigned jobs = 0;
    bool hint = false, html = false, open = false, watch = false;
    std::string out = "out/check", json, junit, gradescope, classroom50;
};

void describe(CLI::App& app, Flags& flags) {
    app.add_option(
        "stage", flags.stage,
        "One stage only: its number or the name of its function; or an extension's; or extensions, for all of them");
    app.add_option("--file", flags.file, "The file to judge")->capture_default_str();
    app.add_option("--extensions", flags.extensions,
                   "The folder of the extensions' files; without a stage, they are judged beside the six");
    app.add_flag("--hint", flags.hint, "Say more about where to look");
    app.add_flag("--watch", flags.watch,
                 "Judge the first open stage, or the extension named, whenever its file is saved");
    app.add_flag("--html", flags.html, "Write a page with the pictures: reference, yours, difference");
    app.add_flag("--open", flags.open, "Open that page in the browser");
    app.add_option("--out", flags.out, "The folder of that page")->capture_default_str();
    app.add_option("--json", flags.json, "Write the verdict to this file");
    app.add_option("--junit", flags.junit, "Write the verdict to this file in the form of JUnit");
    app.add_option("--gradescope", flags.gradescope, "Write the verdict to this file in the form of Gradescope");
    app.add_option("--classroom50", flags.classroom50,
                   "Write score and tests to this file in the form of Classroom 50");
    app.add_option("--seed", flags.seed, "What the cases are drawn from")->capture_default_str();
    app.add_option("--jobs", flags.jobs, "Processes at once; 0 is one a core")->capture_default_str();
    app.footer(
        "Exit codes: 0 all right, 1 marks lost, 2 wrong flags or a file that does not compile, 3 the grader "
        "failed,\n130 stopped by Ctrl-C.\n"
        "Examples: ./radlab check\n          ./radlab check 3 --hint\n          ./radlab check distributeEnergy --html "
        "--open\n          ./radlab check extensions");
}

void openInBrowser(const std::filesystem::path& page) {
    const std::string quoted = "'" + std::filesystem::absolute(page).string() + "'";
    for (const char* opener : {"wslview", "xdg-open"})
        if (std::system((std::string("command -v ") + opener + " >/dev/null 2>&1").c_str()) == 0 &&
            std::system((std::string(opener) + " " + quoted + " >/dev/null 2>&1").c_str()) == 0)
            return;
    std::cerr << "radlab: no browser could be started; open the page yourself\n";
}

CheckReports reportsOf(const Flags& flags) {
    return {flags.json, flags.junit, flags.gradescope, flags.classroom50, flags.html || flags.open ? flags.out : ""};
}

void report(const StudentResult& verdict, const Flags& flags) {
    const std::filesystem::path page = writeReports(verdict, reportsOf(flags));
    if (page.empty()) return;
    std::cout << "page: " << page.string() << '\n';
    if (flags.open) openInBrowser(page);
}

// Gradescope and Classroom 50 want a verdict on nothing, too.
void expectText(const FileChecker& checker, const std::vector<std::string>& stages, const Flags& flags) {
    std::error_code failure;
    if (std::filesystem::is_regular_file(flags.file, failure) &&
        radlab::readFile(flags.file).find_first_not_of(" \t\r\n") != std::string::npos)
        return;
    StudentResult verdict;
    verdict.result = checker.notCompiled(stages, "");
    report(verdict, flags);
    throw radlab::Error({flags.file}, "found no such file or an empty one, expected a C++ file with the six functions");
}

std::filesystem::path folderOfExtensions(const Flags& flags) {
    return flags.extensions.empty() ? RADLAB_SOURCE_DIR "/exercises/extensions" : flags.extensions;
}

// Beside the six stages, where their folder was named.
void addExtensions(const FileChecker& checker, const Flags& flags, Result& result) {
    if (flags.extensions.empty() || !flags.stage.empty()) return;
    result.extensions = checker.judgeExtensions(checker.manifest().extensions, flags.extensions).extensions;
}

int check(const FileChecker& checker, const std::vector<std::string>& stages, const Flags& flags) {
    StudentResult verdict;
    verdict.outcome = Outcome::graded;
    try {
        verdict.result = checker.judge(stages);
        const int code = exitCode(verdict.result);
        addExtensions(checker, flags, verdict.result);
        report(verdict, flags);
        std::cout << terminalReport(verdict.result, {.color = wantsColor(), .hints = flags.hint});
        return code;
    } catch (const CompileError& error) {
        verdict.result = checker.notCompiled(stages, shownError(error.what(), flags.file));
        addExtensions(checker, flags, verdict.result);
        report(verdict, flags);
        std::cout << compileReport(error.what(), flags.file);
        return 2;
    }
}

// Each out of its own file: one that does not compile leaves the others as they are.
int checkExtensions(const FileChecker& checker, const std::vector<ManifestStage>& extensions, const Flags& flags) {
    StudentResult verdict;
    verdict.outcome = Outcome::graded;
    const std::filesystem::path folder = folderOfExtensions(flags);
    verdict.result = checker.judgeExtensions(extensions, folder);
    report(verdict, flags);
    if (verdict.result.compiled || extensions.size() > 1)
        std::cout << terminalReport(verdict.result, {.color = wantsColor(), .hints = flags.hint});
    if (verdict.result.compiled) return exitCode(verdict.result);
    std::cout << compileReport(verdict.result.compiler, folder);
    return 2;
}

// The extensions asked for; none where the six stages are.
std::vector<ManifestStage> extensionsAsked(const Manifest& manifest, const std::string& name) {
    if (name == "extensions") return manifest.extensions;
    if (name.empty() || !manifest.find(name).isExtension()) return {};
    return {manifest.find(name)};
}

int judged(const FileChecker& checker, const Flags& flags) {
    const std::vector<ManifestStage> extensions = extensionsAsked(checker.manifest(), flags.stage);
    const ReportOptions options{.color = wantsColor(), .hints = flags.hint};
    if (flags.watch && extensions.size() > 1)
        throw radlab::Error("watch follows one file: name the extension, " + extensions.front().stage + " say");
    if (flags.watch && extensions.size() == 1)
        return watchExtension(checker, extensions.front(), folderOfExtensions(flags), options);
    if (!extensions.empty()) return checkExtensions(checker, extensions, flags);
    std::vector<std::string> stages;
    if (!flags.stage.empty()) stages.push_back(checker.manifest().find(flags.stage).stage);
    if (flags.watch) return watch(checker, options);
    expectText(checker, stages, flags);
    return check(checker, stages, flags);
}

int run(const Flags& flags) {
    const radlab::Interrupts interrupts;
    const FileChecker checker(flags.file, flags.seed, flags.jobs);
    tellLacks();
    try {
        return judged(checker, flags);
    } catch (const MachineError& error) {
        StudentResult verdict;
        verdict.outcome = Outcome::error;
        verdict.fault = error.what();
        report(verdict, flags);
        std::cerr << "error: " << error.what() << '\n';
        return 3;
    }
}

}  // namespace

int main(int argc, char** argv) {
    radlab::keepFreedMemory();
    CLI::App app("Says which stages of the exercise are right, and what is wrong with the others.");
    Flags flags;
    describe(app, flags);
    app.set_version_flag("--version", aboutMachine);
    return radlab::runCommandLine(app, argc, argv, [&] { return run(flags); });
}

#include "grader/apps/GradeReports.h"

#include <chrono>
#include <ctime>

#include "base/ProgressBar.h"
#include "base/WholeFile.h"
#include "grader/report/Canvas.h"
#include "grader/report/ClassCsv.h"
#include "grader/report/ClassPage.h"
#include "grader/report/JUnit.h"
#include "grader/report/Moodle.h"
#include "grader/report/StudentPage.h"
#include "grader/sandbox/Sandbox.h"

namespace radlab::grader {

namespace {

namespace fs = std::filesystem;

std::string now() {
    const std::time_t time = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
    char text[32];
    std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", std::gmtime(&time));
    return text;
}

// Without what only a student's own page shows, as a class may be large.
StudentResult forClass(StudentResult result) {
    for (StageResult& stage : result.result.stages)
        for (CheckResult& check : stage.checks) check.output.clear(), check.example.clear();
    return result;
}

std::vector<StudentResult> writeStudentPages(const std::vector<Submission>& submissions, const StoreReader& store,
                                             const fs::path& folder) {
    std::vector<StudentResult> results;
    makeFolder(folder / "students");
    ProgressBar bar("writing pages", static_cast<double>(submissions.size()));
    for (const Submission& submission : submissions) {
        bar.show(static_cast<double>(results.size()));
        const std::optional<StudentResult> found = store.find(submission.student.id);
        if (!found) continue;
        writeFile(folder / studentPageFile(found->student), studentPage(*found, store.pictures(submission.student.id)));
        results.push_back(forClass(*found));
    }
    return results;
}

void tell(std::vector<std::string>& notes, const std::string& what, const FilledGradebook& filled,
          const fs::path& file) {
    notes.push_back(what + ": " + std::to_string(filled.filled) + " marks in " + file.string());
    for (const std::string& note : filled.notes) notes.push_back(what + ": " + note);
    for (const std::string& name : filled.unmatchedStudents) notes.push_back(what + ": no row for " + name);
    for (const std::string& row : filled.unmatchedRows) notes.push_back(what + ": nobody for the row of " + row);
}

// A gradebook of another system.
struct Gradebook {
    const char* what;
    fs::path given, to;
    FillOptions options;
    FilledGradebook (*filled)(const std::string&, const std::vector<StudentResult>&, const FillOptions&);

    FilledGradebook fill(const std::vector<StudentResult>& results) const {
        return filled(readFile(given), results, options);
    }
};

std::vector<Gradebook> gradebooks(const ReportFiles& files) {
    std::vector<Gradebook> all;
    for (const auto& [what, given, filled] :
         {std::tuple("Canvas", files.canvas, &filledCanvas), std::tuple("Moodle", files.moodle, &filledMoodle)}) {
        if (given.empty()) continue;
        Gradebook& book = all.emplace_back(Gradebook{what, given, files.folder / given.filename(), {}, filled});
        book.options.file = given.string();
        book.options.assignment = files.assignment;
    }
    return all;
}

}  // namespace

void checkGradebooks(const ReportFiles& files) {
    for (const Gradebook& book : gradebooks(files)) {
        std::error_code failure;
        if (fs::equivalent(book.given, book.to, failure))
            throw Error({book.given.string()},
                        "the file to fill in lies where its filled-in copy goes: put it elsewhere");
        book.fill({});
    }
}

std::vector<std::string> writeClassReports(const std::vector<Submission>& submissions, const StoreReader& store,
                                           const ReportFiles& files) {
    const std::vector<StudentResult> results = writeStudentPages(submissions, store, files.folder);
    writeFile(files.folder / "marks.csv", marksCsv(results));
    writeFile(files.folder / "checks.csv", checksCsv(results));
    writeFile(files.folder / "junit.xml", classJunitXml(results));
    std::vector<std::string> notes;
    ClassInfo info{
        files.title, now(), files.version, protections(machineSandbox()), {"marks.csv", "checks.csv", "junit.xml"}};
    for (const Gradebook& book : gradebooks(files)) {
        const FilledGradebook filled = book.fill(results);
        writeFile(book.to, filled.text);
        tell(notes, book.what, filled, book.to);
        info.files.push_back(book.to.filename().string());
    }
    writeFile(files.folder / "index.html", classPage(info, results));
    return notes;
}

}  // namespace radlab::grader

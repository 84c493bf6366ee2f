#pragma once

// Invented classes for the tests of the reports.

#include <string>
#include <utility>
#include <vector>

#include "grader/protocol/Student.h"
#include "grader/report/SampleResult.h"

namespace radlab::grader::test {

inline StudentResult without(std::string id, Outcome outcome) {
    StudentResult student;
    student.student.id = student.student.name = student.student.account = std::move(id);
    student.outcome = outcome;
    return student;
}

inline StudentResult graded(std::string id, Result result) {
    StudentResult student = without(std::move(id), Outcome::graded);
    student.student.submitted = "2026-11-20T17:04:00Z";
    student.graded = "2026-11-23T09:12:00Z";
    student.result = std::move(result);
    return student;
}

inline Result notCompiled() {
    Result result;
    result.maxScore = 100;
    result.seed = 42;
    result.compiled = false;
    result.compiler = "ProgRef.cpp:88:17: error: 'shooterr' was not declared in this scope\n";
    return result;
}

/// One student of each kind: 01 all right, 02 one wrong and late, 03 nothing, 04 refused, 05 an error, 06 does not
/// compile.
inline std::vector<StudentResult> smallClass() {
    std::vector<StudentResult> all = {
        graded("student-01", resultWith(Status::pass)), graded("student-02", oneWrong()),
        without("student-03", Outcome::nothing),        without("student-04", Outcome::refused),
        without("student-05", Outcome::error),          graded("student-06", notCompiled())};
    all[1].student.late = true;
    all[3].student.remarks = {"../ProgRef.cpp: a name that leads out of the folder"};
    all[4].fault = "the worker did not start";
    return all;
}

/// A class with the same text for everything that a student may choose.
inline std::vector<StudentResult> classSaying(const std::string& text) {
    std::vector<StudentResult> all = smallClass();
    for (StudentResult& student : all) {
        student.student.name = student.student.account = student.student.submitted = student.fault = text;
        student.student.remarks = {text, text};
        student.result.compiler = text;
        student.result.submission = text;
        student.result = withTexts(student.result, text);
    }
    return all;
}

/// So many students, some of each kind.
inline std::vector<StudentResult> largeClass(std::size_t count) {
    const std::vector<StudentResult> kinds = smallClass();
    std::vector<StudentResult> all;
    for (std::size_t i = 0; i < count; ++i) {
        all.push_back(kinds[i % kinds.size()]);
        const std::string id = "student-" + std::to_string(10000 + i);
        all.back().student.id = all.back().student.name = all.back().student.account = id;
    }
    return all;
}

}  // namespace radlab::grader::test

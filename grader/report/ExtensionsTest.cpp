// Extensions in every report: shown, and worth no marks.

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include "grader/report/ClassCsv.h"
#include "grader/report/Gradescope.h"
#include "grader/report/JUnit.h"
#include "grader/report/PageTestHelp.h"
#include "grader/report/SampleClass.h"
#include "grader/report/Terminal.h"
#include "grader/report/Wording.h"

using namespace radlab::grader;
using namespace radlab::grader::test;

namespace {

StageResult wrongExtension() {
    StageResult extension = stage(8, "hemisphereFF", Status::fail, 10);
    extension.title = "form factors by rays";
    extension.score = 6;
    extension.checks = {check("rays.share", "a form factor is a share", Status::pass, 6), tellingCheck()};
    return extension;
}

Result extensionsAlone() {
    Result result;
    result.submission = "exercises/extensions";
    result.extensions = {wrongExtension(), stage(9, "antialias", Status::notStarted, 10)};
    return result;
}

Result beside(Result result) {
    result.extensions = extensionsAlone().extensions;
    return result;
}

}  // namespace

TEST_CASE("extensions: alone, the terminal shows them with what is wrong, and points that are no marks") {
    const std::string report = terminalReport(extensionsAlone());
    CHECK(contains(report, "  8  hemisphereFF  6/10  wrong\n"));
    CHECK(contains(report, "  9  antialias     0/10  not started\n"));
    CHECK(contains(report, "hemisphereFF (extension): 1 of 2 checks fails\n"));
    CHECK(contains(report, "extensions: 6/20, beside the marks\n"));
    CHECK_FALSE(contains(report, "score:"));
    CHECK(contains(report, "next: mend hemisphereFF (extension) in …/extensions; ./radlab check hemisphereFF --hint"));
}

TEST_CASE("extensions: the next step goes from what is wrong to what is not written, and ends") {
    Result result = extensionsAlone();
    result.extensions[0].status = Status::pass;
    CHECK(nextStep(result, true).front() ==
          "write antialias (extension) in exercises/extensions, then ./radlab check antialias");
    result.extensions[1].status = Status::pass;
    CHECK(nextStep(result, true).front() == "nothing is left to do here: what was judged is right");
}

TEST_CASE("extensions: beside the stages, score, verdict and next step stay those of the stages") {
    for (const Result& plain : {oneWrong(), resultWith(Status::pass), resultWith(Status::notStarted)}) {
        const Result both = beside(plain);
        CHECK(verdictText(both) == verdictText(plain));
        CHECK(nextStep(both, true) == nextStep(plain, true));
        CHECK(allRight(both) == allRight(plain));
        CHECK(nothingStarted(both) == nothingStarted(plain));
        CHECK(terminalReport(both) == terminalReport(plain));
    }
}

TEST_CASE("extensions: the page shows them after the stages, and alone it shows no mark") {
    const std::string both = verdictPage(beside(oneWrong())), alone = verdictPage(extensionsAlone());
    for (const std::string& page : {both, alone}) {
        CHECK(contains(page, "hemisphereFF"));
        CHECK(contains(page, "extension, beside the marks: form factors by rays"));
    }
    CHECK(contains(both, "68 <small>of 100 marks"));
    CHECK_FALSE(contains(alone, " marks</small>"));
    CHECK(contains(alone, "no mark"));
}

TEST_CASE("extensions: Gradescope gets the checks without any points, and the score of the stages") {
    const StudentResult student = graded("student-01", beside(oneWrong()));
    const nlohmann::json file = nlohmann::json::parse(gradescopeJson(student));
    CHECK(file.at("score") == 68);
    int shown = 0;
    for (const nlohmann::json& test : file.at("tests")) {
        if (test.at("name").get<std::string>().find("extension hemisphereFF: ") != 0) continue;
        ++shown;
        CHECK_FALSE(test.contains("score"));
        CHECK_FALSE(test.contains("max_score"));
    }
    CHECK(shown == 2);
}

TEST_CASE("extensions: JUnit gets a suite for each, and the gradebook of a class is as it was") {
    CHECK(contains(junitXml(beside(oneWrong())), "<testsuite name=\"hemisphereFF\""));
    const StudentResult plain = graded("student-01", oneWrong()), both = graded("student-01", beside(oneWrong()));
    CHECK(marksCsv({both}) == marksCsv({plain}));
    CHECK(checksCsv({both}) == checksCsv({plain}));
}

#include "grader/report/ClassFigures.h"

#include <doctest/doctest.h>

#include "grader/report/Histogram.h"
#include "grader/report/SampleClass.h"

using namespace radlab::grader;
using namespace radlab::grader::test;

TEST_CASE("class figures: who has a mark counts in mean and median, and nobody else") {
    const ClassFigures figures = figuresOf(smallClass());
    CHECK(figures.students == 6);
    CHECK(figures.outcomes ==
          std::map<std::string, std::size_t>{
              {"graded", 2}, {"does not compile", 1}, {"nothing handed in", 1}, {"refused", 1}, {"grader failed", 1}});
    CHECK(figures.late == 1);
    CHECK(figures.scores == std::vector<double>{100, 68, 0});
    CHECK(figures.mean == doctest::Approx(56));
    CHECK(figures.median == 68);
    CHECK(figures.maxScore == 100);
}

TEST_CASE("class figures: the median of an even number is halfway between the middle two") {
    std::vector<StudentResult> students = smallClass();
    students.resize(2);
    CHECK(figuresOf(students).median == 84);
    CHECK(figuresOf({}).median == 0);
    CHECK(figuresOf({}).mean == 0);
}

TEST_CASE("class figures: a result in which the grader failed is no mark") {
    const ClassFigures figures = figuresOf({graded("student-01", resultWith(Status::error))});
    CHECK(figures.scores.empty());
    CHECK(figures.stages.empty());
    CHECK(figures.outcomes.at("grader failed") == 1);
}

TEST_CASE("class figures: each stage has its scores, and each check those whom it passed") {
    const ClassFigures figures = figuresOf(smallClass());
    REQUIRE(figures.stages.size() == 7);
    const StageFigures& stage = figures.stages[1];
    CHECK(stage.stage == "calcAnalyticalFF");
    CHECK(stage.scores == std::vector<double>{20, 8});
    CHECK(stage.passed == 1);
    REQUIRE(stage.checks.size() == 5);
    CHECK(stage.checks[0].id == "ff.shooter");
    CHECK(stage.checks[0].passed == 1);
    CHECK(stage.checks[1].passed == 0);
    CHECK(stage.checks[1].judged == 1);
    CHECK(figures.stages[5].notStarted == 1);
}

TEST_CASE("class figures: a mistake counts once a student, the most common first") {
    Result rare = oneWrong();
    rare.stages[1].checks[1].diagnosis->id = "rare";
    Result twice = oneWrong();
    twice.stages[1].checks[2].diagnosis = twice.stages[1].checks[1].diagnosis;
    const ClassFigures figures =
        figuresOf({graded("student-01", rare), graded("student-02", twice), graded("student-03", oneWrong())});
    REQUIRE(figures.misconceptions.size() == 2);
    CHECK(figures.misconceptions[0].diagnosis.id == "missing-inverse-pi");
    CHECK(figures.misconceptions[0].students == std::vector<std::size_t>{1, 2});
    CHECK(figures.misconceptions[1].students == std::vector<std::size_t>{0});
}

TEST_CASE("histogram: ten equal parts, a whole tenth begins one, and full marks are in the last") {
    CHECK(histogramOf({0, 9.99, 10, 30, 70, 99, 100}, 100) == std::vector<int>{2, 1, 0, 1, 0, 0, 0, 1, 0, 2});
    CHECK(histogramOf({5.999999999999999}, 10) == std::vector<int>{0, 0, 0, 0, 0, 0, 1, 0, 0, 0});
    CHECK(histogramOf({-5, 200}, 100) == std::vector<int>{1, 0, 0, 0, 0, 0, 0, 0, 0, 1});
    CHECK_THROWS_AS(histogramOf({}, 0), std::logic_error);
}

TEST_CASE("histogram: the tallest bar fills the height, and each says its count") {
    const std::string svg = histogramSvg({5, 5, 95}, 100, 138, "Marks of <all>");
    CHECK(svg.find("aria-label=\"Marks of &lt;all&gt;\"") != std::string::npos);
    CHECK(svg.find("<title>0 to below 10 marks: 2 students</title>") != std::string::npos);
    CHECK(svg.find("<title>90 to 100 marks: 1 student</title>") != std::string::npos);
    CHECK(svg.find("class=\"column\" x=\"0.4%\" y=\"18\" width=\"9.2%\" height=\"100\"") != std::string::npos);
    CHECK(svg.find("class=\"column\" x=\"90.4%\" y=\"68\" width=\"9.2%\" height=\"50\"") != std::string::npos);
}

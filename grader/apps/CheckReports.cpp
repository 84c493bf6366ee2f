#include "grader/apps/CheckReports.h"

#include <nlohmann/json.hpp>

#include "base/WholeFile.h"
#include "grader/report/Classroom50.h"
#include "grader/report/Gradescope.h"
#include "grader/report/HtmlReport.h"
#include "grader/report/JUnit.h"
#include "grader/report/Wording.h"

namespace radlab::grader {

std::filesystem::path writeReports(const StudentResult& verdict, const CheckReports& reports) {
    if (!reports.gradescope.empty()) radlab::writeFile(reports.gradescope, gradescopeJson(verdict));
    if (!reports.classroom50.empty() && outcomeWord(verdict) != "grader failed")
        radlab::writeFile(reports.classroom50, classroom50Json(verdict));
    if (verdict.outcome != Outcome::graded) return {};
    const Result& result = verdict.result;
    if (!reports.json.empty()) radlab::writeFile(reports.json, resultToJson(result).dump(2) + "\n");
    if (!reports.junit.empty()) radlab::writeFile(reports.junit, junitXml(result));
    return reports.page.empty() ? reports.page : writeHtmlReport(result, reports.page);
}

}  // namespace radlab::grader

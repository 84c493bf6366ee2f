#include "grader/report/JUnit.h"

#include <doctest/doctest.h>
#include <tinyxml2.h>

#include "grader/protocol/PlainText.h"
#include "grader/report/SampleClass.h"

using namespace radlab::grader;
using namespace radlab::grader::test;
using tinyxml2::XMLElement;

namespace {

// The parsed file, and the elements that the tests ask for.
struct Parsed {
    explicit Parsed(const Result& result) : Parsed(junitXml(result)) {}
    explicit Parsed(const std::string& xml) { REQUIRE(document.Parse(xml.c_str()) == tinyxml2::XML_SUCCESS); }

    const XMLElement* root() const { return document.RootElement(); }
    const XMLElement* suite(int index) const { return nth(root(), "testsuite", index); }
    const XMLElement* testcase(int stage, int index) const { return nth(suite(stage), "testcase", index); }

    static const XMLElement* nth(const XMLElement* parent, const char* name, int index) {
        const XMLElement* child = parent->FirstChildElement(name);
        while (child && index-- > 0) child = child->NextSiblingElement(name);
        REQUIRE(child);
        return child;
    }

    tinyxml2::XMLDocument document;
};

std::string attribute(const XMLElement* element, const char* name) {
    const char* value = element->Attribute(name);
    return value ? value : "";
}

}  // namespace

TEST_CASE("JUnit: a suite for each stage, a test case for each check, with the counts of both") {
    const Parsed file(oneWrong());
    CHECK(std::string(file.root()->Name()) == "testsuites");
    CHECK(attribute(file.root(), "tests") == "11");
    CHECK(attribute(file.root(), "failures") == "3");
    CHECK(attribute(file.root(), "errors") == "0");
    CHECK(attribute(file.root(), "skipped") == "2");
    CHECK(attribute(file.suite(1), "name") == "calcAnalyticalFF");
    CHECK(attribute(file.suite(1), "file") == "exercises/ProgRef.cpp");
    CHECK(attribute(file.suite(1), "tests") == "5");
    CHECK(attribute(file.testcase(1, 1), "name") == "two facing patches match the formula");
    CHECK(attribute(file.testcase(1, 1), "classname") == "radlab.calcAnalyticalFF");
    CHECK(attribute(file.testcase(1, 1), "time") == "0.000");
}

TEST_CASE("JUnit: a wrong check is a failure that says what was found, a right one has no child") {
    const Parsed file(oneWrong());
    const XMLElement* failure = file.testcase(1, 1)->FirstChildElement("failure");
    REQUIRE(failure);
    CHECK(attribute(failure, "type") == "missing-inverse-pi");
    CHECK(attribute(failure, "message").rfind("F(0 -> 1) is 0.25", 0) == 0);
    CHECK(std::string(failure->GetText()).find("What is wrong: Every form factor") != std::string::npos);
    CHECK(std::string(file.testcase(1, 1)->FirstChildElement("system-out")->GetText()) ==
          "debug: cos = 1.000000\ndebug: F = 0.25\n");
    CHECK(file.testcase(1, 0)->NoChildren());
}

TEST_CASE("JUnit: a failure of the grader is an error, what was not judged is skipped") {
    const std::pair<Status, std::string> expected[] = {{Status::error, "error"},
                                                       {Status::fail, "failure"},
                                                       {Status::notStarted, "skipped"},
                                                       {Status::blocked, "skipped"},
                                                       {Status::skipped, "skipped"}};
    for (const auto& [status, element] : expected) {
        CAPTURE(element);
        Result result = oneWrong();
        result.stages[1].checks[0].status = status;
        CHECK(Parsed(result).testcase(1, 0)->FirstChildElement(element.c_str()));
    }
}

TEST_CASE("JUnit: a stage without checks has one test case that bears its status") {
    const Parsed file(oneWrong());
    CHECK(attribute(file.testcase(5, 0), "name") == "calcFF");
    CHECK(attribute(file.testcase(5, 0)->FirstChildElement("skipped"), "message") == "not started");
    CHECK(file.testcase(0, 0)->NoChildren());
}

TEST_CASE("JUnit: hostile texts leave the file well-formed, without characters that XML forbids") {
    const Result result = withTexts(oneWrong(), hostileText());
    const std::string xml = junitXml(result);
    CHECK(xmlText(xml) == xml);
    const Parsed file(result);
    CHECK(attribute(file.root(), "tests") == "11");
    CHECK(std::string(file.testcase(1, 1)->FirstChildElement("system-out")->GetText()).find("</pre><script>") !=
          std::string::npos);
    CHECK_FALSE(file.testcase(1, 1)->FirstChildElement("script"));
}

TEST_CASE("JUnit: very long texts are cut") {
    Result result = withTexts(oneWrong(), std::string(1 << 20, '<'));
    CHECK(junitXml(result).size() < 5 << 20);
    Parsed file(result);
    CHECK(attribute(file.testcase(1, 1), "name").size() == 1024);
}

TEST_CASE("JUnit: a submission that does not compile is one failure with what the compiler said") {
    const Parsed file(notCompiled());
    CHECK(attribute(file.root(), "failures") == "1");
    CHECK(attribute(file.testcase(0, 0), "name") == "the submission compiles");
    CHECK(std::string(file.testcase(0, 0)->FirstChildElement("failure")->GetText()).find("shooterr") !=
          std::string::npos);
}

TEST_CASE("JUnit of a class: a suite for each student, a test case for each check, with the counts of both") {
    const Parsed file(classJunitXml(smallClass()));
    CHECK(attribute(file.root(), "tests") == "22");
    CHECK(attribute(file.root(), "failures") == "5");
    CHECK(attribute(file.root(), "errors") == "1");
    CHECK(attribute(file.root(), "skipped") == "3");
    CHECK(attribute(file.suite(1), "name") == "student-02");
    CHECK(attribute(file.suite(1), "tests") == "11");
    CHECK(attribute(file.suite(1), "timestamp") == "2026-11-23T09:12:00Z");
    CHECK(attribute(file.testcase(1, 2), "classname") == "student-02.calcAnalyticalFF");
    CHECK_FALSE(file.testcase(1, 2)->FirstChildElement("system-out"));
}

TEST_CASE("JUnit of a class: where nothing was judged, one test case says why") {
    const Parsed file(classJunitXml(smallClass()));
    CHECK(attribute(file.testcase(2, 0)->FirstChildElement("skipped"), "message") == "nothing handed in");
    CHECK(attribute(file.testcase(3, 0)->FirstChildElement("failure"), "message").find("leads out of the folder") !=
          std::string::npos);
    CHECK(attribute(file.testcase(4, 0)->FirstChildElement("error"), "message") == "the worker did not start");
    CHECK(attribute(file.testcase(5, 0), "name") == "the submission compiles");
}

TEST_CASE("JUnit of a class: hostile names and a thousand students leave the file well-formed") {
    const std::string hostile = classJunitXml(classSaying(hostileText()));
    CHECK(xmlText(hostile) == hostile);
    CHECK(attribute(Parsed(hostile).root(), "tests") == "22");
    CHECK(attribute(Parsed(classJunitXml(largeClass(1000))).root(), "errors") == "166");
}

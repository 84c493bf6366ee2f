#include "grader/report/CsvFile.h"

#include <doctest/doctest.h>

#include "grader/report/SampleResult.h"

using namespace radlab::grader;

namespace {

CsvFile csv(const std::string& text) { return CsvFile(text, "marks.csv"); }

std::string faultOf(const std::string& text) {
    try {
        csv(text);
    } catch (const radlab::Error& error) {
        return error.what();
    }
    return "";
}

// What a reader of RFC 4180 gets back of one row.
std::vector<std::string> readBack(const std::string& row) {
    const CsvFile file = csv(row);
    REQUIRE(file.rows() == 1);
    std::vector<std::string> values;
    for (std::size_t column = 0; column < file.columns(0); ++column) values.push_back(file.cell(0, column));
    return values;
}

}  // namespace

TEST_CASE("CSV: a file that is not changed stays the same, byte for byte") {
    for (const std::string text : {"a,b\r\n1,2\r\n", "a,b\n1,2", "a;b\n\"1;5\";2\n",
                                   "\xef\xbb\xbfName,\"a \"\"b\"\"\"\r\n\r\n\"x\ny\",\xff\xfe\r\n", "a\tb\r1\t2\r",
                                   "a,,\n,,\n\n\n", "a,b\n  \n1\n", "a\"b,c\n"}) {
        CAPTURE(text);
        CHECK(csv(text).text() == text);
    }
}

TEST_CASE("CSV: cells are read with commas, quotes and newlines inside") {
    const CsvFile file = csv("Name,Note\r\n\"a, \"\"b\"\"\",\"x\r\ny\"\r\nlast,\r\n");
    REQUIRE(file.rows() == 3);
    CHECK(file.columns(1) == 2);
    CHECK(file.cell(1, 0) == "a, \"b\"");
    CHECK(file.cell(1, 1) == "x\r\ny");
    CHECK(file.cell(2, 1).empty());
    CHECK(file.cell(2, 7).empty());
    CHECK(file.where(2).line == 4);
}

TEST_CASE("CSV: the delimiter is what splits the first line most") {
    CHECK(csv("a;b;c,d\n").delimiter() == ';');
    CHECK(csv("a,b,c;d\n").delimiter() == ',');
    CHECK(csv("a\tb\n").delimiter() == '\t');
    CHECK(csv("\"a;b;c\",d\n").delimiter() == ',');
    CHECK(csv("alone\n").delimiter() == ',');
}

TEST_CASE("CSV: only the cells that are set change") {
    CsvFile file = csv("\xef\xbb\xbf\"a\";b\r\n\"old\";  x \r\n;\r\n");
    file.set(1, 0, "new");
    file.set(2, 0, "1,5");
    file.set(2, 1, "a;b\"c");
    CHECK(file.text() == "\xef\xbb\xbf\"a\";b\r\n\"new\";  x \r\n1,5;\"a;b\"\"c\"\r\n");
    CHECK(file.cell(1, 0) == "new");
    file.set(1, 0, "");
    CHECK(file.text() == "\xef\xbb\xbf\"a\";b\r\n\"\";  x \r\n1,5;\"a;b\"\"c\"\r\n");
}

TEST_CASE("CSV: a broken file is an error that names file and line") {
    CHECK(faultOf("a,b\n1,\"2\n3\n").find("marks.csv:2: a quote is opened and never closed") == 0);
    CHECK(faultOf("\"").find("marks.csv:1: a quote is opened") == 0);
    CHECK(faultOf("a\n\"b\"\"").find("marks.csv:2: a quote is opened") == 0);
    CHECK(faultOf("a\n\"b\nc\"d\n").find("marks.csv:3: text after a closing quote: found 'd'") == 0);
    CHECK(faultOf("").find("marks.csv: is empty") == 0);
    CHECK(faultOf("\xef\xbb\xbf\n\n").find("marks.csv: is empty") == 0);
    CHECK(faultOf(std::string("\xff\xfe"
                              "a\0b\0",
                              6))
              .find("marks.csv: is no CSV file") == 0);
    CsvFile file = csv("a,b\n1\n");
    CHECK_THROWS_WITH(file.set(1, 1, "x"), "marks.csv:2: the line is too short: found 1 cells, expected at least 2");
}

TEST_CASE("CSV: a new row reads back as the values that it was made of") {
    for (const std::string value : {"", "plain", "a,b", "say \"no\"", "two\nlines", " edge ", "\"", "a;b"}) {
        CAPTURE(value);
        CHECK(readBack(csvRow({value, "x", value})) == std::vector<std::string>{value, "x", value});
    }
    CHECK(csvRow({"", "a"}) == ",a\r\n");
    CHECK(csvCell("a;b", ';') == "\"a;b\"");
}

TEST_CASE("CSV: no text becomes a formula, and numbers stay numbers") {
    CHECK(spreadsheetText("=HYPERLINK(\"x\")") == "'=HYPERLINK(\"x\")");
    for (const std::string sign : {"=", "+", "-", "@", "  =", "＝", "＋1;", "－", "＠"}) {
        CAPTURE(sign);
        CHECK(spreadsheetText(sign + "cmd") == "'" + sign + "cmd");
    }
    CHECK(spreadsheetText("\t=1+1") == "' =1+1");
    CHECK(spreadsheetText("\r=1+1") == "\\x0d=1+1");
    CHECK(spreadsheetText("a;=1+1;b; @x") == "a;'=1+1;b;' @x");
    CHECK(spreadsheetText("-1.5") == "-1.5");
    CHECK(spreadsheetText("+12") == "+12");
    CHECK(spreadsheetText("-nan(1)") == "'-nan(1)");
    CHECK(spreadsheetText("student-07") == "student-07");
    CHECK(spreadsheetText("") == "");
}

TEST_CASE("CSV: hostile bytes come out as text on one line, without control characters") {
    const std::string text = spreadsheetText(test::hostileText());
    CHECK(text.find_first_of("\n\r\t\x1b\x08") == std::string::npos);
    CHECK(text.find("\u202E") == std::string::npos);
    CHECK(readBack(csvRow({text})) == std::vector<std::string>{text});
}

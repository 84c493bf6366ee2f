#pragma once

// What tests of texts and pages ask.

#include <string>

#include "base/TestFolder.h"
#include "base/WholeFile.h"
#include "grader/report/HtmlReport.h"

namespace radlab::grader::test {

inline bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

inline std::size_t countOf(const std::string& text, const std::string& part) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
    return count;
}

/// The page of a verdict, without its pictures.
inline std::string verdictPage(const Result& result) {
    const radlab::test::Folder folder;
    return readFile(writeHtmlReport(result, folder / "report"));
}

}  // namespace radlab::grader::test

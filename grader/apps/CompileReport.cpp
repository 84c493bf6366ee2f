#include "grader/apps/CompileReport.h"

namespace radlab::grader {

std::string shownError(const std::string& firstError, const std::filesystem::path& file) {
    std::string text = firstError;
    const std::string absolute = std::filesystem::absolute(file).string(),
                      shown = std::filesystem::proximate(file).string();
    for (std::size_t at = text.find(absolute); at != std::string::npos; at = text.find(absolute, at + shown.size()))
        text.replace(at, absolute.size(), shown);
    return text;
}

std::string compileReport(const std::string& firstError, const std::filesystem::path& file) {
    return shownError(firstError, file) + "\nnext: correct this first error; the others may follow from it\n";
}

}  // namespace radlab::grader

#include "grader/report/Page.h"

#include <algorithm>

#include "base/Error.h"
#include "base/WholeFile.h"
#include "grader/protocol/PlainText.h"
#include "grader/report/Wording.h"

namespace radlab::grader {

namespace {

using kainjow::mustache::data;

constexpr const char* folder = "resources/grader/";
constexpr std::size_t longestOnPage = 65536;  // bytes of one text; a browser wants no page of many megabytes

}  // namespace

std::string pageResource(const std::string& name) {
    return readFile(std::string(RADLAB_SOURCE_DIR "/") + folder + name);
}

std::string renderPage(const std::string& name, data& values) {
    kainjow::mustache::mustache page(pageResource(name));
    if (!page.is_valid()) throw Error({folder + name}, page.error_message());
    values.set("style", pageResource("style.css"));
    return page.render(values);
}

std::string shown(const std::string& bytes) {
    const std::string_view start = startOf(bytes, longestOnPage);
    const std::size_t left = bytes.size() - start.size();
    return visibleText(start) + (left > 0 ? "\n… and " + std::to_string(left) + " bytes more" : "");
}

void setUnlessEmpty(data& entry, const char* key, const std::string& text) {
    if (!text.empty()) entry.set(key, text);
}

void setStatus(data& entry, Status status) {
    entry.set("status_class", statusText(status));
    entry.set("status_word", statusWord(status));
}

void setMarks(data& entry, double score, double maxScore) {
    if (maxScore <= 0.0) return;
    entry.set("marks", marksText(score) + "/" + marksText(maxScore));
    entry.set("percent", percentText(score, maxScore));
}

std::string percentText(double score, double maxScore) {
    const double share = maxScore > 0.0 ? score / maxScore : 0.0;
    return marksText(std::clamp(100.0 * share, 0.0, 100.0));
}

}  // namespace radlab::grader

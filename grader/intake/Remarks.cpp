#include "grader/intake/Remarks.h"

#include <utility>

#include "grader/protocol/PlainText.h"

namespace radlab::grader {

namespace {

constexpr std::size_t longestName = 120;

}  // namespace

std::string visibleLine(std::string_view bytes) {
    std::string line;
    for (const char byte : visibleText(bytes)) {
        if (byte == '\n')
            line += "\\x0a";
        else if (byte == '\t')
            line += "\\x09";
        else
            line += byte;
    }
    return line;
}

std::string shownName(std::string_view name) {
    const std::string_view start = startOf(name, longestName);
    return visibleLine(start) + (start.size() < name.size() ? "..." : "");
}

std::string shownNames(const std::vector<std::string>& names, bool more) {
    std::string text;
    for (const std::string& name : names) text += (text.empty() ? "" : ", ") + shownName(name);
    return more ? text + " and more" : text;
}

Remarks::Remarks(std::size_t toKeep) : most(toKeep) {}

void Remarks::note(std::string text) { add({std::move(text), false}); }

void Remarks::refuse(std::string text) { add({std::move(text), true}); }

void Remarks::add(Remark remark) {
    refused = refused || remark.refuses;
    if (kept.size() < most)
        kept.push_back(std::move(remark));
    else
        ++left;
}

void Remarks::add(const Remarks& others) {
    for (const Remark& remark : others.kept) add(remark);
    refused = refused || others.refused;
    left += others.left;
}

std::vector<std::string> Remarks::lines() const {
    std::vector<std::string> texts;
    for (const Remark& remark : kept) texts.push_back(remark.text);
    if (left) texts.push_back("and " + std::to_string(left) + " more such remarks");
    return texts;
}

}  // namespace radlab::grader

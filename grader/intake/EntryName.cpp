#include "grader/intake/EntryName.h"

#include <vector>

#include "grader/intake/Folder.h"
#include "grader/protocol/PlainText.h"

namespace radlab::grader {

namespace {

constexpr std::size_t longest = 255;

// Some programs of Windows write '\' between folders.
char separatorOf(std::string_view name) { return name.find('/') == std::string_view::npos ? '\\' : '/'; }

bool isAbsolute(std::string_view name) {
    const bool hasDrive = name.size() >= 2 && name[1] == ':';
    return hasDrive || name.front() == '/' || name.front() == '\\';
}

std::vector<std::string> partsOf(std::string_view name) {
    const char separator = separatorOf(name);
    std::vector<std::string> parts(1);
    for (const char byte : name) {
        if (byte == separator)
            parts.emplace_back();
        else
            parts.back() += byte;
    }
    return parts;
}

std::string oddityOf(const std::string& path) {
    if (path.size() > longest) return "a name of " + std::to_string(path.size()) + " bytes, expected at most 255";
    const std::string text = validUtf8(path);  // older Windows writes names in its own code page
    if (visibleText(text) != text || path.find_first_of("\n\t") != std::string::npos)
        return "a name with control characters";
    return "";
}

EntryName faulty(std::string_view name, const std::string& fault) {
    EntryName read;
    read.path = name;
    read.fault = fault;
    return read;
}

}  // namespace

EntryName readEntryName(std::string_view name) {
    if (name.empty()) return faulty(name, "an entry without a name");
    if (isAbsolute(name)) return faulty(name, "an absolute name, which is not taken");
    EntryName read;
    for (const std::string& part : partsOf(name)) {
        if (part.empty() || part == ".") continue;
        if (part == "..") return faulty(name, "a name with \"..\", which is not taken");
        read.passedOver = read.passedOver || isPassedOver(part);
        if (!read.path.empty()) {
            read.path += '/';
            ++read.folders;
        }
        read.path += part;
    }
    read.oddity = oddityOf(read.path);
    return read;
}

}  // namespace radlab::grader

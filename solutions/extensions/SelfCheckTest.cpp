#include <filesystem>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "base/WholeFile.h"

using radlab::readFile;

namespace {

const std::filesystem::path exercises = RADLAB_SOURCE_DIR "/exercises/extensions";
const std::filesystem::path solutions = RADLAB_SOURCE_DIR "/solutions/extensions";

// Each file, and its function, in the order of the extensions.
const std::vector<std::pair<std::string, std::string>> extensions = {
    {"Hemisphere.cpp", "hemisphereFF"}, {"AntiAliasing.cpp", "antialias"}, {"Mirror.cpp", "mirrorScene"}};

// The beginnings of functions defined at file scope and seen from outside.
std::vector<std::string> definitions(const std::filesystem::path& file) {
    const std::string text = readFile(file);
    const std::regex beginning(R"((?:^|\n)((?!static)[\w:][\w:*]* \w+\([^()]*\)) \{)");
    std::vector<std::string> found;
    for (std::sregex_iterator it(text.begin(), text.end(), beginning), end; it != end; ++it) found.push_back((*it)[1]);
    return found;
}

int count(const std::string& text, const std::string& word) {
    int found = 0;
    for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + word.size())) ++found;
    return found;
}

std::set<std::string> sourcesIn(const std::filesystem::path& folder) {
    std::set<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        const std::string name = entry.path().filename().string();
        if (name.find("Test.cpp") == std::string::npos) names.insert(name);
    }
    return names;
}

}  // namespace

TEST_CASE("exercise and solutions have the same extensions, a file each") {
    std::set<std::string> names;
    for (const auto& [file, function] : extensions) names.insert(file);
    CHECK(sourcesIn(exercises) == names);
    CHECK(sourcesIn(solutions) == names);
}

TEST_CASE("each extension offers its one function, the same in exercise and solution, and needs Extensions.h alone") {
    for (const auto& extension : extensions) {
        const std::string &file = extension.first, &function = extension.second;
        CAPTURE(file);
        const std::vector<std::string> offered = definitions(exercises / file);
        REQUIRE(offered.size() == 1);
        CHECK(offered[0].find(" " + function + "(") != std::string::npos);
        CHECK(definitions(solutions / file) == offered);
        for (const std::filesystem::path& folder : {exercises, solutions}) {
            CHECK(count(readFile(folder / file), "#include") == 1);
            CHECK(count(readFile(folder / file), "#include \"Extensions.h\"\n") == 1);
        }
    }
}

TEST_CASE("each stub is marked once and throws its name, and the solutions have no stub") {
    for (std::size_t i = 0; i < extensions.size(); ++i) {
        const std::string text = readFile(exercises / extensions[i].first);
        const std::string solved = readFile(solutions / extensions[i].first);
        CHECK(count(text, "TODO") == 1);
        CHECK(count(text, "// TODO extension " + std::to_string(i + 1) + "\n") == 1);
        CHECK(count(text, "throw NotImplemented(\"" + extensions[i].second + "\")") == 1);
        for (const std::string word : {"TODO", "throw NotImplemented"}) CHECK(count(solved, word) == 0);
    }
}

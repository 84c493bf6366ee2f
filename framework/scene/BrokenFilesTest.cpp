// Runs over resources/broken: each file there is wrong in one way, and EXPECTED.txt says what its error names.

#include <filesystem>
#include <fstream>
#include <map>

#include "scene/ResourceFile.h"
#include "scene/SceneTestHelp.h"
#include "scene/XmlText.h"

using namespace radlab;
using namespace radlab::test;

namespace {

const std::filesystem::path folder = std::filesystem::path(RADLAB_SOURCE_DIR) / "resources" / "broken";

struct Expected {
    int line = 0;
    std::string message;
};

std::string trimmed(const std::string& text) {
    const auto first = text.find_first_not_of(" \t\r");
    return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

/// The table `file | line, or 0 | piece of the message`.
std::map<std::string, Expected> readExpected() {
    std::map<std::string, Expected> table;
    std::ifstream stream(folder / "EXPECTED.txt");
    for (std::string row; std::getline(stream, row);) {
        if (trimmed(row).empty() || row.starts_with('#')) continue;
        const auto first = row.find('|'), second = row.find('|', first + 1);
        REQUIRE(second != std::string::npos);
        table[trimmed(row.substr(0, first))] = {std::stoi(row.substr(first + 1)), trimmed(row.substr(second + 1))};
    }
    return table;
}

std::string errorOfFile(const std::filesystem::path& file) {
    const WarningCapture quiet;
    return errorOf([&] {
        if (file.extension() == ".xml")
            readResource(file);
        else
            readX3d(file);
    });
}

}  // namespace

TEST_CASE("every broken file is an error that says where and what") {
    for (const auto& row : readExpected()) {
        const auto& name = row.first;
        const Expected& expected = row.second;
        const auto file = folder / name;
        const std::string message = errorOfFile(file);
        const std::string place = pathText(file) + ":" + (expected.line ? std::to_string(expected.line) + ":" : "");
        CAPTURE(message);
        CAPTURE(place);
        CAPTURE(expected.message);
        CHECK(message.starts_with(place + " "));
        CHECK(contains(message, expected.message));
    }
}

TEST_CASE("every broken file is in the table of what is expected") {
    const auto table = readExpected();
    CHECK(table.size() >= 34);
    std::size_t files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        const std::string name = pathText(entry.path().filename());
        if (name == "EXPECTED.txt") continue;
        CAPTURE(name);
        CHECK(table.contains(name));
        ++files;
    }
    CHECK(files == table.size());
}

#include <regex>
#include <set>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "base/WholeFile.h"
#include "course/ProgRef.h"

using radlab::readFile;

namespace {

const std::string exercise = RADLAB_SOURCE_DIR "/exercises/ProgRef.cpp";
const std::string solution = RADLAB_SOURCE_DIR "/solutions/ProgRef.cpp";
const std::string olderStyle = RADLAB_SOURCE_DIR "/solutions/OlderStyle.cpp";

const std::vector<std::string> names = {"maxenergy_patch",     "calcAnalyticalFF", "distributeEnergy",
                                        "colorReconstruction", "renderPatchIDs",   "calcFF"};

// The beginnings of functions defined at file scope and seen from outside, in their order: "bool distributeEnergy(MyPolygon* maxP)".
std::vector<std::string> definitions(const std::string& file) {
    const std::string text = readFile(file);
    const std::regex beginning(R"((?:^|\n)((?!static)\w[\w*]* \w+\([^()\n]*\)) \{)");
    std::vector<std::string> found;
    for (std::sregex_iterator it(text.begin(), text.end(), beginning), end; it != end; ++it) found.push_back((*it)[1]);
    return found;
}

int count(const std::string& text, const std::string& word) {
    int found = 0;
    for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + word.size())) ++found;
    return found;
}

}  // namespace

TEST_CASE("the solution has all six functions, with the types that ProgRef.h promises") {
    using Shooter = MyPolygon* (*)();
    using Shot = bool (*)(MyPolygon*);
    using Drawing = void (*)();
    using ByHemicube = MyPolygon* (*)(Hemicube*);
    const Shooter shooters[] = {&maxenergy_patch, &calcAnalyticalFF};
    const Shot shot = &distributeEnergy;
    const Drawing drawings[] = {&colorReconstruction, &renderPatchIDs};
    const ByHemicube byHemicube = &calcFF;
    const std::set<void*> different = {reinterpret_cast<void*>(shooters[0]), reinterpret_cast<void*>(shooters[1]),
                                       reinterpret_cast<void*>(shot),        reinterpret_cast<void*>(drawings[0]),
                                       reinterpret_cast<void*>(drawings[1]), reinterpret_cast<void*>(byHemicube)};
    CHECK(different.size() == 6);
    CHECK(different.count(nullptr) == 0);
}

TEST_CASE("exercise and solutions offer the same six functions in the order of the stages, and no other") {
    const std::vector<std::string> offered = definitions(exercise);
    REQUIRE(offered.size() == names.size());
    for (std::size_t stage = 0; stage < names.size(); ++stage)
        CHECK(offered[stage].find(" " + names[stage] + "(") != std::string::npos);
    CHECK(definitions(solution) == offered);
    CHECK(definitions(olderStyle) == offered);
}

TEST_CASE("the exercise has the marker of every stage once, inside its function, and the solutions have none") {
    const std::string text = readFile(exercise);
    for (std::size_t stage = 0; stage < names.size(); ++stage) {
        const std::string marker = "// TODO stage " + std::to_string(stage + 1) + "\n";
        CAPTURE(marker);
        CHECK(count(text, marker) == 1);
        const std::size_t function = text.find(" " + names[stage] + "("), end = text.find("\n}\n", function);
        CHECK(text.find(marker) > function);
        CHECK(text.find(marker) < end);
        CHECK(text.find("throw NotImplemented(\"" + names[stage] + "\")", function) < end);
    }
    CHECK(count(text, "TODO") == 6);
    for (const std::string& solved : {solution, olderStyle})
        for (const std::string word : {"TODO", "throw NotImplemented"}) CHECK(count(readFile(solved), word) == 0);
}

TEST_CASE("exercise and solutions need ProgRef.h alone, found beside nothing else") {
    for (const std::string& file : {exercise, solution, olderStyle}) {
        CAPTURE(file);
        CHECK(count(readFile(file), "#include") == 1);
        CHECK(count(readFile(file), "#include \"ProgRef.h\"\n") == 1);
    }
}

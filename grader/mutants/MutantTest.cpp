#include "grader/mutants/Mutant.h"

#include <map>
#include <set>

#include <doctest/doctest.h>

#include "base/Error.h"
#include "base/TestFolder.h"
#include "base/WholeFile.h"

using namespace radlab;
using namespace radlab::grader;

TEST_CASE("there are at least 100 wrong programs and 20 right ones, each its own") {
    int wrong = 0, right = 0;
    std::set<std::string> ids, sources;
    for (const Mutant& mutant : projectMutants()) {
        ++(mutant.wrong ? wrong : right);
        CHECK_MESSAGE(ids.insert(mutant.stage + "/" + mutant.id).second, mutant.id);
        CHECK_MESSAGE(sources.insert(mutant.source).second, mutant.id);
    }
    CHECK(wrong >= 100);
    CHECK(right >= 20);
}

TEST_CASE("each extension has at least 12 wrong programs and 4 right ones, each its own") {
    std::map<std::string, int> wrong, right;
    std::set<std::string> ids, sources;
    for (const Mutant& mutant : extensionMutants()) {
        ++(mutant.wrong ? wrong : right)[mutant.stage];
        CHECK(mutant.file != "ProgRef.cpp");
        CHECK_MESSAGE(ids.insert(mutant.stage + "/" + mutant.id).second, mutant.id);
        CHECK_MESSAGE(sources.insert(mutant.source).second, mutant.id);
    }
    for (const char* stage : {"hemisphereFF", "antialias", "mirrorScene"}) {
        CHECK(wrong[stage] >= 12);
        CHECK(right[stage] >= 4);
    }
}

TEST_CASE("a change replaces a text or a function") {
    const test::Folder folder;
    writeFile(folder / "solution.cpp", "int one() {\n    return 1;\n}\n\nint two() {\n    return 2;\n}\n");
    writeFile(folder / "a.json",
              R"({"stage": "one", "wrong": [{"id": "x", "names": ["n"], "replace": [["return 1", "return 3"]]}],
        "right": [{"id": "y", "function": {"two": ["int two() {", "    return 1 + 1;", "}"]}}]})");
    const std::vector<Mutant> mutants = readMutants(folder / ".", folder / "solution.cpp");
    REQUIRE(mutants.size() == 2);
    CHECK(mutants[0].wrong);
    CHECK(mutants[0].names == std::vector<std::string>{"n"});
    CHECK(mutants[0].source == "int one() {\n    return 3;\n}\n\nint two() {\n    return 2;\n}\n");
    CHECK_FALSE(mutants[1].wrong);
    CHECK(mutants[1].source == "int one() {\n    return 1;\n}\n\nint two() {\n    return 1 + 1;\n}\n");
}

TEST_CASE("a change that does not fit the solution is an Error with the file and the mutant") {
    const test::Folder folder;
    writeFile(folder / "solution.cpp", "int one() {\n    return 1;\n}\n");
    const auto refused = [&](const std::string& change, const std::string& why) {
        writeFile(folder / "a.json",
                  R"({"stage": "one", "right": [], "wrong": [{"id": "x", "names": [], )" + change + "}]}");
        CHECK_THROWS_WITH_AS(readMutants(folder / ".", folder / "solution.cpp"), doctest::Contains(why.c_str()), Error);
    };
    refused(R"("replace": [["return 9", ""]])", "a.json: x: the solution has no such text: return 9");
    refused(R"("replace": [["n", "m"]])", "several times");
    refused(R"("replace": [["return 1", "return 1"]])", "changes nothing");
    refused(R"("function": {"three": []})", "defines no function three");
    refused(R"("replace": 7)", "a.json");
}

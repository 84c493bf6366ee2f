#include "grader/stages/Manifest.h"

#include <map>
#include <set>

#include <doctest/doctest.h>

#include "base/Error.h"
#include "base/TestFolder.h"
#include "base/WholeFile.h"
#include "grader/stages/Pictures.h"
#include "grader/stages/Stage.h"

using namespace radlab;
using namespace radlab::grader;

TEST_CASE("the manifest has the six stages in the exercise's order, with the course's marks") {
    const Manifest manifest = readManifest(manifestFile());
    const std::vector<std::pair<std::string, double>> expected = {
        {"maxenergy_patch", 10}, {"calcAnalyticalFF", 20}, {"distributeEnergy", 20}, {"colorReconstruction", 15},
        {"renderPatchIDs", 15},  {"calcFF", 20},           {"together", 0}};
    REQUIRE(manifest.stages.size() == expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
        CHECK(manifest.stages[i].stage == expected[i].first);
        CHECK(manifest.stages[i].marks == expected[i].second);
        CHECK(manifest.stages[i].number == static_cast<int>(i) + 1);
    }
    CHECK(manifest.seconds == 10.0);
}

TEST_CASE("the extensions stand beside the stages, each with a file of its own and numbered on") {
    const Manifest manifest = readManifest(manifestFile());
    int number = static_cast<int>(manifest.stages.size());
    REQUIRE(manifest.extensions.size() == extensionStages().size());
    for (const ManifestStage& extension : manifest.extensions) {
        CHECK(extension.number == ++number);
        CHECK(extension.isExtension());
        CHECK(readFile(RADLAB_SOURCE_DIR "/exercises/extensions/" + extension.file).find(extension.stage) !=
              std::string::npos);
        const Manifest alone = manifest.of(extension);
        CHECK(alone.files == std::vector<std::string>{extension.file});
        REQUIRE(alone.stages.size() == 1);
        CHECK(alone.stages[0].stage == extension.stage);
    }
    for (const ManifestStage& stage : manifest.stages) CHECK_FALSE(stage.isExtension());
}

TEST_CASE("every check of the manifest has its cases, and every case its check") {
    const Manifest manifest = readManifest(manifestFile());
    std::map<std::string, std::set<std::string>> written, performed;
    for (const std::vector<ManifestStage>* stages : {&manifest.stages, &manifest.extensions})
        for (const ManifestStage& stage : *stages)
            for (const ManifestCheck& check : stage.checks) {
                CHECK_FALSE(check.name.empty());
                CHECK_FALSE(check.hint.empty());
                CHECK((check.tolerance > 0.0) == !check.references.empty());
                (check.references.empty() ? written[stage.stage] : written["pictures"]).insert(check.id);
            }
    for (const auto& stages : {allStages, extensionStages})
        for (const std::unique_ptr<Stage>& stage : stages())
            for (const Check& check : stage->checks(1)) performed[stage->function()].insert(check.id);
    for (const PictureCase& picture : pictureCases()) performed["pictures"].insert(picture.check);
    CHECK(written == performed);
}

TEST_CASE("a stage is found by number, by name and by the beginning of its name") {
    const Manifest manifest = readManifest(manifestFile());
    CHECK(manifest.find("3").stage == "distributeEnergy");
    CHECK(manifest.find("calcFF").stage == "calcFF");
    CHECK(manifest.find("color").stage == "colorReconstruction");
    CHECK_THROWS_WITH_AS(manifest.find("calc"), doctest::Contains("several"), Error);
    CHECK(manifest.find("hemisphere").isExtension());
    CHECK_THROWS_WITH_AS(manifest.find("12"),
                         doctest::Contains("expected one of 1 maxenergy_patch, 2 calcAnalyticalFF"), Error);
    CHECK_THROWS_AS(manifest.find(""), Error);
}

TEST_CASE("a manifest that is wrong is refused with its name") {
    const test::Folder folder;
    const auto refused = [&](const std::string& text, const std::string& why) {
        writeFile(folder / "manifest.json", text);
        CHECK_THROWS_WITH_AS(readManifest(folder / "manifest.json"), doctest::Contains(why.c_str()), Error);
    };
    refused("{", "manifest.json");
    refused("{\"stages\": []}", "files");
    refused(R"({"files": ["a.cpp"], "stages": []})", "limits");
    refused(R"({"files": []})", "files: found none");
    for (const char* name : {"", ".", "..", "a/b.h", "/etc/passwd"})
        refused(R"({"files": ["a.cpp", ")" + std::string(name) + "\"]}", "files: found '" + std::string(name) + "'");
    refused(R"({"files": ["a.cpp"], "limits": {"seconds": 1, "mebibytes": 1, "compile_seconds": 1}, "stages":
        [{"stage": "calcFF", "title": "", "marks": 5, "checks": [{"id": "a", "name": "b", "marks": 4}]}]})",
            "calcFF: marks of its checks add up to 4");
}

#include "study/StudyResults.h"

#include <doctest/doctest.h>

#include "base/Error.h"
#include "base/TestFolder.h"
#include "base/WholeFile.h"

using namespace radlab;
using namespace radlab::study;
using doctest::Contains;

namespace {

Measurement measured(const std::string& method, const std::string& setting, double seconds) {
    Measurement row;
    row.version = RADLAB_VERSION;
    row.plan = "quick";
    row.scene = "box";
    row.contents = "0123";
    row.wanted = 300;
    row.patches = 308;
    row.method = method;
    row.setting = setting;
    row.repeats = 3;
    row.seconds = seconds;
    row.solverError = 0.0125;
    return row;
}

}  // namespace

TEST_CASE("fields with commas, quotes and line breaks are put in quotes, and come back as they were") {
    CHECK(csvField("plain") == "plain");
    CHECK(csvField("1,024 rays") == "\"1,024 rays\"");
    CHECK(csvField("the \"best\"") == "\"the \"\"best\"\"\"");
    const std::string odd = "a,\"b\"\nc";
    CHECK(csvLines(csvField(odd) + ",2\r\n") == std::vector<std::vector<std::string>>{{odd, "2"}});
    CHECK(csvLines(",\n\n") == std::vector<std::vector<std::string>>{{"", ""}, {""}});
}

TEST_CASE("a study goes on from its file: rows come back as they were added") {
    const test::Folder folder;
    {
        StudyResults results(folder / "results.csv", false);
        CHECK(results.rows().empty());
        results.add(measured("hemisphere", "1,024 rays", 0.5));
        results.add(measured("exact", "", 0.25));
    }
    const StudyResults again(folder / "results.csv", false);
    REQUIRE(again.rows().size() == 2);
    const Measurement* row = again.find(measured("hemisphere", "1,024 rays", 0));
    REQUIRE(row);
    CHECK(row->seconds == 0.5);
    CHECK(row->patches == 308);
    CHECK(row->solverError == 0.0125);
    CHECK(!row->wholeError);
    CHECK(!again.find(measured("hemisphere", "16 rays", 0)));
    CHECK(StudyResults(folder / "results.csv", true).rows().empty());
}

TEST_CASE("a row takes the place of an older one of the same setting, also of another content of the scene") {
    const test::Folder folder;
    StudyResults results(folder / "results.csv", false);
    results.add(measured("exact", "", 0.25));
    Measurement changed = measured("exact", "", 0.5);
    changed.contents = "4567";
    CHECK(!results.find(changed));
    results.add(changed);
    REQUIRE(results.rows().size() == 1);
    CHECK(results.find(changed)->seconds == 0.5);
}

TEST_CASE("a last line that was cut off is dropped, and rows of another version are measured anew") {
    const test::Folder folder;
    Measurement old = measured("exact", "", 0.25);
    old.version = "0.0.1";
    const std::string text = csvOf({old, measured("point", "", 1), measured("polygon", "", 2)});
    writeFile(folder / "results.csv", text.substr(0, text.size() - 5));
    const StudyResults results(folder / "results.csv", false);
    REQUIRE(results.rows().size() == 1);
    CHECK(results.rows()[0].method == "point");
}

TEST_CASE("a file that is no study's is refused with its line, and left as it is") {
    const test::Folder folder;
    const auto file = folder / "results.csv";
    writeFile(file, "name,mark\nAnna,1\n");
    CHECK_THROWS_WITH_AS(StudyResults(file, false), Contains("results.csv:1: these are not the columns"), Error);
    const std::string header = csvOf({});
    writeFile(file, header + "1,2\n");
    CHECK_THROWS_WITH_AS(StudyResults(file, false), Contains("results.csv:2: found 2 fields"), Error);
    std::string text = csvOf({measured("point", "", 1)});
    text.replace(text.find(",308,"), 5, ",many,");
    writeFile(file, text);
    CHECK_THROWS_WITH_AS(StudyResults(file, false), Contains("results.csv:2: patches: found 'many'"), Error);
    CHECK(readFile(file) == text);
}

#include "grader/intake/Unpack.h"

#include <sys/stat.h>

#include <nlohmann/json.hpp>

#include "grader/intake/Archive.h"
#include "grader/intake/IntakeTestHelp.h"
#include "grader/intake/UnpackMessage.h"
#include "grader/sandbox/Process.h"

using namespace radlab;
using namespace radlab::grader;

namespace {

using Json = nlohmann::json;

// A program in place of `unpack`, as a shell script.
struct Stand {
    test::Folder folder;
    IntakeRules rules = test::rules();

    explicit Stand(const std::string& script) {
        rules.unpack = folder / "unpack.sh";
        rules.sandbox.emplace();  // there is no shell in the box
        test::put(rules.unpack, "#!/bin/sh\ncat > /dev/null\n" + script + "\n");
        REQUIRE(chmod(rules.unpack.c_str(), 0755) == 0);
    }
    std::string said() const {
        const Gathered gathered = unpackArchive("bytes", rules);
        CHECK(gathered.files.empty());
        CHECK(gathered.remarks.refusedAny());
        return gathered.remarks.told().at(0).text;
    }
};

Json sound() {
    const auto binary = [](const std::string& text) { return Json::binary({text.begin(), text.end()}); };
    return {{"files", {{{"name", "ProgRef.cpp"}, {"path", binary("ProgRef.cpp")}, {"contents", binary("int x;")}}}},
            {"others", {binary("main.cpp")}},
            {"moreOthers", true},
            {"remarks", {{{"text", binary("a\x1b\nb")}, {"refuses", true}}}},
            {"untold", 3}};
}

Gathered from(const Json& json) {
    std::string bytes;
    Json::to_cbor(json, bytes);
    return gatheredFromCbor(bytes, test::rules());
}

}  // namespace

TEST_CASE("the program finds what the function finds") {
    const std::string bytes = test::pack({{"a/ProgRef.cpp"}, {"../b"}, {"c"}});
    const Gathered here = readArchive(bytes, test::rules()), there = unpackArchive(bytes, test::rules());
    REQUIRE(there.files.count("ProgRef.cpp") == 1);
    CHECK(there.files.at("ProgRef.cpp").contents == here.files.at("ProgRef.cpp").contents);
    CHECK(there.files.at("ProgRef.cpp").path == "a/ProgRef.cpp");
    CHECK(there.others == here.others);
    REQUIRE(there.remarks.told().size() == 1);
    CHECK(there.remarks.told()[0].text == here.remarks.told()[0].text);
}

TEST_CASE("the rules reach the program") {
    IntakeRules small = test::rules();
    small.mostBytes = 3;
    small.files = {"ProgRef.cpp", "a \"b\".h"};
    const IntakeRules back = rulesFromText(rulesToText(small));
    CHECK(back.files == small.files);
    CHECK(unpackArchive(test::pack({{"ProgRef.cpp"}}), small).remarks.told()[0].text.find("at most 3") !=
          std::string::npos);
    CHECK_THROWS_AS(rulesFromText("{}"), Error);
    CHECK_THROWS_AS(rulesFromText("nonsense"), Error);
}

TEST_CASE("a program that crashes, fails or answers nonsense costs the archive, not the run") {
    CHECK(Stand("kill -SEGV $$").said().find("cannot be read") != std::string::npos);
    CHECK(Stand("exit 3").said().find("cannot be read") != std::string::npos);
    CHECK(Stand("exit 0").said().find("wrong answer") != std::string::npos);
    CHECK(Stand("echo nonsense >&3").said().find("wrong answer") != std::string::npos);
    CHECK(Stand("head -c 1000000 /dev/zero | tr '\\0' '\\201' >&3").said().find("nested deeper") != std::string::npos);
    CHECK(Stand("head -c 100000000 /dev/zero >&3").said().find("wrong answer") != std::string::npos);
}

TEST_CASE("a program that is not there, or is killed from outside, is the machine's fault") {
    IntakeRules none = test::rules();
    none.unpack = "/nowhere/unpack";
    CHECK_THROWS_AS(unpackArchive("", none), MachineError);
    const Stand killed("kill -KILL $$");
    CHECK_THROWS_AS(unpackArchive("", killed.rules), MachineError);
}

TEST_CASE("an answer is taken as far as the rules allow, and its text made fit to be seen") {
    const Gathered gathered = from(sound());
    CHECK(gathered.files.at("ProgRef.cpp").contents == "int x;");
    CHECK(gathered.others == std::vector<std::string>{"main.cpp"});
    CHECK(gathered.moreOthers);
    CHECK(gathered.remarks.refusedAny());
    CHECK(gathered.remarks.lines() == std::vector<std::string>{"a\\x1b\\x0ab", "and 3 more such remarks"});
}

TEST_CASE("an answer with other files, too much of anything or other kinds is refused") {
    const auto refusedWith = [](const char* place, const Json& value) {
        CAPTURE(place);
        Json json = sound();
        json[Json::json_pointer(place)] = value;
        CHECK_THROWS_AS(from(json), Error);
    };
    refusedWith("/files/0/name", "main.cpp");
    refusedWith("/files/0/name", 7);
    refusedWith("/files/0/contents", "text");
    refusedWith("/files/0/contents", Json::binary(std::vector<std::uint8_t>((1 << 20) + 1)));
    refusedWith("/files/0/path", Json::binary(std::vector<std::uint8_t>(2001)));
    refusedWith("/files", 7);
    refusedWith("/files", Json::object());
    refusedWith("/files/1", sound()["files"][0]);
    refusedWith("/others", std::vector<Json>(21, sound()["others"][0]));
    refusedWith("/remarks", std::vector<Json>(21, sound()["remarks"][0]));
    refusedWith("/remarks/0/text", Json::binary(std::vector<std::uint8_t>(2001)));
    refusedWith("/moreOthers", "yes");
    for (const char* name : {"files", "others", "moreOthers", "remarks", "untold"}) {
        Json json = sound();
        json.erase(name);
        CHECK_THROWS_AS(from(json), Error);
    }
}

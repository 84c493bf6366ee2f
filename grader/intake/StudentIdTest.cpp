#include "grader/intake/StudentId.h"

#include <algorithm>
#include <set>

#include <doctest/doctest.h>

#include "grader/intake/Hash.h"

using namespace radlab::grader;

namespace {

std::vector<std::string> idsOf(const std::vector<std::string>& names) {
    std::vector<IdSource> sources;
    for (const std::string& name : names) sources.push_back({name, name});
    return studentIds(sources);
}

bool isSafe(const std::string& id) {
    const std::string allowed = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789._-";
    return !id.empty() && id.size() <= 80 && std::isalnum(static_cast<unsigned char>(id[0])) &&
           id.find_first_not_of(allowed) == std::string::npos;
}

std::string lowered(std::string text) {
    for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return text;
}

}  // namespace

TEST_CASE("what is safe stays as it is, the rest becomes so") {
    CHECK(idsOf({"student-07", "Doe_123"}) == std::vector<std::string>{"student-07", "Doe_123"});
    CHECK(idsOf({"Student Seven_123"})[0] == "Student-Seven_123");
    CHECK(idsOf({"../../etc/passwd"})[0] == "etc-passwd");
    CHECK(idsOf({".hidden"})[0] == "hidden");
    CHECK(idsOf({"<script>alert(1)</script>"})[0] == "script-alert-1-script");
    CHECK(idsOf({"=cmd|' /C calc'!A0"})[0] == "cmd-C-calc-A0");
}

TEST_CASE("ids are safe and different, whatever the names are") {
    std::vector<std::string> names = {"",
                                      ".",
                                      "..",
                                      "-",
                                      "\xff\xfe",
                                      "\xe4\xb8\x83",
                                      "a\nb",
                                      "a b",
                                      "a\tb",
                                      "a-b",
                                      "A-B",
                                      "index",
                                      "INDEX",
                                      "con",
                                      "student",
                                      std::string(500, 'x'),
                                      std::string(501, 'x'),
                                      "\x1b[31mred",
                                      "\xe2\x80\xaegpj"};
    const std::vector<std::string> ids = idsOf(names);
    std::set<std::string> seen;
    for (const std::string& id : ids) {
        CAPTURE(id);
        CHECK(isSafe(id));
        CHECK(seen.insert(lowered(id)).second);
    }
    CHECK(seen.count("index") == 0);
}

TEST_CASE("two that are alike both get a hash of their names, and the order changes nothing") {
    const std::vector<std::string> ids = idsOf({"Sam", "sam", "kim"});
    CHECK(ids[0] == "Sam-" + sha256("Sam").substr(0, 8));
    CHECK(ids[1] == "sam-" + sha256("sam").substr(0, 8));
    CHECK(ids[2] == "kim");
    const std::vector<std::string> turned = idsOf({"kim", "sam", "Sam"});
    CHECK(std::vector<std::string>(turned.rbegin(), turned.rend()) == ids);
}

TEST_CASE("a name that is made to look like another's id with its hash takes nothing from it") {
    const std::string forged = "sam-" + sha256("sam").substr(0, 8);
    const std::vector<std::string> ids = idsOf({"Sam", "sam", forged});
    std::set<std::string> seen;
    for (const std::string& id : ids) CHECK(seen.insert(lowered(id)).second);
}

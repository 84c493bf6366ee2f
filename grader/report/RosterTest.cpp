#include "grader/report/Roster.h"

#include <doctest/doctest.h>

#include "grader/report/SampleClass.h"

using namespace radlab::grader;

namespace {

using Rows = std::vector<std::optional<std::size_t>>;
constexpr std::nullopt_t nobody = std::nullopt;

StudentResult person(const std::string& account, const std::string& name) {
    StudentResult student = test::without("student", Outcome::nothing);
    student.student.account = account;
    student.student.name = name;
    return student;
}

}  // namespace

TEST_CASE("roster: accounts are found in any order, capital letters and spaces aside") {
    const RosterKeys keys{{{"11", " Ab@x.edu ", "13"}}, {}};
    const RosterMatch match = matchRoster({person("13", ""), person("aB@X.edu", ""), person("99", "")}, keys);
    CHECK(match.row == Rows{2, 1, nobody});
    CHECK(match.byName == std::vector<bool>{false, false, false});
}

TEST_CASE("roster: one column alone decides on accounts, that in which most of them stand") {
    const RosterKeys keys{{{"11", "12", "13"}, {"12", "13", "14"}}, {}};
    // The 14 of the second column is another person's number there.
    CHECK(matchRoster({person("11", ""), person("12", ""), person("14", "")}, keys).row == Rows{0, 1, nobody});
    CHECK(matchRoster({person("14", ""), person("12", ""), person("13", "")}, keys).row == Rows{2, 0, 1});
}

TEST_CASE("roster: whom accounts leave is found by a name that only one row has") {
    const RosterKeys keys{{{"11", "12", "13", "14"}},
                          {{"Alpha, Student", "Beta, Student", "Twin, Student", "Twin, Student"},
                           {"StudentAlpha", "StudentBeta", "StudentTwin", "StudentTwin"}}};
    const RosterMatch match = matchRoster(
        {person("11", "somebody"), person("x", "betastudent"), person("y", "Student Twin"), person("z", "")}, keys);
    CHECK(match.row == Rows{0, 1, nobody, nobody});
    CHECK(match.byName == std::vector<bool>{false, true, false, false});
}

TEST_CASE("roster: a name never takes the row that another account has") {
    const RosterKeys keys{{{"11", "12"}}, {{"Student Alpha", "Student Beta"}}};
    CHECK(matchRoster({person("11", "x"), person("99", "Student Alpha")}, keys).row == Rows{0, nobody});
}

TEST_CASE("roster: what fits twice is not matched") {
    CHECK(matchRoster({person("11", "")}, {{{"11", "11"}}, {}}).row == Rows{nobody});
    CHECK(matchRoster({person("11", ""), person("11", "")}, {{{"11", "12"}}, {}}).row == Rows{nobody, nobody});
    const RosterKeys named{{}, {{"Student Alpha"}}};
    CHECK(matchRoster({person("", "student alpha"), person("", "StudentAlpha")}, named).row == Rows{nobody, nobody});
    CHECK(matchRoster({person("11", ""), person("11", "Student Alpha")}, {{{"11"}}, {{"Student Alpha"}}}).row ==
          Rows{nobody, nobody});
}

TEST_CASE("roster: without rows or without students nobody is matched") {
    CHECK(matchRoster({person("", "")}, {{{""}}, {{""}}}).row == Rows{nobody});
    CHECK(matchRoster({person("11", "x")}, {{{}}, {}}).row == Rows{nobody});
    CHECK(matchRoster({}, {{{"11"}}, {}}).row.empty());
}

#include "base/Error.h"

#include <limits>

#include <doctest/doctest.h>

using namespace radlab;

namespace {

template <class Body>
std::string brokenPromise(const Body& body) {
    try {
        body();
    } catch (const std::logic_error& fault) {
        return fault.what();
    }
    return "";
}

}  // namespace

TEST_CASE("an error begins with its file and line, as far as they are known") {
    CHECK(std::string(Error({"room.x3d", 12}, "no faces").what()) == "room.x3d:12: no faces");
    CHECK(std::string(Error({"room.x3d"}, "no faces").what()) == "room.x3d: no faces");
    CHECK(std::string(Error({}, "no faces").what()) == "no faces");
    CHECK(std::string(Error("no faces").what()) == "no faces");
}

TEST_CASE("an error knows its place") {
    const Error error({"room.x3d", 12}, "no faces");
    CHECK(error.where().file == "room.x3d");
    CHECK(error.where().line == 12);
    CHECK(Error("no faces").where().file.empty());
    CHECK(Error("no faces").where().line == 0);
}

TEST_CASE("a stub that is not written yet names its function") {
    const NotImplemented stub("calcFF");
    CHECK(stub.function() == "calcFF");
    CHECK(std::string(stub.what()) == "calcFF is not written yet");
}

TEST_CASE("a broken promise shows the expression and both values") {
    const int found = 7, most = 5;
    const std::string text = brokenPromise([&] { RADLAB_CHECK(found <= most); });
    CHECK(text.find("ErrorTest.cpp:") != std::string::npos);
    CHECK(text.find("broken promise: found <= most (7 <= 5)") != std::string::npos);
}

TEST_CASE("every comparison can be promised, and shows its own sign") {
    const double one = 1.0, two = 2.5;
    CHECK(brokenPromise([&] { RADLAB_CHECK(two < one); }).find("(2.5 < 1)") != std::string::npos);
    CHECK(brokenPromise([&] { RADLAB_CHECK(one > two); }).find("(1 > 2.5)") != std::string::npos);
    CHECK(brokenPromise([&] { RADLAB_CHECK(one >= two); }).find("(1 >= 2.5)") != std::string::npos);
    CHECK(brokenPromise([&] { RADLAB_CHECK(one == two); }).find("(1 == 2.5)") != std::string::npos);
    CHECK(brokenPromise([&] { RADLAB_CHECK(one != one); }).find("(1 != 1)") != std::string::npos);
    CHECK(brokenPromise([&] { RADLAB_CHECK(one == two - one); }).find("(1 == 1.5)") != std::string::npos);
    CHECK(brokenPromise([] { RADLAB_CHECK(std::string().size() > 0u); }).find("(0 > 0)") != std::string::npos);
}

TEST_CASE("a promise without a comparison shows false") {
    const bool whole = false;
    CHECK(brokenPromise([&] { RADLAB_CHECK(whole); }).find("broken promise: whole (false)") != std::string::npos);
}

TEST_CASE("a promise about a number that is not one is broken") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK_FALSE(brokenPromise([&] { RADLAB_CHECK(nan < 1.0); }).empty());
    CHECK_FALSE(brokenPromise([&] { RADLAB_CHECK(nan >= 1.0); }).empty());
}

TEST_CASE("a promise that is kept is silent and looks once only") {
    int looks = 0;
    CHECK(brokenPromise([&] { RADLAB_CHECK(++looks < 5); }).empty());
    CHECK(brokenPromise([&] { RADLAB_CHECK(++looks); }).empty());
    CHECK(looks == 2);
}

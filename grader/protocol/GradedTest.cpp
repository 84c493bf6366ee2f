#include "grader/protocol/Graded.h"

#include <doctest/doctest.h>

#include "base/Error.h"

using namespace radlab;
using namespace radlab::grader;

namespace {

Graded sampleVerdict() {
    Graded graded;
    graded.result.submission = "ProgRef.cpp";
    graded.result.score = 7.5;
    graded.result.compiler = "ProgRef.cpp:3: warning: \xff\n";
    graded.result.compiled = false;
    graded.pictures = {{"calcFF", "hemi.picture", "a <b>", 0.25, 0.01, {{"yours", std::string("\0\x89PNG", 5), 4, 3}}}};
    return graded;
}

}  // namespace

TEST_CASE("what grading gave comes back whole, bytes of pictures included") {
    const Graded back = gradedFromCbor(toCbor(sampleVerdict()));
    CHECK(back.result.score == 7.5);
    CHECK(back.result.compiler == "ProgRef.cpp:3: warning: \xef\xbf\xbd\n");
    CHECK_FALSE(back.result.compiled);
    REQUIRE(back.pictures.size() == 1);
    CHECK(back.pictures[0].check == "hemi.picture");
    CHECK(back.pictures[0].rms == 0.25);
    CHECK(back.pictures[0].images.at(0).png == std::string("\0\x89PNG", 5));
    CHECK(back.pictures[0].images[0].width == 4);
}

TEST_CASE("bytes that are cut off or something else are an error") {
    const std::string bytes = toCbor(sampleVerdict());
    for (const std::size_t length : {std::size_t{0}, bytes.size() / 2, bytes.size() - 1})
        CHECK_THROWS_AS(gradedFromCbor(std::string_view(bytes).substr(0, length)), Error);
    CHECK_THROWS_AS(gradedFromCbor("\xa0"), Error);
    CHECK_THROWS_AS(gradedFromCbor(std::string(1'000'000, '\x81')), Error);
}

#include "grader/intake/Hash.h"

#include <doctest/doctest.h>

using namespace radlab::grader;

TEST_CASE("SHA-256 is the standard's: FIPS 180-2, appendix B") {
    CHECK(sha256("abc") == "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    CHECK(sha256("") == "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
}

TEST_CASE("the hash of files is that of their number, lengths, names and contents") {
    using namespace std::string_literals;
    CHECK(hashOf({}) == sha256("\0\0\0\0\0\0\0\0"s));
    CHECK(hashOf({{"ab", "c"}}) == sha256("\1\0\0\0\0\0\0\0\2\0\0\0\0\0\0\0ab\1\0\0\0\0\0\0\0c"s));
    CHECK(hashOf({{"ab", "c"}}) != hashOf({{"a", "bc"}}));
    CHECK(hashOf({{"a", ""}, {"b", ""}}) != hashOf({{"a", "b"}}));
}

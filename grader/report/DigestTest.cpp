#include "grader/report/Digest.h"

#include <doctest/doctest.h>

#if __has_include(<sodium.h>)

using namespace radlab::grader;

TEST_CASE("digest: base64 is that of RFC 4648") {
    CHECK(base64("") == "");
    CHECK(base64("f") == "Zg==");
    CHECK(base64("fo") == "Zm8=");
    CHECK(base64("foobar") == "Zm9vYmFy");
    CHECK(base64(std::string("\xfb\xff\xfe\0", 4)) == "+//+AA==");
}

TEST_CASE("digest: SHA-256 is that of FIPS 180") {
    CHECK(sha256Base64("abc") == "ungWv48Bz+pBQUDeXa4iI7ADYaOWF3qctBD/YfIAFa0=");
    CHECK(sha256Base64("") == "47DEQpj8HBSa+/TImW+5JCeuQeRkm5NMpJWZG3hSuFU=");
}

#endif

#include "base/Memory.h"

#include <doctest/doctest.h>

#include "base/Error.h"

using namespace radlab;

TEST_CASE("sizes read as people say them") {
    CHECK(bytesText(0) == "0 bytes");
    CHECK(bytesText(1023) == "1023 bytes");
    CHECK(bytesText(1536) == "1.5 KiB");
    CHECK(bytesText(233.28e6) == "222 MiB");
    CHECK(bytesText(8e12) == "7.3 TiB");
    CHECK(bytesText(8e18) == "7275958 TiB");
}

TEST_CASE("what does not fit is refused with both figures, what fits is not") {
    requireMemory(1024, "a few numbers", "");
    try {
        requireMemory(8e18, "the form factors of 1,000,000,000 patches", "take larger patches");
        FAIL("nothing was refused");
    } catch (const Error& error) {
        const std::string text = error.what();
        CHECK(text.find("1,000,000,000 patches need 7275958 TiB of memory") != std::string::npos);
        CHECK(text.find("left: take larger patches") != std::string::npos);
    }
}

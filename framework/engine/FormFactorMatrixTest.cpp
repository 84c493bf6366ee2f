#include "engine/FormFactorMatrix.h"

#include <doctest/doctest.h>

#include "base/Error.h"

using namespace radlab;
using namespace radlab::engine;

TEST_CASE("entries are found beyond what 32 bits count") {
    static_assert(FormFactorMatrix::indexOf(46'340, 46'340, 46'341) == 2'147'488'280);
    static_assert(FormFactorMatrix::indexOf(65'536, 0, 65'537) == 4'295'032'832);
    static_assert(FormFactorMatrix::indexOf(999'999, 999'999, 1'000'000) == 999'999'999'999);
    CHECK(matrixBytes(65'537) == 8.0 * 4'295'098'369.0);
}

TEST_CASE(
    "the matrix of a million patches is refused with its size, and a way that needs none, before memory is taken") {
    const std::vector<Polygon> patches(1'000'000);
    try {
        const FormFactorMatrix matrix(patches);
        FAIL("not refused: this machine has more than 7 TiB of memory");
    } catch (const Error& error) {
        const std::string text = error.what();
        CAPTURE(text);
        CHECK(text.find("the form factors of 1000000 patches need 7.3 TiB of memory") != std::string::npos);
        CHECK(text.find("--method links") != std::string::npos);
    }
}

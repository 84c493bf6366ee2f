#include "engine/MatrixFile.h"

#include <cstring>

#include <doctest/doctest.h>

#include "base/Error.h"
#include "base/TestFolder.h"
#include "base/WholeFile.h"
#include "engine/ClosedFormRoom.h"

using namespace radlab;
using namespace radlab::engine;
using namespace radlab::test;

namespace {

FormFactorMatrix small() {
    FormFactorMatrix matrix({onFloor(0, 0, 1, 1), onFloor(1, 0, 1, 1)});
    matrix.at(0, 1) = 1.0 / 3.0;
    matrix.at(1, 0) = 1e-300;
    return matrix;
}

}  // namespace

TEST_CASE("a matrix reads as comments and rows of 17 digits") {
    const Folder folder;
    writeMatrix(folder / "F.csv", small(), "a scene\n2 patches");
    CHECK(readFile(folder / "F.csv") == "# a scene\n# 2 patches\n0,0.33333333333333331\n1e-300,0\n");
}

TEST_CASE("a matrix in NumPy's format has its header on a boundary of 64 bytes, then the doubles") {
    const Folder folder;
    writeMatrix(folder / "F.npy", small(), "");
    const std::string bytes = readFile(folder / "F.npy");
    CHECK(bytes.substr(0, 8) == std::string("\x93NUMPY\x01\x00", 8));
    const std::size_t header = static_cast<unsigned char>(bytes[8]) + 256u * static_cast<unsigned char>(bytes[9]);
    CHECK((10 + header) % 64 == 0);
    CHECK(bytes.substr(10, header).find("'shape': (2, 2)") != std::string::npos);
    REQUIRE(bytes.size() == 10 + header + 4 * sizeof(double));
    double second = 0.0;
    std::memcpy(&second, bytes.data() + 10 + header + sizeof(double), sizeof second);
    CHECK(second == 1.0 / 3.0);
}

TEST_CASE("another ending is refused, and nothing is written") {
    const Folder folder;
    CHECK_THROWS_WITH_AS(writeMatrix(folder / "F.txt", small(), ""), doctest::Contains("'.txt', expected .csv or .npy"),
                         Error);
    CHECK(folder.entries() == 0);
}

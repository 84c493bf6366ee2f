#include "grader/protocol/Cbor.h"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include "base/Error.h"

using namespace radlab;
using namespace radlab::grader;
using Json = nlohmann::json;

namespace {

std::string written(const Json& json) {
    std::string bytes;
    Json::to_cbor(json, bytes);
    return bytes;
}

}  // namespace

TEST_CASE("what the library writes is read, numbers and lengths of all sizes included") {
    const Json json = {{"numbers", {0, -1, 23, 24, 255, 256, 65535, 65536, -70000, 1ull << 40, 0.5, 0.1, -1e300}},
                       {"words", {"", "a", std::string(24, 'b'), std::string(300, 'c'), std::string(70000, 'd')}},
                       {"bytes", Json::binary({0x7f, 0x9f, 0xff})},
                       {"others", {true, false, nullptr, Json::array(), Json::object()}}};
    CHECK(cborWithin(written(json), 3) == json);
    CHECK(cborWithin(written(Json(std::vector<int>(70000, 1))), 1).size() == 70000);
    CHECK(cborWithin(written(7), 0) == 7);
}

TEST_CASE("levels are counted, and one too many is an error") {
    const Json three = {{"a", {{"b", Json::array({1})}}}};
    CHECK(cborWithin(written(three), 3) == three);
    CHECK_THROWS_AS(cborWithin(written(three), 2), Error);
    CHECK_THROWS_AS(cborWithin(written(Json::array()), 0), Error);
}

TEST_CASE("five million levels of any kind are an error and no overflow") {
    // Arrays, objects; bytes and texts whose pieces are such texts again; arrays without an end; tags.
    for (const char level : {'\x81', '\xa1', '\x5f', '\x7f', '\x9f', '\xbf', '\xc1'})
        CHECK_THROWS_AS(cborWithin(std::string(5'000'000, level), 8), Error);
}

TEST_CASE("bytes that are cut off, changed or left over are an error or something else, never a crash") {
    const std::string whole =
        written({{"a", {1, 2, {{"b", "text"}}}}, {"c", Json::binary({1, 2, 3})}, {"d", 70000}, {"e", 0.5}});
    for (std::size_t length = 0; length < whole.size(); ++length)
        CHECK_THROWS_AS(cborWithin(whole.substr(0, length), 8), Error);
    CHECK_THROWS_AS(cborWithin(whole + '\0', 8), Error);
    for (std::size_t i = 0; i < whole.size(); ++i)
        for (int byte = 0; byte < 256; ++byte) {
            std::string changed = whole;
            changed[i] = static_cast<char>(byte);
            try {
                cborWithin(changed, 8);
            } catch (const Error&) {
            }
        }
}

TEST_CASE("many items are an error before they fill the memory, many bytes are not") {
    CHECK(cborWithin(written(Json(std::vector<int>(999'999, 1))), 1).size() == 999'999);
    CHECK_THROWS_AS(cborWithin(written(Json(std::vector<int>(1'000'000, 1))), 1), Error);
    const std::vector<std::uint8_t> bytes(5'000'000);
    CHECK(cborWithin(written(Json::binary(bytes)), 0).get_binary().size() == bytes.size());
}

TEST_CASE("a length that no memory could hold is an error") {
    CHECK_THROWS_AS(cborWithin(std::string("\x9b\xff\xff\xff\xff\xff\xff\xff\xff", 9), 8), Error);
    CHECK_THROWS_AS(cborWithin(std::string("\xbb\x80\x00\x00\x00\x00\x00\x00\x00", 9), 8), Error);
    CHECK_THROWS_AS(cborWithin(std::string("\x5b\xff\xff\xff\xff\xff\xff\xff\xff", 9), 8), Error);
}

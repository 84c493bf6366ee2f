#include "grader/protocol/Cbor.h"

#include <cstdint>
#include <vector>

#include <nlohmann/json.hpp>

#include "base/Error.h"

namespace radlab::grader {

namespace {

enum Major { bytesOfLength = 2, textOfLength = 3, array = 4, object = 5, tag = 6 };

constexpr std::size_t mostItems = 1'000'000;  // what is long travels as one item of bytes

// Walks over the items of bytes without a call for each level.
class Scan {
public:
    Scan(std::string_view toRead, std::size_t mostDepth) : bytes(toRead), depth(mostDepth) {}

    void run() {
        item();
        while (!open.empty()) {
            if (open.back() == 0) {
                open.pop_back();
            } else {
                --open.back();
                item();
            }
        }
    }

private:
    void item() {
        if (++items > mostItems) throw Error("CBOR: more than " + std::to_string(mostItems) + " items");
        const auto head = static_cast<std::uint8_t>(bytesOf(1)[0]);
        const int major = head >> 5, information = head & 31;
        if (major == tag || information > 27) throw Error("CBOR: a tag, or something of unknown length");
        const std::uint64_t value =
            information < 24 ? static_cast<std::uint64_t>(information) : number(std::size_t{1} << (information - 24));
        if (major == bytesOfLength || major == textOfLength) bytesOf(value);
        if (major == array) enter(value);
        if (major == object) enter(value, 2);
    }

    std::string_view bytesOf(std::uint64_t count) {
        if (count > bytes.size()) throw Error("CBOR: cut off");
        const std::string_view taken = bytes.substr(0, count);
        bytes.remove_prefix(count);
        return taken;
    }

    std::uint64_t number(std::size_t size) {
        std::uint64_t value = 0;
        for (const char byte : bytesOf(size)) value = value << 8 | static_cast<std::uint8_t>(byte);
        return value;
    }

    void enter(std::uint64_t count, std::uint64_t each = 1) {
        if (open.size() >= depth) throw Error("CBOR: nested deeper than " + std::to_string(depth) + " levels");
        if (count > bytes.size()) throw Error("CBOR: cut off");  // so that the product below does not overflow
        open.push_back(count * each);
    }

    std::string_view bytes;
    std::size_t depth;
    std::size_t items = 0;
    std::vector<std::uint64_t> open;  // items that are still to come, for each level
};

}  // namespace

nlohmann::json cborWithin(std::string_view bytes, std::size_t depth) {
    Scan(bytes, depth).run();
    try {
        return nlohmann::json::from_cbor(bytes);
    } catch (const nlohmann::json::exception& error) {
        throw Error(std::string("CBOR: ") + error.what());
    }
}

}  // namespace radlab::grader

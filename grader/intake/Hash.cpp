#include "grader/intake/Hash.h"

#include <array>
#include <cstdint>

#include <sodium.h>

namespace radlab::grader {

namespace {

class Sha256 {
public:
    Sha256() { crypto_hash_sha256_init(&state); }

    void add(std::string_view bytes) {
        crypto_hash_sha256_update(&state, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size());
    }
    void add(std::uint64_t number) {
        std::array<char, 8> bytes;
        for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<char>(number >> (8 * i) & 0xff);
        add(std::string_view(bytes.data(), bytes.size()));
    }
    void addWithLength(std::string_view bytes) {
        add(std::uint64_t{bytes.size()});
        add(bytes);
    }

    std::string finish() {
        std::array<unsigned char, crypto_hash_sha256_BYTES> hash;
        crypto_hash_sha256_final(&state, hash.data());
        std::array<char, 2 * crypto_hash_sha256_BYTES + 1> text;
        return sodium_bin2hex(text.data(), text.size(), hash.data(), hash.size());
    }

private:
    crypto_hash_sha256_state state;
};

}  // namespace

std::string sha256(std::string_view bytes) {
    Sha256 hash;
    hash.add(bytes);
    return hash.finish();
}

std::string hashOf(const std::map<std::string, std::string>& files) {
    Sha256 hash;
    hash.add(std::uint64_t{files.size()});
    for (const auto& [name, contents] : files) {
        hash.addWithLength(name);
        hash.addWithLength(contents);
    }
    return hash.finish();
}

}  // namespace radlab::grader

#include "grader/report/Digest.h"

#include "base/Error.h"

#if __has_include(<sodium.h>)

#include <sodium.h>

namespace radlab::grader {

std::string base64(std::string_view bytes) {
    constexpr int variant = sodium_base64_VARIANT_ORIGINAL;
    std::string text(sodium_base64_encoded_len(bytes.size(), variant), '\0');
    sodium_bin2base64(text.data(), text.size(), reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size(),
                      variant);
    text.pop_back();  // the zero that ends it
    return text;
}

std::string sha256Base64(std::string_view bytes) {
    std::string hash(crypto_hash_sha256_BYTES, '\0');
    crypto_hash_sha256(reinterpret_cast<unsigned char*>(hash.data()),
                       reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size());
    return base64(hash);
}

}  // namespace radlab::grader

#else

namespace radlab::grader {

std::string base64(std::string_view) {
    throw Error("this build has no libsodium, so it cannot write the pages of a class: install it and build again");
}

std::string sha256Base64(std::string_view bytes) { return base64(bytes); }

}  // namespace radlab::grader

#endif

#pragma once

#include <deque>
#include <string>

#include "base/Image.h"

namespace radlab::grader {

/// Pictures as PNG, of which many are alike: each is encoded once, as long as it is among the last ones made.
class PngCache {
public:
    /// The same bytes as pngBytes.
    const std::string& bytes(const Image& image);

    /// How many pictures were encoded.
    std::size_t encoded() const { return made; }

private:
    struct Known {
        int width = 0;
        std::string pixels, png;
    };

    static constexpr std::size_t most = 64;  // of 0.4 MB each

    std::deque<Known> known;
    std::size_t made = 0;
};

}  // namespace radlab::grader

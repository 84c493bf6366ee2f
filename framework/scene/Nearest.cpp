#include "scene/Nearest.h"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

namespace radlab {

namespace {

constexpr std::size_t longestWord = 64;  // nobody mistypes a name into more, and the cost stays small

std::string lowerCase(std::string_view word) {
    std::string result(word);
    for (char& c : result)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return result;
}

}  // namespace

std::size_t editDistance(std::string_view from, std::string_view to) {
    std::vector<std::size_t> row(to.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t(0));
    for (std::size_t i = 0; i < from.size(); ++i) {
        std::size_t diagonal = std::exchange(row[0], i + 1);
        for (std::size_t j = 0; j < to.size(); ++j) {
            const std::size_t changed = diagonal + (from[i] != to[j]);
            diagonal = row[j + 1];
            row[j + 1] = std::min({changed, row[j] + 1, row[j + 1] + 1});
        }
    }
    return row[to.size()];
}

std::string didYouMean(std::string_view word, std::span<const char* const> known) {
    if (word.size() > longestWord) return "";
    std::string nearest;
    std::size_t least = 0;
    for (std::string_view candidate : known) {
        const std::size_t distance = editDistance(lowerCase(word), candidate);
        if (distance > candidate.size() / 3 || (!nearest.empty() && distance >= least)) continue;
        nearest = candidate;
        least = distance;
    }
    return nearest.empty() ? "" : ", did you mean '" + nearest + "'?";
}

}  // namespace radlab

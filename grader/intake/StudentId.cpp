#include "grader/intake/StudentId.h"

#include <algorithm>
#include <array>
#include <map>
#include <string_view>

#include "grader/intake/Hash.h"

namespace radlab::grader {

namespace {

constexpr std::size_t longest = 80;
constexpr std::array<std::size_t, 4> digitsOfHash = {0, 8, 16, 64};

bool isLetterOrDigit(char c) { return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); }

std::string reduced(std::string_view text) {
    std::string id;
    for (const char c : text) {
        const bool kept = isLetterOrDigit(c) || c == '.' || c == '_' || c == '-';
        if (kept)
            id += c;
        else if (id.empty() || id.back() != '-')
            id += '-';
    }
    id.erase(id.begin(), std::find_if(id.begin(), id.end(), isLetterOrDigit));
    while (!id.empty() && !isLetterOrDigit(id.back())) id.pop_back();
    return id.empty() ? "student" : id;
}

std::string lowered(std::string text) {
    for (char& c : text)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c + ('a' - 'A'));
    return text;
}

bool isReserved(const std::string& id) {
    const auto names = {"index", "student", "con", "prn", "aux", "nul"};
    return std::find(names.begin(), names.end(), lowered(id)) != names.end();
}

// The more digits of the hash, the higher the level.
std::string idAt(std::size_t level, const IdSource& source) {
    std::string id = reduced(source.text);
    const std::size_t digits = digitsOfHash[level];
    if (digits == 0) return id.substr(0, longest);
    return id.substr(0, longest - 1 - digits) + "-" + sha256(source.whole).substr(0, digits);
}

}  // namespace

std::vector<std::string> studentIds(const std::vector<IdSource>& sources) {
    std::vector<std::size_t> levels(sources.size());
    std::vector<std::string> ids(sources.size());
    // A name may be chosen to look like another's id with its hash: go on until nobody is alike.
    for (bool alike = true; alike;) {
        alike = false;
        std::map<std::string, std::vector<std::size_t>> byId;
        for (std::size_t i = 0; i < sources.size(); ++i)
            byId[lowered(ids[i] = idAt(levels[i], sources[i]))].push_back(i);
        for (const auto& [id, those] : byId) {
            if (those.size() == 1 && !isReserved(id)) continue;
            for (const std::size_t i : those) {
                if (levels[i] + 1 == digitsOfHash.size()) continue;
                ++levels[i];
                alike = true;
            }
        }
    }
    return ids;
}

}  // namespace radlab::grader

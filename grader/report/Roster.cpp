#include "grader/report/Roster.h"

#include <algorithm>
#include <cctype>
#include <unordered_map>

namespace radlab::grader {

namespace {

constexpr std::size_t several = static_cast<std::size_t>(-1);

// Where each key stands, `several` where it stands more than once.
using Places = std::unordered_map<std::string, std::size_t>;

void add(Places& places, const std::string& key, std::size_t place) {
    if (key.empty()) return;
    const auto [found, isNew] = places.emplace(key, place);
    if (!isNew && found->second != place) found->second = several;
}

std::optional<std::size_t> find(const Places& places, const std::string& key) {
    const auto found = places.find(key);
    if (key.empty() || found == places.end() || found->second == several) return std::nullopt;
    return found->second;
}

std::string lower(const std::string& text, bool lettersAlone) {
    std::string key;
    for (const char letter : text) {
        const auto byte = static_cast<unsigned char>(letter);
        if (byte >= 0x80 || std::isalnum(byte) || !lettersAlone)
            key += byte < 0x80 ? static_cast<char>(std::tolower(byte)) : letter;
    }
    return key;
}

std::string accountKey(const std::string& text) {
    const std::size_t begin = text.find_first_not_of(" \t"), end = text.find_last_not_of(" \t");
    return begin == std::string::npos ? "" : lower(text.substr(begin, end - begin + 1), false);
}

std::string nameKey(const std::string& text) { return lower(text, true); }

class Matching {
public:
    Matching(const std::vector<StudentResult>& all, std::size_t rows)
        : students(all),
          match{std::vector<std::optional<std::size_t>>(all.size()), std::vector<bool>(all.size())},
          taken(rows) {}

    void byAccount(const std::vector<std::vector<std::string>>& columns) {
        std::vector<std::optional<std::size_t>> best;
        std::size_t most = 0;
        for (const std::vector<std::string>& column : columns) {
            Places places;
            for (std::size_t row = 0; row < column.size(); ++row) add(places, accountKey(column[row]), row);
            std::vector<std::optional<std::size_t>> found;
            std::size_t count = 0;
            for (const StudentResult& student : students) {
                found.push_back(find(places, accountKey(student.student.account)));
                if (found.back()) ++count;
            }
            if (count <= most) continue;
            best = std::move(found);
            most = count;
        }
        if (most > 0) accept(best, false);
    }

    void byName(const std::vector<std::vector<std::string>>& columns) {
        Places places;
        for (const std::vector<std::string>& column : columns)
            for (std::size_t row = 0; row < column.size(); ++row)
                if (!taken[row]) add(places, nameKey(column[row]), row);
        std::vector<std::optional<std::size_t>> found;
        for (std::size_t number = 0; number < students.size(); ++number)
            found.push_back(match.row[number] ? std::nullopt : find(places, nameKey(students[number].student.name)));
        accept(found, true);
    }

    RosterMatch result() && { return std::move(match); }

private:
    // Takes what was found, but for rows that two students claim.
    void accept(const std::vector<std::optional<std::size_t>>& found, bool byName) {
        std::vector<int> claims(taken.size(), 0);
        for (const std::optional<std::size_t>& row : found)
            if (row) ++claims[*row];
        for (std::size_t number = 0; number < found.size(); ++number) {
            if (!found[number]) continue;
            taken[*found[number]] = true;
            if (claims[*found[number]] > 1) continue;
            match.row[number] = found[number];
            match.byName[number] = byName;
        }
    }

    const std::vector<StudentResult>& students;
    RosterMatch match;
    std::vector<bool> taken;
};

}  // namespace

RosterMatch matchRoster(const std::vector<StudentResult>& students, const RosterKeys& keys) {
    std::size_t rows = 0;
    for (const auto* columns : {&keys.accounts, &keys.names})
        for (const std::vector<std::string>& column : *columns) rows = std::max(rows, column.size());
    Matching matching(students, rows);
    matching.byAccount(keys.accounts);
    matching.byName(keys.names);
    return std::move(matching).result();
}

}  // namespace radlab::grader

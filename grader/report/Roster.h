#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "grader/protocol/Student.h"

namespace radlab::grader {

/// By what a list of students, one a row, may be matched. A key is empty where a row has none.
struct RosterKeys {
    std::vector<std::vector<std::string>> accounts;  ///< columns that may hold accounts: a key a row, the best first
    std::vector<std::vector<std::string>> names;     ///< ways to write the name: a key a row
};

/// Which row of a list is whose.
struct RosterMatch {
    std::vector<std::optional<std::size_t>> row;  ///< a student
    std::vector<bool> byName;                     ///< a student: no account, but a name that only one row has
};

/// Matches students with the rows of a list.
///
/// Accounts are looked up in one column alone, that in which most of them stand, since another column may use the same
/// numbers for other people; capital letters do not matter. Names, compared by their letters and digits, serve those
/// whom that leaves, for rows that it leaves. What fits twice is not matched.
RosterMatch matchRoster(const std::vector<StudentResult>& students, const RosterKeys& keys);

}  // namespace radlab::grader

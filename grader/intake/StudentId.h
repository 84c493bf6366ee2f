#pragma once

#include <string>
#include <vector>

namespace radlab::grader {

/// What an id is made of.
struct IdSource {
    std::string text;   ///< what the id should look like: any bytes
    std::string whole;  ///< any bytes; no two students have the same
};

/// An id for each student: letters, digits, '.', '_' and '-', at most 80, beginning with a letter or digit.
///
/// No two are the same, not even to a file system that takes upper and lower case for one. Other characters become '-'.
/// Where ids would be alike, or would be a name that file systems or the pages of a class keep for themselves, a hash
/// of `whole` is appended to each of them.
std::vector<std::string> studentIds(const std::vector<IdSource>& sources);

}  // namespace radlab::grader

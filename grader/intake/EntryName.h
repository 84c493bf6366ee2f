#pragma once

#include <string>
#include <string_view>

namespace radlab::grader {

/// The name of an entry of an archive, taken apart.
struct EntryName {
    std::string path;  ///< relative, with '/', without "." and empty parts; as it came where fault says something
    std::size_t folders = 0;  ///< that it lies in
    bool passedOver = false;  ///< it lies in a folder that nobody looks into
    std::string fault;        ///< why no entry may be called so: no name, an absolute one, ".."
    std::string oddity;       ///< why no file that is wanted may be called so: control characters, too long
};

EntryName readEntryName(std::string_view name);

}  // namespace radlab::grader

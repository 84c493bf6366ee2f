#pragma once

#include <filesystem>
#include <functional>
#include <iosfwd>
#include <string>
#include <string_view>

namespace radlab {

/// Writes a file whole or not at all: into a new file beside it, then renamed over it.
///
/// Errors: a folder that does not exist or cannot be written, a full disk; the older file is then left as it was.
void writeFile(const std::filesystem::path& file, std::string_view contents);

/// The same for contents that are not to be held in memory: `write` puts them into the stream, piece by piece.
///
/// Where it throws, nothing is written and the older file is left as it was.
void writeFile(const std::filesystem::path& file, const std::function<void(std::ostream&)>& write);

/// Removes what writeFile has begun and not ended; for signal handlers that end the process.
void removePartFiles() noexcept;

/// The contents of a file.
///
/// Errors: no such file, a folder, a file that cannot be read or is larger than 1 GiB.
std::string readFile(const std::filesystem::path& file);

/// Makes a folder and those that it lies in, where they are not there yet.
///
/// Errors: what cannot be made, such as a folder in the place of a file.
void makeFolder(const std::filesystem::path& folder);

}  // namespace radlab

#pragma once

// Submissions that the tests hand in: files, and archives with whatever an archive can hold.

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include <archive.h>
#include <archive_entry.h>
#include <doctest/doctest.h>

#include "base/TestFolder.h"
#include "base/WholeFile.h"
#include "grader/intake/Submission.h"

namespace radlab::test {

using namespace grader;

inline const std::string work = "int work;\n";

inline IntakeRules rules() {
    IntakeRules made;
    made.unpack = RADLAB_UNPACK_PROGRAM;
    return made;
}

/// Writes a file, and makes the folders that it lies in.
inline void put(const std::filesystem::path& file, const std::string& contents = work) {
    std::filesystem::create_directories(file.parent_path());
    writeFile(file, contents);
}

/// What the places of a student of that name hold.
inline Taken takeFrom(const std::vector<std::filesystem::path>& places, const IntakeRules& within = rules()) {
    Submission submission;
    submission.student.id = "student-07";
    submission.places = places;
    return take(submission, within);
}

inline bool has(const std::vector<std::string>& remarks, const std::string& part) {
    return std::any_of(remarks.begin(), remarks.end(),
                       [&](const std::string& remark) { return remark.find(part) != std::string::npos; });
}

/// An entry of an archive.
struct Entry {
    std::string name;
    std::string contents = work;
    unsigned type = AE_IFREG;
    std::string linkTo = {};
    bool hardLink = false;
};

/// How an archive is packed.
struct Packing {
    int format = ARCHIVE_FORMAT_ZIP;
    int filter = ARCHIVE_FILTER_NONE;
    std::string options = {};
    std::string password = {};
};

inline const Packing asZip;
inline const Packing asTar = {ARCHIVE_FORMAT_TAR_PAX_RESTRICTED};
inline const Packing asTarGz = {ARCHIVE_FORMAT_TAR_PAX_RESTRICTED, ARCHIVE_FILTER_GZIP};

inline void writeEntry(archive* writer, const Entry& entry) {
    archive_entry* const header = archive_entry_new();
    archive_entry_set_pathname(header, entry.name.c_str());
    archive_entry_set_filetype(header, entry.type);
    archive_entry_set_perm(header, 0644);
    if (entry.hardLink)
        archive_entry_set_hardlink(header, entry.linkTo.c_str());
    else if (!entry.linkTo.empty())
        archive_entry_set_symlink(header, entry.linkTo.c_str());
    const bool holds = entry.type == AE_IFREG && !entry.hardLink;
    archive_entry_set_size(header, holds ? static_cast<la_int64_t>(entry.contents.size()) : 0);
    const int code = archive_write_header(writer, header);
    INFO(entry.name);
    REQUIRE((code == ARCHIVE_OK || code == ARCHIVE_WARN));
    if (holds) archive_write_data(writer, entry.contents.data(), entry.contents.size());
    archive_entry_free(header);
}

inline std::string pack(const std::vector<Entry>& entries, const Packing& packing = asZip) {
    std::string bytes;
    archive* const writer = archive_write_new();
    archive_write_set_format(writer, packing.format);
    archive_write_add_filter(writer, packing.filter);
    archive_write_set_bytes_in_last_block(writer, 1);
    if (!packing.options.empty()) REQUIRE(archive_write_set_options(writer, packing.options.c_str()) == ARCHIVE_OK);
    if (!packing.password.empty()) archive_write_set_passphrase(writer, packing.password.c_str());
    const auto append = [](archive*, void* to, const void* from, std::size_t size) {
        static_cast<std::string*>(to)->append(static_cast<const char*>(from), size);
        return static_cast<la_ssize_t>(size);
    };
    REQUIRE(archive_write_open(writer, &bytes, nullptr, append, nullptr) == ARCHIVE_OK);
    for (const Entry& entry : entries) writeEntry(writer, entry);
    REQUIRE(archive_write_close(writer) == ARCHIVE_OK);
    archive_write_free(writer);
    return bytes;
}

}  // namespace radlab::test

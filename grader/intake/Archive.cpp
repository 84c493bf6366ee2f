#include "grader/intake/Archive.h"

#include <locale.h>  // NOLINT(modernize-deprecated-headers): newlocale

#include <algorithm>
#include <array>
#include <memory>
#include <new>
#include <set>

#include <archive.h>
#include <archive_entry.h>

#include "base/Error.h"
#include "grader/intake/EntryName.h"
#include "grader/protocol/PlainText.h"

namespace radlab::grader {

namespace {

// Names in archives are bytes to us; the library converts some of them to the locale, and loses what does not fit.
class Utf8Names {
public:
    Utf8Names() : names(newlocale(LC_CTYPE_MASK, "C.UTF-8", nullptr)), before(uselocale(names)) {}
    ~Utf8Names() {
        uselocale(before);
        if (names) freelocale(names);
    }
    Utf8Names(const Utf8Names&) = delete;
    Utf8Names& operator=(const Utf8Names&) = delete;

private:
    locale_t names, before;
};

struct Free {
    void operator()(archive* reader) const { archive_read_free(reader); }
};
using Reader = std::unique_ptr<archive, Free>;

[[noreturn]] void fail(archive* reader) {
    const char* const why = archive_error_string(reader);
    throw Error("cut off, corrupt, or no archive (" + shownName(why ? why : "no reason given") + ")");
}

// Those filters alone that need no other program.
Reader openedReader(std::string_view bytes, bool raw) {
    Reader reader(archive_read_new());
    if (!reader) throw std::bad_alloc();
    for (const auto support : {archive_read_support_filter_gzip, archive_read_support_filter_bzip2,
                               archive_read_support_filter_xz, archive_read_support_filter_zstd})
        support(reader.get());
    if (raw) {
        archive_read_support_format_raw(reader.get());
    } else {
        // By its directory at the end alone: without it, a zip is cut off.
        archive_read_support_format_zip_seekable(reader.get());
        archive_read_support_format_tar(reader.get());
    }
    if (archive_read_open_memory(reader.get(), bytes.data(), bytes.size()) != ARCHIVE_OK) fail(reader.get());
    if (archive_filter_count(reader.get()) > 2) throw Error("packed more than once");
    return reader;
}

std::string refusedKindOf(archive_entry* entry) {
    if (archive_entry_hardlink(entry)) return "a hard link, which is not followed";
    switch (archive_entry_filetype(entry)) {
        case AE_IFREG: return "";
        case AE_IFLNK: return "a symbolic link, which is not followed";
        case AE_IFIFO: return "a named pipe, which is not taken";
        case AE_IFSOCK: return "a socket, which is not taken";
        default: return "a device or something unknown, which is not taken";
    }
}

std::string nameOf(archive_entry* entry) {
    for (const char* name : {archive_entry_pathname(entry), archive_entry_pathname_utf8(entry)})
        if (name) return name;
    return "";
}

class ArchiveLook {
public:
    ArchiveLook(std::string_view toRead, const IntakeRules& within)
        : bytes(toRead), rules(within), reader(openedReader(toRead, false)), choice(within), gathered(within) {}

    Gathered run() {
        while (archive_entry* const entry = next()) lookAt(entry);
        if ((archive_format(reader.get()) & ARCHIVE_FORMAT_BASE_MASK) != ARCHIVE_FORMAT_ZIP) expectEnd();
        choice.finish(gathered);
        return std::move(gathered);
    }

private:
    archive_entry* next() {
        archive_entry* entry = nullptr;
        const int code = archive_read_next_header(reader.get(), &entry);
        if (code == ARCHIVE_EOF) return nullptr;
        if (code != ARCHIVE_OK && code != ARCHIVE_WARN) fail(reader.get());
        if (++seen > rules.mostEntries)
            throw Error("more than " + std::to_string(rules.mostEntries) + " files and folders");
        const la_int64_t size = archive_entry_size(entry);
        if (size < 0) throw Error("a file of negative size");
        unpacked = std::min<std::uint64_t>(unpacked, INT64_MAX) + static_cast<std::uint64_t>(size);
        expectNoBomb(std::max(unpacked, static_cast<std::uint64_t>(archive_filter_bytes(reader.get(), 0))));
        return entry;
    }

    void expectNoBomb(std::uint64_t size) const {
        if (size > rules.mostUnpacked)
            throw Error("unpacks to " + std::to_string(size) + " bytes, expected at most " +
                        std::to_string(rules.mostUnpacked));
        if (size > rules.ratioCountsFrom && size / rules.mostRatio > bytes.size())
            throw Error("unpacks to " + std::to_string(size) + " bytes out of " + std::to_string(bytes.size()) +
                        ", which is no honest ratio");
    }

    void lookAt(archive_entry* entry) {
        const EntryName name = readEntryName(nameOf(entry));
        if (name.passedOver || (name.fault.empty() && archive_entry_filetype(entry) == AE_IFDIR)) return;
        const std::string fault = name.fault.empty() ? faultOf(entry, name) : name.fault;
        if (!fault.empty())
            gathered.remarks.refuse(shownName(name.path) + ": " + fault);
        else if (!choice.isNamed(name.path))
            gathered.addOther(name.path);
        else if (choice.wants(name.path))
            offer(name.path);
    }

    void offer(const std::string& path) {
        if (validUtf8(path) != path) gathered.remarks.note(shownName(path) + ": a name that is not UTF-8");
        choice.offer({path, contents()});
    }

    // Why an entry is refused, for whatever its name is like one that is wanted, or else for itself.
    std::string faultOf(archive_entry* entry, const EntryName& name) {
        std::string kind = refusedKindOf(entry);
        if (!kind.empty()) {
            if (name.oddity.empty()) links.insert(name.path);  // below an odd name nothing is taken anyway
            return kind;
        }
        if (isBelowLink(name.path)) return "lies behind a link, which is not followed";
        if (archive_entry_is_encrypted(entry)) return "encrypted: pack it without a password";
        if (!choice.isNamed(name.path)) return "";
        if (name.folders > rules.deepest)
            return "in more than " + std::to_string(rules.deepest) + " folders inside one another";
        if (!name.oddity.empty()) return name.oddity;
        const auto size = static_cast<std::uint64_t>(archive_entry_size(entry));
        if (size <= rules.mostBytes) return "";
        return "too large: found " + std::to_string(size) + " bytes, expected at most " +
               std::to_string(rules.mostBytes);
    }

    bool isBelowLink(const std::string& path) const {
        for (std::size_t slash = path.find('/'); slash != std::string::npos; slash = path.find('/', slash + 1))
            if (links.count(path.substr(0, slash))) return true;
        return false;
    }

    // To the end, where the library compares the checksum.
    std::string contents() {
        std::string all;
        std::array<char, 1 << 16> block;
        for (la_ssize_t got; (got = archive_read_data(reader.get(), block.data(), block.size())) != 0;) {
            if (got < 0) fail(reader.get());
            all.append(block.data(), static_cast<std::size_t>(got));
            if (all.size() > rules.mostBytes) throw Error("a file is larger than the archive says");
        }
        return all;
    }

    // A tar is made of blocks, and ends with two of zeros; what packs it ends with its own mark.
    void expectEnd() const {
        constexpr std::size_t blockOfTar = 512;
        const Reader raw = openedReader(bytes, true);
        archive_entry* all = nullptr;
        if (archive_read_next_header(raw.get(), &all) != ARCHIVE_OK) fail(raw.get());
        std::array<char, 1 << 16> block;
        std::uint64_t size = 0;
        std::size_t zerosInARow = 0;
        for (la_ssize_t got; (got = archive_read_data(raw.get(), block.data(), block.size())) != 0;) {
            if (got < 0) fail(raw.get());
            expectNoBomb(size += static_cast<std::uint64_t>(got));
            const auto end = std::make_reverse_iterator(block.begin() + got);
            const auto last = std::find_if(end, block.rend(), [](char byte) { return byte != 0; });
            const auto trailing = static_cast<std::size_t>(last - end);
            zerosInARow = last == block.rend() ? zerosInARow + trailing : trailing;
        }
        if (zerosInARow < 2 * blockOfTar || size % blockOfTar != 0)
            throw Error("cut off: the end of the archive is missing");
    }

    std::string_view bytes;
    const IntakeRules& rules;
    Reader reader;
    Choice choice;
    Gathered gathered;
    std::set<std::string> links;
    std::size_t seen = 0;
    std::uint64_t unpacked = 0;  // bytes, as the entries say
};

}  // namespace

Gathered readArchive(std::string_view bytes, const IntakeRules& rules) {
    const Utf8Names names;
    try {
        return ArchiveLook(bytes, rules).run();
    } catch (const Error& reason) {  // what was read before is not trusted either
        Gathered nothing(rules);
        nothing.remarks.refuse(std::string("the archive is refused: ") + reason.what());
        return nothing;
    }
}

}  // namespace radlab::grader

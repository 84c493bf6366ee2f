#include "base/WholeFile.h"

#include <array>
#include <atomic>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <random>

#include "base/Error.h"

namespace radlab {

namespace {

constexpr std::uintmax_t largestFile = std::uintmax_t{1} << 30;

std::filesystem::path nameBeside(const std::filesystem::path& file) {
    std::random_device random;
    return file.string() + "." + std::to_string(random()) + ".part";
}

// Names of files that are being written, where a signal handler can read them.
struct PartName {
    std::atomic<bool> taken{false}, ready{false};
    std::array<char, 4096> text{};
};
std::array<PartName, 16> partNames;

// The place that the name got; nothing where there is none, and the file then outlives a process that is ended.
PartName* remember(const std::string& name) {
    for (PartName& place : partNames) {
        if (name.size() >= place.text.size() || place.taken.exchange(true)) continue;
        std::memcpy(place.text.data(), name.c_str(), name.size() + 1);
        place.ready = true;
        return &place;
    }
    return nullptr;
}

// A new file beside the one to write; gone again unless it was renamed.
struct PartFile {
    explicit PartFile(const std::filesystem::path& file) : path(nameBeside(file)), name(remember(path.string())) {}
    ~PartFile() {
        std::error_code ignored;
        std::filesystem::remove(path, ignored);
        if (name) name->taken = name->ready = false;
    }
    PartFile(const PartFile&) = delete;
    PartFile& operator=(const PartFile&) = delete;
    const std::filesystem::path path;
    PartName* const name;
};

}  // namespace

void writeFile(const std::filesystem::path& file, std::string_view contents) {
    writeFile(file,
              [&](std::ostream& out) { out.write(contents.data(), static_cast<std::streamsize>(contents.size())); });
}

void writeFile(const std::filesystem::path& file, const std::function<void(std::ostream&)>& write) {
    PartFile part(file);
    std::ofstream out(part.path, std::ios::binary);
    if (!out) throw Error({file.string()}, "cannot be written: is there such a folder, and may you write there?");
    write(out);
    out.close();
    if (!out) throw Error({file.string()}, "writing stopped half-way: is the disk full?");
    std::error_code failure;
    std::filesystem::rename(part.path, file, failure);
    if (failure) throw Error({file.string()}, "cannot be written: " + failure.message());
}

void removePartFiles() noexcept {
    for (PartName& place : partNames)
        if (place.ready) std::remove(place.text.data());
}

std::string readFile(const std::filesystem::path& file) {
    std::error_code failure;
    if (std::filesystem::is_directory(file, failure)) throw Error({file.string()}, "is a folder, expected a file");
    if (!std::filesystem::exists(file, failure)) throw Error({file.string()}, "no such file");
    std::ifstream in(file, std::ios::binary);
    if (!in) throw Error({file.string()}, "cannot be opened: may you read it?");
    const std::uintmax_t size = std::filesystem::file_size(file, failure);
    if (!failure && size > largestFile)
        throw Error({file.string()}, "too large: found " + std::to_string(size) + " bytes, expected at most " +
                                         std::to_string(largestFile));
    std::string contents{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
    if (in.bad()) throw Error({file.string()}, "cannot be read to its end");
    return contents;
}

void makeFolder(const std::filesystem::path& folder) {
    std::error_code failure;
    std::filesystem::create_directories(folder, failure);
    if (failure) throw Error({folder.string()}, "the folder cannot be made: " + failure.message());
}

}  // namespace radlab

#include "grader/intake/Archive.h"

#include <array>
#include <random>

#include "grader/intake/IntakeTestHelp.h"

using namespace radlab;
using namespace radlab::grader;
using radlab::test::asTar;
using radlab::test::asTarGz;
using radlab::test::asZip;
using radlab::test::Entry;
using radlab::test::pack;
using radlab::test::work;

namespace {

Gathered look(const std::string& bytes, const IntakeRules& within = test::rules()) {
    return readArchive(bytes, within);
}

std::string takenFrom(const Gathered& gathered) {
    const auto file = gathered.files.find("ProgRef.cpp");
    return file == gathered.files.end() ? "" : file->second.contents;
}

bool says(const Gathered& gathered, const std::string& part) { return test::has(gathered.remarks.lines(), part); }

void expectRefused(const Gathered& gathered, const std::string& remark) {
    std::string said;
    for (const Remark& one : gathered.remarks.told()) said += one.text + "; ";
    CAPTURE(said);
    CAPTURE(remark);
    CHECK(gathered.files.empty());
    CHECK(gathered.remarks.refusedAny());
    CHECK(says(gathered, remark));
}

// A header of a tar, with a checksum that is right.
std::string tarHeader(const std::string& name, std::size_t size, char type) {
    std::string header(512, '\0');
    name.copy(header.data(), 100);
    std::snprintf(&header[100], 8, "0000644");
    std::array<char, 24> digits;
    std::snprintf(digits.data(), digits.size(), "%011zo", size);
    header.replace(124, 11, digits.data(), 11);
    header[156] = type;
    header.replace(257, 8, std::string("ustar\00000", 8));
    header.replace(148, 8, 8, ' ');
    unsigned sum = 0;
    for (const char byte : header) sum += static_cast<unsigned char>(byte);
    std::snprintf(&header[148], 8, "%06o", sum);
    return header;
}

}  // namespace

TEST_CASE("a wanted file is taken out of a zip and a tar, and others are named") {
    for (const auto& packing : {asZip, asTar, asTarGz}) {
        const Gathered gathered =
            look(pack({{"work/exercises/ProgRef.cpp"}, {"work/README.md"}, {"work/", "", AE_IFDIR}}, packing));
        CHECK(takenFrom(gathered) == work);
        CHECK(gathered.others == std::vector<std::string>{"work/README.md"});
        CHECK(gathered.remarks.told().empty());
    }
}

TEST_CASE("names that lead out of the archive are refused, and what is beside them is taken") {
    for (const auto& packing : {asZip, asTar})
        for (const char* name : {"../../etc/ProgRef.cpp", "a/../ProgRef.cpp", "/etc/ProgRef.cpp", "..", "//ProgRef.cpp",
                                 "C:/ProgRef.cpp", "..\\ProgRef.cpp", "\\ProgRef.cpp"}) {
            CAPTURE(name);
            expectRefused(look(pack({{name}}, packing)), "which is not taken");
            CHECK(takenFrom(look(pack({{name, "bad\n"}, {"deep/er/ProgRef.cpp"}}, packing))) == work);
        }
    expectRefused(look(pack({{"../../etc/passwd"}})), "../../etc/passwd: a name with \"..\"");
    CHECK(takenFrom(look(pack({{"./exercises//ProgRef.cpp"}}, asTar))) == work);
    CHECK(takenFrom(look(pack({{"exercises\\ProgRef.cpp"}}))) == work);
}

TEST_CASE("links are refused, and so is what lies behind them") {
    expectRefused(look(pack({{"ProgRef.cpp", "", AE_IFLNK, "/etc/passwd"}}, asTar)), "ProgRef.cpp: a symbolic link");
    expectRefused(look(pack({{"ProgRef.cpp", "", AE_IFLNK, "/etc/passwd"}})), "ProgRef.cpp: a symbolic link");
    expectRefused(look(pack({{"a.cpp"}, {"ProgRef.cpp", "", AE_IFREG, "a.cpp", true}}, asTar)),
                  "ProgRef.cpp: a hard link");
    const std::vector<Entry> through = {{"exercises", "", AE_IFLNK, "/tmp"}, {"exercises/ProgRef.cpp"}};
    expectRefused(look(pack(through, asTar)), "exercises/ProgRef.cpp: lies behind a link");
    expectRefused(look(pack(through)), "exercises/ProgRef.cpp: lies behind a link");
}

TEST_CASE("devices and pipes in a tar are refused") {
    expectRefused(look(pack({{"ProgRef.cpp", "", AE_IFCHR}}, asTar)), "ProgRef.cpp: a device");
    expectRefused(look(pack({{"ProgRef.cpp", "", AE_IFBLK}}, asTar)), "ProgRef.cpp: a device");
    expectRefused(look(pack({{"ProgRef.cpp", "", AE_IFIFO}}, asTar)), "ProgRef.cpp: a named pipe");
}

TEST_CASE("odd names are told only where the file is wanted, and never as they are") {
    const std::vector<std::string> odd = {"a\nb", "\x1b[2J", "\xe2\x80\xaegpj", "\xff\x1b", std::string(300, 'x')};
    for (const std::string& folder : odd) {
        CAPTURE(folder);
        const Gathered gathered = look(pack({{folder + "/ProgRef.cpp"}}, asTar));
        expectRefused(gathered, ": a name");
        for (const Remark& remark : gathered.remarks.told()) CHECK(visibleLine(remark.text) == remark.text);
        CHECK(look(pack({{folder + "/main.cpp"}}, asTar)).remarks.told().empty());
    }
    for (const char* fine : {"<script>", "=1+1", "a b", "\xe4\xb8\x83"})
        for (const auto& packing : {asZip, asTar})
            CHECK(takenFrom(look(pack({{std::string(fine) + "/ProgRef.cpp"}}, packing))) == work);
}

TEST_CASE("a folder whose name is in another encoding is entered, and told") {
    const Gathered gathered = look(pack({{"\x9a"
                                          "bung/ProgRef.cpp"}},
                                        asTar));
    CHECK(takenFrom(gathered) == work);
    CHECK(says(gathered,
               "\xef\xbf\xbd"
               "bung/ProgRef.cpp: a name that is not UTF-8"));
    CHECK_FALSE(gathered.remarks.refusedAny());
}

TEST_CASE("an entry without a name is refused") {
    const std::string tar =
        tarHeader("", work.size(), '0') + work + std::string(512 - work.size(), '\0') + std::string(1024, '\0');
    expectRefused(look(tar), "without a name");
}

TEST_CASE("an encrypted file is refused") {
    const test::Packing locked = {ARCHIVE_FORMAT_ZIP, ARCHIVE_FILTER_NONE, "zip:encryption=traditional", "password"};
    expectRefused(look(pack({{"ProgRef.cpp"}}, locked)), "ProgRef.cpp: encrypted");
}

TEST_CASE("a file that is too large is refused, too deep a one, too") {
    IntakeRules small = test::rules();
    small.mostBytes = 100;
    expectRefused(look(pack({{"ProgRef.cpp", std::string(101, 'x')}}), small), "too large: found 101 bytes");
    CHECK(takenFrom(look(pack({{"ProgRef.cpp", std::string(100, 'x')}}), small)).size() == 100);
    expectRefused(look(pack({{"1/2/3/4/5/6/7/8/9/ProgRef.cpp"}})), "in more than 8 folders");
    CHECK(takenFrom(look(pack({{"1/2/3/4/5/6/7/8/ProgRef.cpp"}}))) == work);
}

TEST_CASE("too many entries refuse the archive") {
    IntakeRules few = test::rules();
    few.mostEntries = 100;
    std::vector<Entry> entries = {{"ProgRef.cpp"}};
    for (int i = 1; i < 100; ++i) entries.push_back({std::to_string(i), ""});
    CHECK(takenFrom(look(pack(entries), few)) == work);
    entries.push_back({"100", ""});
    expectRefused(look(pack(entries), few), "more than 100 files and folders");
}

TEST_CASE("bombs are refused: by their ratio, by their size, by a size that is only claimed, by packing twice") {
    const std::vector<Entry> zeros = {{"ProgRef.cpp"}, {"zeros", std::string(std::size_t{20} << 20, '\0')}};
    for (const auto& packing : {asZip, asTarGz}) expectRefused(look(pack(zeros, packing)), "no honest ratio");
    IntakeRules small = test::rules();
    small.mostUnpacked = 1000;
    expectRefused(look(pack({{"ProgRef.cpp"}, {"text", std::string(2000, 'x')}}), small), "expected at most 1000");
    const std::string claimed = tarHeader("zeros", std::size_t{4} << 30, '0') + std::string(2048, '\0');
    expectRefused(look(claimed), "unpacks to 4294967296 bytes");
    const test::Packing raw = {ARCHIVE_FORMAT_RAW, ARCHIVE_FILTER_GZIP};
    expectRefused(look(pack({{"x", pack({{"ProgRef.cpp"}}, asTarGz)}}, raw)), "packed more than once");
}

TEST_CASE("a bomb behind the end of a tar is refused, too") {
    const test::Packing raw = {ARCHIVE_FORMAT_RAW, ARCHIVE_FILTER_GZIP};
    const std::string tar = pack({{"ProgRef.cpp"}}, asTar) + std::string(std::size_t{20} << 20, '\0');
    expectRefused(look(pack({{"x", tar}}, raw)), "no honest ratio");
}

TEST_CASE("archives in an archive are not opened") {
    const Gathered gathered = look(pack({{"work.zip", pack({{"ProgRef.cpp"}})}}));
    CHECK(gathered.files.empty());
    CHECK(gathered.others == std::vector<std::string>{"work.zip"});
}

TEST_CASE("an archive that is cut off anywhere gives nothing of what was whole before") {
    for (const auto& packing : {asZip, asTar, asTarGz, test::Packing{ARCHIVE_FORMAT_TAR_USTAR, ARCHIVE_FILTER_XZ},
                                test::Packing{ARCHIVE_FORMAT_TAR_USTAR, ARCHIVE_FILTER_BZIP2}}) {
        const std::string whole = pack({{"ProgRef.cpp"}, {"b.cpp", "int b;\n"}}, packing);
        CHECK(takenFrom(look(whole)) == work);
        for (std::size_t length = 0; length < whole.size(); ++length) {
            const Gathered gathered = look(whole.substr(0, length));
            CAPTURE(length);
            CAPTURE(whole.size());
            if (!gathered.files.empty() || !gathered.remarks.refusedAny()) FAIL_CHECK("taken");
        }
    }
}

TEST_CASE("a zip whose file is corrupt gives nothing") {
    std::string bytes = pack({{"ProgRef.cpp"}}, {ARCHIVE_FORMAT_ZIP, ARCHIVE_FILTER_NONE, "zip:compression=store"});
    bytes[bytes.find(work)] = 'X';
    expectRefused(look(bytes), "CRC");
}

TEST_CASE("what is no archive is refused") {
    for (const std::string& bytes : {std::string(), work, std::string("PK\003\004")})
        expectRefused(look(bytes), "the archive is refused");
    CHECK_FALSE(look(pack({}, asTar)).remarks.refusedAny());
}

TEST_CASE("two thousand changed archives neither crash the reader nor get beyond its limits") {
    std::mt19937 random(7);
    IntakeRules small = test::rules();
    small.mostBytes = 50;
    small.mostEntries = 4;
    const std::vector<Entry> entries = {{"a/ProgRef.cpp"}, {"ProgRef.cpp"}, {"link", "", AE_IFLNK, "x"}};
    for (const auto& packing : {asZip, asTarGz}) {
        const std::string whole = pack(entries, packing);
        for (int i = 0; i < 1000; ++i) {
            std::string changed = whole;
            for (unsigned count = 1 + random() % 4; count > 0; --count)
                changed[random() % changed.size()] = static_cast<char>(random());
            if (random() % 4 == 0) changed.resize(random() % changed.size());
            const Gathered gathered = look(changed, small);
            CHECK(gathered.files.size() <= 1);
            CHECK(takenFrom(gathered).size() <= small.mostBytes);
            CHECK(gathered.remarks.told().size() <= small.mostRemarks);
            CHECK(gathered.others.size() <= small.mostEntries);
        }
    }
}

#include "scene/XmlText.h"

#include <cstdint>
#include <filesystem>
#include <fstream>

#include "scene/SceneTestHelp.h"
#include "scene/XmlDocument.h"

using namespace radlab;
using namespace radlab::test;

namespace {

std::string textError(const std::string& text) {
    return errorOf([&] { checkText(text, "f"); });
}

std::string xmlError(const std::string& text) {
    return errorOf([&] { XmlDocument(text, "f"); });
}

}  // namespace

TEST_CASE("UTF-8 of every length is text") { CHECK(textError("a \xC3\xA9 \xE2\x82\xAC \xF0\x9F\x92\xA1\t\r\n") == ""); }

TEST_CASE("bytes that are not UTF-8 are refused with their line") {
    for (const char* bytes : {"\xFF", "\xC3", "\xC0\xAF", "\xE0\x80\x80", "\xED\xA0\x80", "\xF4\x90\x80\x80", "\x80"}) {
        const std::string message = textError(std::string("a\nb\n") + bytes);
        CAPTURE(message);
        CHECK(message.starts_with("f:3: this is not text, found byte 0x"));
    }
    CHECK(contains(textError(std::string("a\0b", 3)), "0x00"));
}

TEST_CASE("a byte order mark and a document type with declarations are accepted") {
    const XmlDocument document(
        "\xEF\xBB\xBF<?xml version='1.0'?>\n<!-- a > b -->\n<!DOCTYPE X3D PUBLIC \"a>b\" "
        "[\n<!ENTITY x 'y>'>\n]>\n<X3D/>",
        "f");
    CHECK(document.where(document.root()).line == 6);
}

TEST_CASE("a document type is only looked for ahead of the root") {
    const std::string inside = "<a b='<!DOCTYPE x>'/>";
    CHECK(withoutDoctype(inside) == inside);
    const std::string commented = "<!-- <!DOCTYPE x> --><a/>";
    CHECK(withoutDoctype(commented) == commented);
    CHECK(withoutDoctype("<!DOCTYPE x><a/>") == "            <a/>");
    const std::string open = "<!DOCTYPE x [ <a/>";
    CHECK(withoutDoctype(open) == open);
}

TEST_CASE("XML that is not well-formed is refused in plain words with its line") {
    CHECK(contains(xmlError("<a>\n<b>\n</a>"), "f:2: an element that starts here is never closed"));
    CHECK(contains(xmlError("<a>\n<b c=\"1"), "an attribute cannot be read"));
    CHECK(contains(xmlError("<a>\n<!-- "), "a comment is never closed"));
    CHECK(contains(xmlError("<a/>\n<b/>"), "f:2: a second root element, found 'b'"));
    CHECK(contains(xmlError("<a/>\nrest"), "f:2: text with no tag after it"));
    CHECK(contains(xmlError("<a/>\nrest<!-- -->"), "f:2: text outside of every element, found ' rest'"));
    CHECK(contains(xmlError(""), "f: the file is empty"));
    CHECK(contains(xmlError(" \n "), "f: the file is empty"));
    CHECK(contains(xmlError("<!-- only -->"), "f: the file holds no XML element"));
}

TEST_CASE("nesting beyond what the parser follows is an error, not a crash") {
    std::string text;
    for (int i = 0; i < 10000; ++i) text += "<a>";
    CHECK(contains(xmlError(text), "nested too deeply"));
}

TEST_CASE("what a message quotes is short and on one line") {
    CHECK(inQuotes("a\nb") == "'a b'");
    CHECK(inQuotes(std::string(100, 'x')) == "'" + std::string(40, 'x') + "...'");
    // The cut falls into a letter of two bytes, and takes it away whole.
    CHECK(inQuotes(std::string(39, 'x') + "\xC3\xA9yy") == "'" + std::string(39, 'x') + "...'");
}

TEST_CASE("a path survives as UTF-8") { CHECK(pathText(pathFromText("caf\xC3\xA9.x3d")) == "caf\xC3\xA9.x3d"); }

TEST_CASE("a missing file and a folder are told apart") {
    CHECK(contains(errorOf([] { readTextFile("no-such-file.x3d"); }), "no-such-file.x3d: there is no such file"));
    CHECK(contains(errorOf([] { readTextFile(RADLAB_SOURCE_DIR); }), "this is a folder"));
}

TEST_CASE("a file larger than 1 GiB is refused before it is read") {
    const auto file = std::filesystem::temp_directory_path() / "radlab-huge-test.x3d";
    std::ofstream(file).close();
    std::filesystem::resize_file(file, (std::uintmax_t(1) << 30) + 1);
    CHECK(contains(errorOf([&] { readTextFile(file); }), "found 1073741825 bytes, expected at most 1 GiB"));
    std::filesystem::remove(file);
}

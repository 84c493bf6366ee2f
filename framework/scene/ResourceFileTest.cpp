#include "scene/ResourceFile.h"

#include <filesystem>
#include <fstream>
#include <map>

#include "scene/SceneTestHelp.h"
#include "scene/XmlText.h"

using namespace radlab;
using namespace radlab::test;

namespace {

/// A settings file with one setting changed; an empty value takes the setting away.
std::string settings(const std::string& key = "", const std::string& value = "") {
    std::map<std::string, std::string> fields = {{"hemicube_size", "512"},
                                                 {"form_factor_method", "analytic"},
                                                 {"patch_subdivision_size", "0.25"},
                                                 {"light_subdivision_size", "0.1"},
                                                 {"file_name", "scenes/cornell_1.x3d"}};
    if (!key.empty()) fields[key] = value;
    std::string text = "<Resource>\n<Values";
    for (const auto& [name, field] : fields)
        if (!field.empty()) text += " " + name + "=\"" + field + "\"";
    return text + "/>\n</Resource>";
}

std::string errorFor(const std::string& text) {
    return errorOf([&] { parseResource(text, "Resource.xml"); });
}

}  // namespace

TEST_CASE("a settings file gives all five settings") {
    const Resource resource = parseResource(settings(), "course/Resource.xml");
    CHECK(resource.hemicubeSize == 512);
    CHECK(resource.method == FormFactorMethod::analytic);
    CHECK(resource.patchSize == 0.25f);
    CHECK(resource.lightSize == 0.1f);
    CHECK(pathText(resource.sceneFile.lexically_normal().generic_string()) == "course/scenes/cornell_1.x3d");
}

TEST_CASE("the three methods have their names") {
    CHECK(parseResource(settings("form_factor_method", "hemicube"), "r").method == FormFactorMethod::hemicube);
    CHECK(parseResource(settings("form_factor_method", "auto"), "r").method == FormFactorMethod::automatic);
    CHECK(contains(errorFor(settings("form_factor_method", "Analytical")),
                   "found 'Analytical', expected analytic, hemicube or auto, did you mean 'analytic'?"));
}

TEST_CASE("an absolute scene file stays where it is") {
    const auto file = std::filesystem::temp_directory_path() / "a.x3d";
    CHECK(parseResource(settings("file_name", pathText(file)), "course/Resource.xml").sceneFile == file);
}

TEST_CASE("every missing setting is named") {
    for (const char* key :
         {"hemicube_size", "form_factor_method", "patch_subdivision_size", "light_subdivision_size", "file_name"}) {
        CAPTURE(key);
        CHECK(contains(errorFor(settings(key, "")), "Resource.xml:2: setting '" + std::string(key) + "' is missing"));
    }
}

TEST_CASE("an unknown setting is named, with a hint where it is nearly one") {
    CHECK(contains(errorFor(settings("hemicubesize", "512")),
                   "unknown setting 'hemicubesize', did you mean 'hemicube_size'?"));
    CHECK(errorFor(settings("gamma", "2.2")).ends_with("unknown setting 'gamma'"));
    CHECK(contains(errorFor("<Resource hemicube_size='2'><Values/></Resource>"), "unknown setting 'hemicube_size' in"));
    CHECK(contains(errorFor("<Resource><Values file_name='a' file_name='b'/></Resource>"), "each name once"));
}

TEST_CASE("a hemicube size is whole, even and 2 to 4096") {
    for (const char* size : {"0", "1", "511", "4098", "-2", "512.0", "5e2", "big", " 512"}) {
        CAPTURE(size);
        const std::string found = "found '" + std::string(size) + "', expected a whole even number";
        CHECK(contains(errorFor(settings("hemicube_size", size)), "hemicube_size cannot be used, " + found));
    }
    CHECK(parseResource(settings("hemicube_size", "2"), "r").hemicubeSize == 2);
    CHECK(parseResource(settings("hemicube_size", "4096"), "r").hemicubeSize == 4096);
}

TEST_CASE("lengths are finite and greater than 0") {
    for (const char* key : {"patch_subdivision_size", "light_subdivision_size"})
        for (const char* length : {"0", "-1", "nan", "inf", "1e39", "1e-50", "0,1", "1 2"}) {
            CAPTURE(length);
            CHECK(contains(errorFor(settings(key, length)), std::string(key) + " cannot be used"));
        }
}

TEST_CASE("a file name is not blank") {
    CHECK(contains(errorFor(settings("file_name", "  ")), "file_name cannot be used"));
}

TEST_CASE("nothing but one Values element is allowed") {
    CHECK(contains(errorFor("<Resource/>"), "there is no 'Values' element"));
    CHECK(contains(errorFor("<Scene/>"), "found the element 'Scene', expected 'Resource'"));
    CHECK(contains(errorFor("<Resource><Values/>\n<Values/></Resource>"), "Resource.xml:2: unknown element 'Values'"));
    CHECK(contains(errorFor("<Resource><Value/></Resource>"), "unknown element 'Value'"));
    CHECK(contains(errorFor("<Resource>text<Values/></Resource>"), "unknown text 'text'"));
    CHECK(contains(errorFor("<Resource><Values>text</Values></Resource>"), "unknown text 'text' in 'Values'"));
    CHECK(contains(errorFor("<Resource><Values><a/></Values></Resource>"), "unknown element 'a' in 'Values'"));
}

TEST_CASE("comments and an XML declaration are fine") {
    const std::string text = settings();
    CHECK(errorFor("<?xml version='1.0'?><!-- a -->" + text.substr(0, 10) + "<!-- b -->" + text.substr(10)) == "");
}

TEST_CASE("the scene is found beside the settings file, and has to be there") {
    const auto folder = std::filesystem::temp_directory_path() / "radlab-resource-test";
    std::filesystem::create_directories(folder / "scenes");
    std::ofstream(folder / "Resource.xml", std::ios::binary) << settings();
    const std::string message = errorOf([&] { readResource(folder / "Resource.xml"); });
    CHECK(contains(message, "Resource.xml:2: file_name leads to no file, looked at '"));
    CHECK(contains(message, "cornell_1.x3d'"));
    std::ofstream(folder / "scenes" / "cornell_1.x3d") << "x";
    CHECK(readResource(folder / "Resource.xml").sceneFile == folder / "scenes/cornell_1.x3d");
    std::filesystem::remove_all(folder);
}

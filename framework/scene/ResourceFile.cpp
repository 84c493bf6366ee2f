#include "scene/ResourceFile.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <system_error>
#include <utility>

#include "base/Error.h"
#include "scene/Nearest.h"
#include "scene/Number.h"
#include "scene/XmlDocument.h"
#include "scene/XmlText.h"

namespace radlab {

namespace {

using tinyxml2::XMLElement;

constexpr std::array<const char*, 5> keys = {"hemicube_size", "form_factor_method", "patch_subdivision_size",
                                             "light_subdivision_size", "file_name"};
constexpr std::array<const char*, 3> methods = {"analytic", "hemicube", "auto"};

/// The Values element of a settings file, its fields read with their types.
class Values {
public:
    Values(const XMLElement& values, Location place) : element(values), where(std::move(place)) {}

    int hemicubeSize() const {
        const auto size = parseWhole(text("hemicube_size"));
        if (!size || *size < 2 || *size > 4096 || *size % 2 != 0)
            fail("hemicube_size", "a whole even number from 2 to 4096");
        return *size;
    }

    FormFactorMethod method() const {
        const std::string_view name = text("form_factor_method");
        if (name == "analytic") return FormFactorMethod::analytic;
        if (name == "hemicube") return FormFactorMethod::hemicube;
        if (name == "auto") return FormFactorMethod::automatic;
        fail("form_factor_method", "analytic, hemicube or auto" + didYouMean(name, methods));
    }

    float length(const char* key) const {
        const auto value = parseNumber(text(key));
        // A length that a float takes for 0 would cut forever.
        if (!value || !(*value >= std::numeric_limits<float>::min() && *value <= std::numeric_limits<float>::max()))
            fail(key, "a number greater than 0");
        return static_cast<float>(*value);
    }

    std::filesystem::path fileName() const {
        const std::string_view name = text("file_name");
        if (splitList(name).empty()) fail("file_name", "the name of an X3D file");
        return pathFromText(name);
    }

    void checkKeys() const {
        for (auto field = element.FirstAttribute(); field; field = field->Next()) {
            if (std::find(keys.begin(), keys.end(), std::string_view(field->Name())) == keys.end())
                throw Error(where, "unknown setting " + inQuotes(field->Name()) + didYouMean(field->Name(), keys));
        }
        for (const char* key : keys)
            if (!element.Attribute(key)) throw Error(where, "setting '" + std::string(key) + "' is missing");
    }

private:
    std::string_view text(const char* key) const { return element.Attribute(key); }

    [[noreturn]] void fail(const char* key, const std::string& expected) const {
        throw Error(where,
                    std::string(key) + " cannot be used, found " + inQuotes(text(key)) + ", expected " + expected);
    }

    const XMLElement& element;
    Location where;
};

void checkNothingBut(const XmlDocument& document, const XMLElement& parent, const XMLElement* allowed) {
    for (auto node = parent.FirstChild(); node; node = node->NextSibling()) {
        if (node == allowed || node->ToComment()) continue;
        const std::string what = node->ToElement() ? "element " : "text ";
        throw Error(document.where(*node), "unknown " + what + inQuotes(node->Value()) + " in " +
                                               inQuotes(parent.Name()) + ", expected " +
                                               (allowed ? "one 'Values' element alone" : "nothing"));
    }
}

const XMLElement& findValues(const XmlDocument& document) {
    const XMLElement& root = document.root();
    if (std::string_view(root.Name()) != "Resource")
        throw Error(document.where(root),
                    "this is no settings file, found the element " + inQuotes(root.Name()) + ", expected 'Resource'");
    if (root.FirstAttribute())
        throw Error(document.where(root), "unknown setting " + inQuotes(root.FirstAttribute()->Name()) +
                                              " in 'Resource', expected settings in 'Values' alone");
    const XMLElement* values = root.FirstChildElement("Values");
    checkNothingBut(document, root, values);
    if (!values) throw Error(document.where(root), "there is no 'Values' element in 'Resource', expected one");
    checkNothingBut(document, *values, nullptr);
    return *values;
}

struct Settings {
    Resource resource;
    Location where;
};

Settings parse(std::string_view text, const std::string& fileName) {
    const XmlDocument document(text, fileName);
    const XMLElement& element = findValues(document);
    const Location where = document.where(element);
    const Values values(element, where);
    values.checkKeys();
    const std::filesystem::path folder = pathFromText(fileName).parent_path();
    return {{values.hemicubeSize(), values.method(), values.length("patch_subdivision_size"),
             values.length("light_subdivision_size"), folder / values.fileName()},
            where};
}

}  // namespace

Resource readResource(const std::filesystem::path& file) {
    const auto [resource, where] = parse(readTextFile(file), pathText(file));
    std::error_code problem;
    if (!std::filesystem::is_regular_file(resource.sceneFile, problem))
        throw Error(where, "file_name leads to no file, looked at '" + pathText(resource.sceneFile) + "'");
    return resource;
}

Resource parseResource(std::string_view text, const std::string& fileName) { return parse(text, fileName).resource; }

}  // namespace radlab

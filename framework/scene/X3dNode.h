#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <tinyxml2.h>

#include "base/Error.h"
#include "course/Vec3f.h"

namespace radlab {

/// An element of an X3D file, its fields read with their types.
///
/// A view: the document and the file's name have to live longer. Every read throws an Error that names the
/// field, what was found and what was expected, with the line of the element.
class X3dNode {
public:
    X3dNode(const tinyxml2::XMLElement& element, const std::string& fileName) : node(&element), file(&fileName) {}

    const tinyxml2::XMLElement* element() const { return node; }
    std::string_view name() const;
    const std::string& fileName() const { return *file; }
    Location where() const { return {*file, node->GetLineNum()}; }

    bool has(const char* field) const { return node->Attribute(field) != nullptr; }

    /// The text of a field, empty where it is not given.
    std::string_view text(const char* field) const;

    /// true or false, in either case of letters.
    bool flag(const char* field, bool otherwise) const;

    /// All numbers of a field, each finite and within the range of a float.
    ///
    /// @cost one pass over the field
    std::vector<double> numbers(const char* field) const;

    /// Exactly `count` numbers, or nothing where the field is not given.
    std::vector<double> numbers(const char* field, std::size_t count) const;

    double number(const char* field, double otherwise) const;
    glm::dvec3 vector(const char* field, glm::dvec3 otherwise) const;

    /// Three numbers from 0 to `largest`, linear RGB.
    Vec3f colour(const char* field, Vec3f otherwise, double largest) const;

    /// One number from 0 to 1.
    float fraction(const char* field, float otherwise) const;

    /// All whole numbers of a field.
    std::vector<int> wholes(const char* field) const;

    /// Calls `visit` with every child element, in the file's order.
    template <class Visit>
    void eachChild(Visit visit) const {
        for (auto child = node->FirstChildElement(); child; child = child->NextSiblingElement())
            visit(X3dNode(*child, *file));
    }

    /// Throws an Error that starts with the element's place and name.
    [[noreturn]] void fail(const std::string& what) const;

private:
    const tinyxml2::XMLElement* node;
    const std::string* file;
};

}  // namespace radlab

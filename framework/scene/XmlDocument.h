#pragma once

#include <string>
#include <string_view>

#include <tinyxml2.h>

#include "base/Error.h"

namespace radlab {

/// A well-formed XML file with one root element.
class XmlDocument {
public:
    /// Parses the text of a file.
    ///
    /// A byte order mark and a document type are accepted.
    ///
    /// @throws Error with the line where the text is not UTF-8, is cut off, is not well-formed, is empty or has
    ///         more than one root
    /// @cost   two copies of the text and a tree of about its size
    XmlDocument(std::string_view text, std::string fileName);

    const tinyxml2::XMLElement& root() const { return *document.RootElement(); }
    const std::string& fileName() const { return name; }
    Location where(const tinyxml2::XMLNode& node) const { return {name, node.GetLineNum()}; }

private:
    void checkSingleRoot() const;

    std::string name;
    tinyxml2::XMLDocument document;
};

/// A name without its namespace prefix: Scene for x3d:Scene.
std::string_view localName(const char* name);

}  // namespace radlab

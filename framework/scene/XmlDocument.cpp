#include "scene/XmlDocument.h"

#include <utility>

#include "scene/XmlText.h"

namespace radlab {

namespace {

/// tinyxml2's errors in words for somebody who has never heard of it.
std::string plainWords(tinyxml2::XMLError problem) {
    switch (problem) {
        case tinyxml2::XML_ERROR_EMPTY_DOCUMENT: return "the file is empty, expected an XML element";
        case tinyxml2::XML_ERROR_PARSING:
        case tinyxml2::XML_ERROR_MISMATCHED_ELEMENT:
            return "an element that starts here is never closed, or is closed under another name; "
                   "is the file cut off?";
        case tinyxml2::XML_ERROR_PARSING_ATTRIBUTE:
            return "an attribute cannot be read, expected name=\"value\" with each name once; "
                   "is a quote missing, or the file cut off?";
        case tinyxml2::XML_ERROR_PARSING_ELEMENT:
            return "an element cannot be read, expected <Name attributes> or <Name attributes/>; "
                   "is the file cut off?";
        case tinyxml2::XML_ERROR_PARSING_COMMENT: return "a comment is never closed, expected -->";
        case tinyxml2::XML_ERROR_PARSING_CDATA: return "a CDATA section is never closed, expected ]]>";
        case tinyxml2::XML_ERROR_PARSING_DECLARATION:
            return "an XML declaration cannot be read, expected <?xml ...?> at the very start";
        case tinyxml2::XML_ERROR_PARSING_UNKNOWN: return "a <!...> is never closed, expected >";
        case tinyxml2::XML_ERROR_PARSING_TEXT:
            return "text with no tag after it, expected XML elements; is the file cut off, or no XML at all?";
        case tinyxml2::XML_ELEMENT_DEPTH_EXCEEDED: return "elements are nested too deeply, expected fewer levels";
        default: return "this is not well-formed XML";
    }
}

}  // namespace

XmlDocument::XmlDocument(std::string_view text, std::string fileName) : name(std::move(fileName)) {
    checkText(text, name);
    const std::string plain = withoutDoctype(text);
    const tinyxml2::XMLError problem = document.Parse(plain.data(), plain.size());
    if (problem == tinyxml2::XML_ERROR_EMPTY_DOCUMENT) throw Error(Location{name, 0}, plainWords(problem));
    if (problem != tinyxml2::XML_SUCCESS) throw Error(Location{name, document.ErrorLineNum()}, plainWords(problem));
    if (!document.RootElement()) throw Error(Location{name, 0}, "the file holds no XML element, expected one");
    checkSingleRoot();
}

void XmlDocument::checkSingleRoot() const {
    for (auto node = document.FirstChild(); node; node = node->NextSibling()) {
        if (node->ToText())
            throw Error(where(*node), "text outside of every element, found " + inQuotes(node->Value()));
        if (node->ToElement() && node != document.RootElement())
            throw Error(where(*node), "a second root element, found " + inQuotes(node->Value()) +
                                          ", expected the end of the file after " +
                                          inQuotes(document.RootElement()->Value()));
    }
}

std::string_view localName(const char* name) {
    const std::string_view whole(name);
    const std::size_t colon = whole.rfind(':');
    return colon == std::string_view::npos ? whole : whole.substr(colon + 1);
}

}  // namespace radlab

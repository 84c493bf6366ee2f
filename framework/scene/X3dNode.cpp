#include "scene/X3dNode.h"

#include <cmath>
#include <limits>

#include "base/Interrupts.h"
#include "scene/Number.h"
#include "scene/XmlDocument.h"
#include "scene/XmlText.h"

namespace radlab {

namespace {

double finiteNumber(const X3dNode& node, const char* field, std::string_view token) {
    const auto value = parseNumber(token);
    if (!value) node.fail(std::string(field) + " holds what is no number, found " + inQuotes(token));
    if (std::abs(*value) > std::numeric_limits<float>::max())
        node.fail(std::string(field) + " holds a number too large, found " + inQuotes(token) +
                  ", expected at most 3.4e38");
    return *value;
}

}  // namespace

std::string_view X3dNode::name() const { return localName(node->Name()); }

std::string_view X3dNode::text(const char* field) const {
    const char* value = node->Attribute(field);
    return value ? value : std::string_view();
}

bool X3dNode::flag(const char* field, bool otherwise) const {
    if (!has(field)) return otherwise;
    const std::string_view value = text(field);
    if (value == "true" || value == "TRUE") return true;
    if (value == "false" || value == "FALSE") return false;
    fail(std::string(field) + " is neither true nor false, found " + inQuotes(value));
}

std::vector<double> X3dNode::numbers(const char* field) const {
    const auto tokens = splitList(text(field));
    std::vector<double> values;
    values.reserve(tokens.size());
    for (std::string_view token : tokens) {
        Interrupts::check();
        values.push_back(finiteNumber(*this, field, token));
    }
    return values;
}

std::vector<double> X3dNode::numbers(const char* field, std::size_t count) const {
    auto values = numbers(field);
    if (has(field) && values.size() != count)
        fail(std::string(field) + " has the wrong number of values, found " + std::to_string(values.size()) +
             ", expected " + std::to_string(count));
    return values;
}

double X3dNode::number(const char* field, double otherwise) const {
    const auto values = numbers(field, 1);
    return values.empty() ? otherwise : values[0];
}

glm::dvec3 X3dNode::vector(const char* field, glm::dvec3 otherwise) const {
    const auto values = numbers(field, 3);
    return values.empty() ? otherwise : glm::dvec3(values[0], values[1], values[2]);
}

Vec3f X3dNode::colour(const char* field, Vec3f otherwise, double largest) const {
    const auto values = numbers(field, 3);
    if (values.empty()) return otherwise;
    for (double value : values) {
        if (value >= 0 && value <= largest) continue;
        const bool bounded = std::isfinite(largest);
        fail(std::string(field) + " is out of range, found " + numberText(value) + ", expected " +
             (bounded ? "0 to " + numberText(largest) : "0 or more"));
    }
    return Vec3f(glm::dvec3(values[0], values[1], values[2]));
}

float X3dNode::fraction(const char* field, float otherwise) const {
    if (!has(field)) return otherwise;
    const double value = number(field, 0);
    if (value < 0 || value > 1)
        fail(std::string(field) + " is out of range, found " + numberText(value) + ", expected 0 to 1");
    return static_cast<float>(value);
}

std::vector<int> X3dNode::wholes(const char* field) const {
    const auto tokens = splitList(text(field));
    std::vector<int> values;
    values.reserve(tokens.size());
    for (std::string_view token : tokens) {
        Interrupts::check();
        const auto value = parseWhole(token);
        if (!value) fail(std::string(field) + " holds what is no whole number, found " + inQuotes(token));
        values.push_back(*value);
    }
    return values;
}

void X3dNode::fail(const std::string& what) const { throw Error(where(), std::string(name()) + ": " + what); }

}  // namespace radlab

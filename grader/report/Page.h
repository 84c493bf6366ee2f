#pragma once

#include <string>

#include <kainjow/mustache.hpp>

#include "grader/protocol/Result.h"

namespace radlab::grader {

// What the pages of a result and of a class share. The template escapes every value for HTML.

/// A page of resources/grader, with what belongs to all pages: {{{style}}}.
///
/// @param name of the template, "report.mustache"
/// Errors: a template that cannot be read or is broken.
std::string renderPage(const std::string& name, kainjow::mustache::data& values);

/// A file of resources/grader.
std::string pageResource(const std::string& name);

/// Any bytes as text for a page, of bounded length; it says how much was left out.
std::string shown(const std::string& bytes);

/// Sets a value that has a text; an empty one would still open a section of the template.
void setUnlessEmpty(kainjow::mustache::data& entry, const char* key, const std::string& text);

/// The class of the style sheet, and the word.
void setStatus(kainjow::mustache::data& entry, Status status);

/// Where there are marks to get: "12/20", and the share in percent.
void setMarks(kainjow::mustache::data& entry, double score, double maxScore);

/// The share in percent, 0 to 100, as a style sheet takes it.
std::string percentText(double score, double maxScore);

}  // namespace radlab::grader

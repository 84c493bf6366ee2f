#pragma once

#include <string>
#include <vector>

namespace radlab::grader {

/// How many scores fall into each of ten equal parts of 0 to the most; full marks are in the last.
///
/// @pre most > 0
std::vector<int> histogramOf(const std::vector<double>& scores, double most);

/// The same drawn, as SVG for a page: a bar a part with its count above and a tooltip. It is as wide as its place, and
/// coloured by the style sheet (classes column, reach, count, scale and axis).
///
/// @param height in pixels, at least 60
/// @param title says what is drawn, for those who do not see it; escaped here
/// @pre most > 0
std::string histogramSvg(const std::vector<double>& scores, double most, int height, const std::string& title);

}  // namespace radlab::grader

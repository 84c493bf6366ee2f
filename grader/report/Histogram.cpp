#include "grader/report/Histogram.h"

#include <algorithm>

#include <kainjow/mustache.hpp>

#include "base/Error.h"
#include "grader/report/Wording.h"

namespace radlab::grader {

namespace {

constexpr int parts = 10;
constexpr double above = 18, below = 20;  // room for the counts and for the scale, in pixels

// Across, all is in percent, so that the drawing is as wide as its place and letters keep their size.
std::string textAt(double percent, double y, const char* kind, const char* anchor, const std::string& text) {
    return "<text class=\"" + std::string(kind) + "\" x=\"" + marksText(percent) + "%\" y=\"" + marksText(y) +
           "\" text-anchor=\"" + anchor + "\">" + text + "</text>";
}

std::string rectangle(const char* kind, double percent, double wide, double y, double tall) {
    return "<rect class=\"" + std::string(kind) + "\" x=\"" + marksText(percent) + "%\" y=\"" + marksText(y) +
           "\" width=\"" + marksText(wide) + "%\" height=\"" + marksText(tall) + "\" rx=\"2\"/>";
}

std::string tooltip(int part, int count, double most) {
    return marksText(most * part / parts) + (part + 1 < parts ? " to below " : " to ") +
           marksText(most * (part + 1) / parts) + " marks: " + std::to_string(count) +
           (count == 1 ? " student" : " students");
}

}  // namespace

std::vector<int> histogramOf(const std::vector<double>& scores, double most) {
    RADLAB_CHECK(most > 0.0);
    std::vector<int> counts(parts, 0);
    for (const double score : scores) {
        // A sum of marks may fall short of a whole tenth by rounding.
        const double part = score > 0.0 ? std::min(parts * score / most + 1e-9, parts - 1.0) : 0.0;
        ++counts[static_cast<std::size_t>(part)];
    }
    return counts;
}

std::string histogramSvg(const std::vector<double>& scores, double most, int height, const std::string& title) {
    const std::vector<int> counts = histogramOf(scores, most);
    const int largest = std::max(*std::max_element(counts.begin(), counts.end()), 1);
    const double floorY = height - below, step = 100.0 / parts;
    std::string svg = "<svg class=\"histogram\" height=\"" + std::to_string(height) + "\" role=\"img\" aria-label=\"" +
                      kainjow::mustache::html_escape(title) + "\">";
    for (int part = 0; part < parts; ++part) {
        const int count = counts[static_cast<std::size_t>(part)];
        const double tall = (floorY - above) * count / largest;
        svg += "<g><title>" + tooltip(part, count, most) + "</title>" +
               rectangle("reach", part * step, step, 0, floorY) +
               rectangle("column", part * step + 0.4, step - 0.8, floorY - tall, tall);
        if (count > 0) svg += textAt((part + 0.5) * step, floorY - tall - 4, "count", "middle", std::to_string(count));
        svg += "</g>";
    }
    svg += rectangle("axis", 0, 100, floorY, 1);
    svg += textAt(0, height - 5, "scale", "start", "0");
    svg += textAt(50, height - 5, "scale", "middle", marksText(most / 2));
    svg += textAt(100, height - 5, "scale", "end", marksText(most));
    return svg + "</svg>";
}

}  // namespace radlab::grader

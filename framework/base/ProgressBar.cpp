#include "base/ProgressBar.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <iostream>

#ifdef _WIN32
#include <io.h>
#else
#include <unistd.h>
#endif

namespace radlab {

namespace {

constexpr double redrawInterval = 0.1;
constexpr int barWidth = 24;

std::string decimal(double value) {
    char text[32];
    std::snprintf(text, sizeof text, value < 10.0 ? "%.1f" : "%.0f", value);
    return text;
}

}  // namespace

bool errorStreamIsTerminal() {
#ifdef _WIN32
    return _isatty(_fileno(stderr)) != 0;
#else
    return isatty(fileno(stderr)) != 0;
#endif
}

std::string durationText(double seconds) {
    if (seconds < 59.5) return decimal(seconds) + " s";
    const auto whole = static_cast<long long>(std::llround(seconds));
    if (whole < 3600) return std::to_string(whole / 60) + " min " + std::to_string(whole % 60) + " s";
    return std::to_string(whole / 3600) + " h " + std::to_string(whole % 3600 / 60) + " min";
}

ProgressBar::ProgressBar(std::string titleText, double totalSteps, std::string unitText)
    : ProgressBar(std::move(titleText), totalSteps, std::move(unitText), std::cerr,
                  errorStreamIsTerminal() || std::getenv("RADLAB_PROGRESS")) {}

ProgressBar::ProgressBar(std::string titleText, double totalSteps, std::string unitText, std::ostream& stream,
                         bool shown)
    : title(std::move(titleText)), unit(std::move(unitText)), total(totalSteps), out(stream), visible(shown) {}

ProgressBar::~ProgressBar() {
    if (lastLength > 0) out << '\r' << std::string(lastLength, ' ') << '\r' << std::flush;
}

void ProgressBar::show(double done, const std::string& note) {
    const double now = watch.seconds();
    if (!visible || (lastDrawn >= 0.0 && now - lastDrawn < redrawInterval)) return;
    lastDrawn = now;
    const std::string text = line(done, note);
    out << '\r' << text << std::string(lastLength > text.size() ? lastLength - text.size() : 0, ' ') << std::flush;
    lastLength = text.size();
}

std::string ProgressBar::line(double done, const std::string& note) const {
    const double share = total > 0.0 ? std::clamp(done / total, 0.0, 1.0) : 1.0;
    const int full = static_cast<int>(share * barWidth);
    const double rate = done / std::max(watch.seconds(), 1e-9);
    std::string text = title + " [" + std::string(full, '#') + std::string(barWidth - full, '.') + "] " +
                       std::to_string(static_cast<int>(share * 100.0)) + " %";
    if (done > 0.0) {
        if (!unit.empty()) text += ", " + decimal(rate) + " " + unit + "/s";
        text += ", " + durationText(std::max(total - done, 0.0) / rate) + " left";
    }
    return note.empty() ? text : text + ", " + note;
}

}  // namespace radlab

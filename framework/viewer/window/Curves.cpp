#include <algorithm>
#include <cmath>

#include "viewer/window/Ui.h"

namespace radlab {

namespace {

// A plot's frame in window units, and the range of its values.
struct Plot {
    ImVec2 low, high;  // top left, bottom right of the inner area
    double bottom, top;

    float x(double share) const { return low.x + static_cast<float>(share) * (high.x - low.x); }
    float y(double value) const {
        const double share = std::clamp((value - bottom) / (top - bottom), 0.0, 1.0);
        return high.y - static_cast<float>(share) * (high.y - low.y);
    }
};

Plot beginPlot(Ui& ui, const char* title, float left) {
    ImGui::TextDisabled("%s", title);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x, height = ui.unit(84.0f);
    ImGui::Dummy(ImVec2(width, height + ImGui::GetFontSize()));
    const Plot plot{{at.x + left, at.y + ui.unit(4.0f)}, {at.x + width - ui.unit(2.0f), at.y + height}, 0.0, 1.0};
    ImGui::GetWindowDrawList()->AddRectFilled(plot.low, plot.high, IM_COL32(14, 16, 20, 255), ui.unit(3.0f));
    return plot;
}

void tick(const Plot& plot, double value, const char* text) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const float y = plot.y(value);
    draw.AddLine({plot.low.x, y}, {plot.high.x, y}, palette::line);
    const ImVec2 size = ImGui::CalcTextSize(text);
    draw.AddText({plot.low.x - size.x - 5.0f, y - 0.5f * size.y}, palette::faint, text);
}

void shotsAxis(const Plot& plot, std::size_t shots) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const std::string last = std::to_string(shots) + (shots == 1 ? " shot" : " shots");
    draw.AddText({plot.low.x, plot.high.y}, palette::faint, "0");
    draw.AddText({plot.high.x - ImGui::CalcTextSize(last.c_str()).x, plot.high.y}, palette::faint, last.c_str());
}

// One point a pixel at most: the largest of the values that fall on it.
template <class Value>
void curve(const Plot& plot, const std::vector<ShotRecord>& history, ImU32 color, const Value& value) {
    const std::size_t columns = std::max<std::size_t>(2, static_cast<std::size_t>(plot.high.x - plot.low.x));
    const std::size_t points = std::min(columns, history.size());
    std::vector<ImVec2> line;
    for (std::size_t i = 0; i < points; ++i) {
        const std::size_t from = i * history.size() / points, to = (i + 1) * history.size() / points;
        double largest = value(history[from]);
        for (std::size_t k = from; k < to; ++k) largest = std::max(largest, value(history[k]));
        line.push_back({plot.x(static_cast<double>(to) / static_cast<double>(history.size())), plot.y(largest)});
    }
    ImGui::GetWindowDrawList()->AddPolyline(line.data(), static_cast<int>(line.size()), color, 0, 1.5f);
}

void unshotCurve(Ui& ui, const std::vector<ShotRecord>& history) {
    Plot plot = beginPlot(ui, "unshot power, % of the emitted (log)", ui.unit(40.0f));
    plot.bottom = -1.0;
    plot.top = 2.0;
    for (const auto& [value, text] : {std::pair{2.0, "100"}, {1.0, "10"}, {0.0, "1"}, {-1.0, "0.1"}})
        tick(plot, value, text);
    shotsAxis(plot, history.size());
    curve(plot, history, palette::warm,
          [](const ShotRecord& r) { return std::log10(std::max(100.0 * r.unshotShare, 1e-9)); });
}

// 1, 2 or 5 times a power of ten, at least value.
double niceAbove(double value) {
    const double power = std::pow(10.0, std::floor(std::log10(std::max(value, 1e-9))));
    for (const double times : {1.0, 2.0, 5.0})
        if (times * power >= value) return times * power;
    return 10.0 * power;
}

void timeCurve(Ui& ui, const std::vector<ShotRecord>& history) {
    Plot plot = beginPlot(ui, "time per shot, ms", ui.unit(40.0f));
    double largest = 0.0;
    for (const ShotRecord& record : history) largest = std::max(largest, 1e3 * record.seconds);
    plot.top = niceAbove(largest);
    for (const double share : {0.0, 0.5, 1.0}) {
        char text[32];
        std::snprintf(text, sizeof text, "%.3g", share * plot.top);
        tick(plot, share * plot.top, text);
    }
    shotsAxis(plot, history.size());
    curve(plot, history, palette::accent, [](const ShotRecord& r) { return 1e3 * r.seconds; });
}

}  // namespace

void drawCurves(Ui& ui) {
    const std::vector<ShotRecord>& history = ui.viewer.simulation().history();
    if (history.empty()) {
        ImGui::TextDisabled("curves begin with the first shot");
        return;
    }
    unshotCurve(ui, history);
    timeCurve(ui, history);
}

}  // namespace radlab

// What lies over the picture.

#include <algorithm>

#include "display/FalseColor.h"
#include "viewer/window/Ui.h"

namespace radlab {

namespace {

constexpr int overlayFlags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                             ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_AlwaysAutoResize |
                             ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav;

ImU32 colorOf(Banner::Kind kind) {
    return kind == Banner::Kind::problem ? palette::bad : kind == Banner::Kind::stub ? palette::warm : palette::accent;
}

float drawBanner(Ui& ui, const Banner& banner, int number, float left, float right, float top) {
    const float width = std::min(right - left - ui.unit(24.0f), ui.unit(620.0f));
    ImGui::SetNextWindowPos(ImVec2(left + ui.unit(12.0f), top));
    ImGui::SetNextWindowSizeConstraints(ImVec2(width, 0.0f), ImVec2(width, ui.unit(400.0f)));
    ImGui::SetNextWindowBgAlpha(0.93f);
    ImGui::Begin(("banner " + std::to_string(number)).c_str(), nullptr, overlayFlags | ImGuiWindowFlags_NoInputs);
    const ImVec2 at = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
    ImGui::GetWindowDrawList()->AddRectFilled(at, {at.x + ui.unit(4.0f), at.y + size.y}, colorOf(banner.kind));
    ImGui::PushTextWrapPos(width - ui.unit(12.0f));
    ImGui::PushFont(ui.bold);
    ImGui::PushStyleColor(ImGuiCol_Text, colorOf(banner.kind));
    ImGui::TextUnformatted(banner.title.c_str());
    ImGui::PopStyleColor();
    ImGui::PopFont();
    if (!banner.text.empty()) ImGui::TextUnformatted(banner.text.c_str());
    ImGui::PopTextWrapPos();
    ImGui::End();
    return top + size.y + ui.unit(8.0f);
}

struct Scale {
    const char *title, *low, *high;
};

void drawScale(Ui& ui, const Scale& scale, float left, float height) {
    ImDrawList& draw = *ImGui::GetBackgroundDrawList();
    const float width = ui.unit(220.0f), bar = ui.unit(10.0f), text = ImGui::GetFontSize(), pad = ui.unit(8.0f);
    const ImVec2 at(left + ui.unit(20.0f), height - ui.unit(24.0f) - 2.0f * text - bar);
    draw.AddRectFilled({at.x - pad, at.y - pad}, {at.x + width + pad, at.y + 2.0f * text + bar + pad + 4.0f},
                       IM_COL32(20, 22, 26, 220), ui.unit(4.0f));
    draw.AddText(at, palette::text, scale.title);
    constexpr int steps = 48;
    for (int i = 0; i < steps; ++i) {
        const glm::vec3 c = 255.0f * heatColor((static_cast<float>(i) + 0.5f) / steps);
        const float x = at.x + width * static_cast<float>(i) / steps,
                    next = at.x + width * static_cast<float>(i + 1) / steps;
        draw.AddRectFilled({x, at.y + text + 2.0f}, {next, at.y + text + 2.0f + bar},
                           IM_COL32(static_cast<int>(c.r), static_cast<int>(c.g), static_cast<int>(c.b), 255));
    }
    const float below = at.y + text + bar + 3.0f;
    draw.AddText({at.x, below}, palette::faint, scale.low);
    draw.AddText({at.x + width - ImGui::CalcTextSize(scale.high).x, below}, palette::faint, scale.high);
}

void drawHelp(Ui& ui, float left, float right, float height) {
    const float middle = 0.5f * (left + right);
    ImGui::SetNextWindowPos(ImVec2(middle, 0.5f * height), ImGuiCond_Always, ImVec2(0.5f, 0.5f));
    ImGui::SetNextWindowBgAlpha(0.96f);
    ImGui::Begin("keys", nullptr, overlayFlags);
    ImGui::PushFont(ui.bold);
    ImGui::TextUnformatted("Keys and mouse");
    ImGui::PopFont();
    ImGui::Separator();
    const auto line = [&](const char* keys, const char* what) {
        ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(palette::accent), "%s", keys);
        ImGui::SameLine(ui.unit(112.0f));
        ImGui::TextUnformatted(what);
    };
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(ui.unit(7.0f), ui.unit(1.5f)));
    line("left drag", "turn");
    line("middle drag", "move; shift and left drag too");
    line("wheel", "nearer, farther");
    line("click", "pick a patch");
    for (const Binding& binding : bindings()) line(binding.keys, binding.what);
    ImGui::PopStyleVar();
    ImGui::End();
}

void drawStatus(Ui& ui, float right, float height) {
    char text[64] = "? for keys";
    if (ui.viewer.isPlaying())  // else frames come when there is something new to show
        std::snprintf(text, sizeof text, "shooting   %.0f frames/s   ? for keys", ui.framesPerSecond);
    const ImVec2 size = ImGui::CalcTextSize(text);
    const ImVec2 at(right - size.x - ui.unit(14.0f), height - size.y - ui.unit(10.0f));
    ImDrawList& draw = *ImGui::GetBackgroundDrawList();
    draw.AddRectFilled({at.x - 6, at.y - 3}, {at.x + size.x + 6, at.y + size.y + 3}, IM_COL32(20, 22, 26, 190),
                       ui.unit(4.0f));
    draw.AddText(at, palette::faint, text);
}

}  // namespace

void drawOverlay(Ui& ui, float left, float right, float height) {
    const Mode mode = ui.viewer.state().mode;
    if (mode == Mode::unshot) drawScale(ui, {"unshot power of a patch", "1/10000", "largest"}, left, height);
    if (mode == Mode::formFactors)
        drawScale(ui,
                  {ui.viewer.picked().view ? "form factor from the picked patch" : "form factor from the last shooter",
                   "1e-7", "1e-2"},
                  left, height);
    drawStatus(ui, right, height);
    float top = ui.unit(12.0f);
    int number = 0;
    for (const Banner& banner : ui.viewer.banners()) top = drawBanner(ui, banner, number++, left, right, top);
    if (ui.viewer.helpShown()) drawHelp(ui, left, right, height);
}

}  // namespace radlab

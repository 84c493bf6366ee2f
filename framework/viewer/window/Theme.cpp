#include <array>
#include <filesystem>

#include "viewer/window/Ui.h"

namespace radlab {

namespace {

constexpr float fontSize = 15.0f;

ImFont* fontFrom(const std::array<const char*, 5>& files, float size) {
    // Latin, Greek, super- and subscripts, arrows, and the signs of formulas.
    static const ImWchar ranges[] = {0x20,   0xff,   0x370,  0x3ff,  0x2010, 0x2027, 0x2070,
                                     0x209f, 0x2190, 0x2193, 0x2200, 0x22ff, 0};
    for (const char* file : files)
        if (std::filesystem::exists(file)) return ImGui::GetIO().Fonts->AddFontFromFileTTF(file, size, nullptr, ranges);
    ImFontConfig plain;
    plain.SizePixels = size;
    return ImGui::GetIO().Fonts->AddFontDefault(&plain);
}

ImVec4 grey(float lightness, float alpha = 1.0f) {
    return {0.92f * lightness, 0.97f * lightness, 1.06f * lightness, alpha};
}

void setColors() {
    ImGui::StyleColorsDark();
    ImVec4* colors = ImGui::GetStyle().Colors;
    const ImVec4 accent = ImGui::ColorConvertU32ToFloat4(palette::accent);
    const ImVec4 dim(0.45f * accent.x, 0.45f * accent.y, 0.45f * accent.z, 1.0f);
    colors[ImGuiCol_WindowBg] = ImGui::ColorConvertU32ToFloat4(palette::panel);
    colors[ImGuiCol_PopupBg] = grey(0.14f, 0.98f);
    colors[ImGuiCol_Text] = ImGui::ColorConvertU32ToFloat4(palette::text);
    colors[ImGuiCol_TextDisabled] = ImGui::ColorConvertU32ToFloat4(palette::faint);
    colors[ImGuiCol_Border] = grey(1.0f, 0.10f);
    colors[ImGuiCol_Separator] = grey(1.0f, 0.10f);
    for (const int item : {ImGuiCol_FrameBg, ImGuiCol_Button}) colors[item] = grey(0.19f);
    for (const int item : {ImGuiCol_FrameBgHovered, ImGuiCol_ButtonHovered}) colors[item] = grey(0.26f);
    for (const int item : {ImGuiCol_FrameBgActive, ImGuiCol_ButtonActive, ImGuiCol_HeaderActive}) colors[item] = dim;
    colors[ImGuiCol_Header] = grey(0.16f);
    colors[ImGuiCol_HeaderHovered] = grey(0.24f);
    for (const int item : {ImGuiCol_CheckMark, ImGuiCol_SliderGrab, ImGuiCol_SliderGrabActive, ImGuiCol_TextSelectedBg})
        colors[item] = accent;
    colors[ImGuiCol_ScrollbarBg] = grey(0.0f, 0.0f);
    colors[ImGuiCol_ScrollbarGrab] = grey(0.3f);
}

void setSizes(float scale) {
    ImGuiStyle& style = ImGui::GetStyle();
    style.WindowPadding = {12, 10};
    style.FramePadding = {8, 5};
    style.ItemSpacing = {7, 6};
    style.ItemInnerSpacing = {6, 4};
    style.ScrollbarSize = 10;
    style.GrabMinSize = 12;
    style.WindowRounding = 0;
    style.FrameRounding = style.PopupRounding = style.GrabRounding = 4;
    style.WindowBorderSize = 0;
    style.ScaleAllSizes(scale);
}

}  // namespace

void setTheme(Ui& ui) {
    setColors();
    setSizes(ui.scale);
    const float size = ui.unit(fontSize);
    ImFontAtlas& fonts = *ImGui::GetIO().Fonts;
    fonts.Clear();
    fontFrom({"/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf", "/usr/share/fonts/dejavu-sans-fonts/DejaVuSans.ttf",
              "/usr/share/fonts/TTF/DejaVuSans.ttf", "C:/Windows/Fonts/segoeui.ttf", "/System/Library/Fonts/SFNS.ttf"},
             size);
    ui.bold =
        fontFrom({"/usr/share/fonts/truetype/dejavu/DejaVuSans-Bold.ttf",
                  "/usr/share/fonts/dejavu-sans-fonts/DejaVuSans-Bold.ttf", "/usr/share/fonts/TTF/DejaVuSans-Bold.ttf",
                  "C:/Windows/Fonts/segoeuib.ttf", "/System/Library/Fonts/SFNS.ttf"},
                 size);
}

}  // namespace radlab

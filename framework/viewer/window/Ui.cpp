#include "viewer/window/Ui.h"

namespace radlab {

namespace {

constexpr float labelWidth = 112.0f;

const Binding& bindingOf(Command command) {
    for (const Binding& binding : bindings())
        if (binding.command == command) return binding;
    return bindings().front();
}

}  // namespace

float panelWidth(const Ui& ui) { return ui.unit(316.0f); }
float inspectorWidth(const Ui& ui) { return ui.unit(300.0f); }

void Ui::remember(const std::string& name) {
    if (ImGui::IsWindowAppearing()) return;  // a list that opens has its place from the second frame on
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    const float top = ImGui::GetWindowPos().y, bottom = top + ImGui::GetWindowHeight();
    if (high.y <= top || low.y >= bottom) return;  // scrolled away
    rectangles[name] = {low.x, low.y, high.x, high.y};
}

void Ui::button(const char* text, Command command, float width, bool on) {
    const ImVec4 lit = ImGui::ColorConvertU32ToFloat4(palette::accent);
    if (on) {
        for (const ImGuiCol color : {ImGuiCol_Button, ImGuiCol_ButtonHovered, ImGuiCol_ButtonActive})
            ImGui::PushStyleColor(color, lit);
        ImGui::PushStyleColor(ImGuiCol_Text, ImVec4(0.05f, 0.09f, 0.10f, 1.0f));
    }
    if (ImGui::Button(text, ImVec2(width, 0.0f))) viewer.perform(command);
    if (on) ImGui::PopStyleColor(4);
    const Binding& binding = bindingOf(command);
    remember(binding.what);
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s (%s)", binding.what, binding.keys);
}

void Ui::label(const char* text, const char* tooltip) {
    ImGui::AlignTextToFramePadding();
    fact(text, tooltip);
    ImGui::SetNextItemWidth(-1.0f);
}

void Ui::fact(const char* text, const char* tooltip) {
    ImGui::TextDisabled("%s", text);
    if (*tooltip && ImGui::IsItemHovered()) ImGui::SetTooltip("%s", tooltip);
    ImGui::SameLine(unit(labelWidth));
}

}  // namespace radlab

// The panel of the picked patch, at the right.

#include <cstdint>

#include "viewer/window/Ui.h"

namespace radlab {

namespace {

void number(Ui& ui, const char* name, const char* unit, double value, const char* tooltip) {
    ui.fact(name, tooltip);
    ImGui::Text("%.5g %s", value, unit);
}

void color(Ui& ui, const char* name, const char* unit, const Vec3f& value, const char* tooltip) {
    ui.fact(name, tooltip);
    ImGui::Text("%.3g  %.3g  %.3g", static_cast<double>(value.r), static_cast<double>(value.g),
                static_cast<double>(value.b));
    if (*unit && ImGui::IsItemHovered()) ImGui::SetTooltip("red, green, blue in %s", unit);
}

void picture(Ui& ui, GLuint image, const char* name, float side) {
    const auto texture = (ImTextureID)(std::intptr_t)image;  // a pointer or an integer, by ImGui's version
    ImGui::BeginGroup();
    ImGui::Image(texture, ImVec2(side, side));
    if (ImGui::IsItemHovered()) {
        ImGui::BeginTooltip();
        ImGui::Image(texture, ImVec2(3.0f * side, 3.0f * side));
        ImGui::EndTooltip();
    }
    ImGui::TextDisabled("%s", name);
    ImGui::EndGroup();
    ui.remember(name);
}

void hemicube(Ui& ui) {
    ImGui::Separator();
    ImGui::TextUnformatted("Its hemicube, unfolded");
    if (!ui.idTexture) return ImGui::TextDisabled("needs renderPatchIDs");
    const float gap = ImGui::GetStyle().ItemSpacing.x;
    const float side = 0.5f * (ImGui::GetContentRegionAvail().x - gap);
    picture(ui, ui.idTexture, "what it sees", side);
    ImGui::SameLine();
    picture(ui, ui.weightTexture, "pixels' weights", side);
}

void row(Ui& ui) {
    const Picked& picked = ui.viewer.picked();
    ImGui::Separator();
    ImGui::TextUnformatted("Form factors from here");
    if (!picked.view) return ImGui::TextDisabled("not known: see the message");
    number(ui, "sum", "", picked.view->sum,
           "over all patches: 1 in a closed scene, less in an open one; more is an error of the method");
    if (ui.viewer.state().mode != Mode::formFactors) ui.button("Show as heat map", Command::formFactors, -1.0f);
}

}  // namespace

void drawInspector(Ui& ui, float left, float height) {
    const std::size_t index = *ui.viewer.picked().patch;
    const MyPolygon& patch = ui.viewer.simulation().mesh().patches.at(index);
    ImGui::SetNextWindowPos(ImVec2(left, 0.0f));
    ImGui::SetNextWindowSize(ImVec2(inspectorWidth(ui), height));
    ImGui::Begin("patch", nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoCollapse |
                     ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings);
    ImGui::PushFont(ui.bold);
    ImGui::AlignTextToFramePadding();
    ImGui::Text("Patch %zu", index);
    ImGui::PopFont();
    ImGui::SameLine(ImGui::GetContentRegionMax().x - ui.unit(64.0f));
    ui.button("Let go", Command::unpick, ui.unit(64.0f));
    ImGui::Separator();
    number(ui, "area", "units\xc2\xb2", static_cast<double>(patch.area), "A, in squared units of the scene");
    color(ui, "albedo", "shares of 1", patch.diffuse, "reflectance \xcf\x81: red, green, blue");
    color(ui, "emissive", "W/m\xc2\xb2", patch.emissive,
          "radiosity that it emits by itself: red, green, blue, W/m\xc2\xb2");
    color(ui, "rad", "W/m\xc2\xb2", patch.rad, "radiosity B found so far: red, green, blue, W/m\xc2\xb2");
    color(ui, "unshot_rad", "W/m\xc2\xb2", patch.unshot_rad,
          "the part of B not shot yet: red, green, blue, W/m\xc2\xb2");
    number(ui, "formF", "", static_cast<double>(patch.formF), "form factor from the last shooter to this patch");
    if (const auto shooter = ui.viewer.simulation().lastShooter()) {
        ui.fact("last shooter", "");
        ImGui::Text("patch %zu%s", *shooter, *shooter == index ? ", this one" : "");
    }
    row(ui);
    hemicube(ui);
    ImGui::End();
}

}  // namespace radlab

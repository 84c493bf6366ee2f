// The panel of controls at the left.

#include <cmath>
#include <set>

#include "viewer/window/Ui.h"

namespace radlab {

namespace {

constexpr double liveSeconds = 0.1;  // a mesh that is cut faster than this follows the slider

void title(Ui& ui, const char* text) {
    ImGui::Dummy(ImVec2(0.0f, ui.unit(3.0f)));
    ImGui::PushFont(ui.bold);
    ImGui::TextUnformatted(text);
    ImGui::PopFont();
    ImGui::Separator();
}

float third(int of = 3) {
    const float gap = ImGui::GetStyle().ItemSpacing.x;
    return (ImGui::GetContentRegionAvail().x - gap * static_cast<float>(of - 1)) / static_cast<float>(of);
}

std::set<std::filesystem::path> scenesBeside(const std::filesystem::path& file) {
    std::set<std::filesystem::path> scenes{file};
    for (const std::filesystem::path& folder :
         {file.parent_path(), std::filesystem::path(RADLAB_SOURCE_DIR "/resources/scenes")}) {
        std::error_code none;
        for (const auto& entry : std::filesystem::directory_iterator(folder.empty() ? "." : folder, none))
            if (entry.path().extension() == ".x3d") scenes.insert(entry.path());
    }
    return scenes;
}

void sceneChoice(Ui& ui) {
    ui.label("scene", "a scene keeps its view and its settings");
    const std::filesystem::path now = ui.viewer.sceneFile();
    const bool open = ImGui::BeginCombo("##scene", now.filename().string().c_str(), ImGuiComboFlags_HeightLarge);
    ui.remember("scene");
    if (!open) return;
    for (const std::filesystem::path& scene : scenesBeside(now)) {
        if (ImGui::Selectable(scene.filename().string().c_str(), scene == now) && scene != now) ui.viewer.choose(scene);
        ui.remember("scene: " + scene.filename().string());
    }
    ImGui::EndCombo();
}

void transport(Ui& ui) {
    const float width = third();
    const bool playing = ui.viewer.isPlaying();
    ui.button(playing ? "Pause" : "Play", Command::playPause, width, playing);
    ImGui::SameLine();
    ui.button("One shot", Command::oneShot, width);
    ImGui::SameLine();
    ui.button("Reset", Command::reset, width);
    ui.label("shots a frame",
             "how many shots are made between two pictures; at the left, as many as fit into the time");
    int& shots = ui.viewer.state().shotsPerFrame;
    ImGui::SliderInt("##shots", &shots, 0, 50, shots == 0 ? "as many as fit" : "%d", ImGuiSliderFlags_AlwaysClamp);
    ui.remember("shots a frame");
}

void modes(Ui& ui) {
    title(ui, "Show");
    const Mode mode = ui.viewer.state().mode;
    const float width = third();
    ui.button("Wireframe", Command::wireframe, width, mode == Mode::wireframe);
    ImGui::SameLine();
    ui.button("Flat", Command::flat, width, mode == Mode::flat);
    ImGui::SameLine();
    ui.button("Smooth", Command::smooth, width, mode == Mode::smooth);
    ui.button("Unshot", Command::unshot, width, mode == Mode::unshot);
    ImGui::SameLine();
    ui.button("IDs", Command::ids, width, mode == Mode::ids);
    ImGui::SameLine();
    ui.button("Factors", Command::formFactors, width, mode == Mode::formFactors);
    const float half = third(3);
    ui.button("Mesh lines", Command::meshLines, half, ui.viewer.state().meshLines);
    ImGui::SameLine();
    ui.button("Frame", Command::frameAll, half);
    ImGui::SameLine();
    ui.button("First view", Command::firstView, half);
}

template <class Value, std::size_t count>
bool choice(Ui& ui, const char* name, const char* tooltip, Value& value, const Value (&values)[count],
            const std::function<std::string(Value)>& text) {
    ui.label(name, tooltip);
    const bool open = ImGui::BeginCombo((std::string("##") + name).c_str(), text(value).c_str());
    ui.remember(name);
    if (!open) return false;
    bool changed = false;
    for (const Value& other : values) {
        if (ImGui::Selectable(text(other).c_str(), other == value) && other != value) {
            value = other;
            changed = true;
        }
        ui.remember(std::string(name) + ": " + text(other));
    }
    ImGui::EndCombo();
    return changed;
}

void sizeSlider(Ui& ui, const char* name, const char* tooltip, float ViewState::*size) {
    static float live = 0.0f;  // while the slider is held
    static const char* held = nullptr;
    ViewState wanted = ui.viewer.state();
    const float now = wanted.*size;
    float value = held == name ? live : now;
    const float room = ballRound(ui.viewer.simulation().scene().vertices).radius;
    ui.label(name, tooltip);
    const bool moved = ImGui::SliderFloat((std::string("##") + name).c_str(), &value, 0.008f * room, room, "%.3g",
                                          ImGuiSliderFlags_Logarithmic);
    ui.remember(name);
    if (moved) {
        held = name;
        live = value;
    }
    const bool released = held == name && !ImGui::IsItemActive();
    if (released || (moved && ui.viewer.applySeconds() < liveSeconds)) {
        wanted.*size = live;
        if (live != now) ui.viewer.apply(wanted);
    }
    if (released) held = nullptr;
}

void solverControls(Ui& ui) {
    title(ui, "Solve");
    ViewState wanted = ui.viewer.state();
    const FormFactorMethod methods[] = {FormFactorMethod::automatic, FormFactorMethod::analytic,
                                        FormFactorMethod::hemicube};
    const std::string used = nameOf(ui.viewer.simulation().method());
    if (choice<FormFactorMethod>(
            ui, "method", "how form factors are found; auto: the formula where nothing hides anything", wanted.method,
            methods, [&](FormFactorMethod m) {
                return m == FormFactorMethod::automatic ? "auto (" + used + ")" : std::string(nameOf(m));
            }))
        ui.viewer.apply(wanted);
    const int sizes[] = {32, 64, 128, 256, 512, 1024};
    if (choice<int>(ui, "hemicube", "pixels along an edge of the hemicube's top face", wanted.hemicubeSize, sizes,
                    [](int size) { return std::to_string(size) + " pixels"; }))
        ui.viewer.apply(wanted);
    sizeSlider(ui, "patch size", "longest edge of a patch, in the scene's unit of length", &ViewState::patchSize);
    sizeSlider(ui, "light size", "the same for patches that emit", &ViewState::lightSize);
}

void exposureControls(Ui& ui) {
    title(ui, "Display");
    ViewState& state = ui.viewer.state();
    ui.label("exposure", "stops (powers of two) of display value per radiance");
    ImGui::SetNextItemWidth(-ui.unit(62.0f));
    float stops = std::log2(exposureOf(state));
    if (ImGui::SliderFloat("##exposure", &stops, -12.0f, 12.0f, "%+.1f stops")) {
        state.exposure = std::exp2(stops);
        state.autoExposure = false;
    }
    ui.remember("exposure");
    ImGui::SameLine();
    ui.button("Auto", Command::autoExposure, -1.0f, state.autoExposure);
    const ToneCurve curves[] = {ToneCurve::clamp, ToneCurve::reinhard, ToneCurve::filmic};
    choice<ToneCurve>(ui, "tone curve", "how radiances are brought into what a display can show", state.curve, curves,
                      [](ToneCurve curve) { return std::string(nameOf(curve)); });
    const float width = third(2);
    ui.button("Screenshot", Command::screenshot, width);
    ImGui::SameLine();
    ui.button("Keys", Command::help, width, ui.viewer.helpShown());
}

void figure(Ui& ui, const char* name, const char* format, double value, const char* tooltip) {
    ui.fact(name, tooltip);
    ImGui::Text(format, value);
}

void figures(Ui& ui) {
    title(ui, "Progress");
    const Progress& now = ui.viewer.simulation().progress();
    ui.fact("patches", "");
    ImGui::Text("%zu, %zu vertices", ui.viewer.simulation().mesh().patches.size(),
                ui.viewer.simulation().mesh().corners.size());
    ui.fact("shots", "");
    ImGui::Text("%d in %.2f s", now.shots, now.seconds);
    figure(ui, "unshot", "%.2f %%", 100.0 * now.unshotShare, "unshot power over emitted power");
    if (now.emitted > 0.0) {
        figure(ui, "absorbed", "%.1f %% of the emitted", 100.0 * now.absorbed / now.emitted,
               "power that surfaces took up");
        figure(ui, "escaped", "%.1f %% of the emitted", 100.0 * now.escaped / now.emitted,
               "power that left the scene, or was lost where form factors do not sum to 1");
    }
    drawCurves(ui);
}

void effects(Ui& ui) {
    if (!ImGui::CollapsingHeader("Effects in use, and why", ImGuiTreeNodeFlags_DefaultOpen)) {
        ui.remember("effects");
        return;
    }
    ui.remember("effects");
    for (const Effect effect : allEffects) {
        const Decision& decision = ui.viewer.simulation().effects()[effect];
        ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(decision.on ? palette::accent : palette::faint), "%s %s",
                           decision.on ? "on" : "off", nameOf(effect));
        ImGui::PushTextWrapPos(0.0f);
        ImGui::TextDisabled("%s", decision.reason.c_str());
        ImGui::PopTextWrapPos();
    }
}

}  // namespace

void drawPanel(Ui& ui, float height) {
    ImGui::SetNextWindowPos(ImVec2(0.0f, 0.0f));
    ImGui::SetNextWindowSize(ImVec2(panelWidth(ui), height));
    ImGui::Begin("controls", nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoCollapse |
                     ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings);
    sceneChoice(ui);
    transport(ui);
    modes(ui);
    solverControls(ui);
    exposureControls(ui);
    figures(ui);
    effects(ui);
    ImGui::End();
}

}  // namespace radlab

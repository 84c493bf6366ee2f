#pragma once

#include <map>
#include <string>

#include <imgui.h>

#include "gl/OpenGL.h"
#include "viewer/Viewer.h"

namespace radlab {

/// What the parts of the user interface share: the viewer that they show and change, sizes, and where things lie.
struct Ui {
    explicit Ui(Viewer& shown) : viewer(shown) {}

    Viewer& viewer;
    float scale = 1.0f;      ///< of the display, times the user's
    ImFont* bold = nullptr;  ///< for titles
    double framesPerSecond = 0.0;
    std::map<std::string, ImVec4>
        rectangles;  ///< of this frame's controls by name: left, top, right, bottom, in window units
    GLuint idTexture = 0, weightTexture = 0;  ///< of the picked patch's hemicube; 0: none

    float unit(float pixels) const { return pixels * scale; }

    /// Notes where the last item lies.
    void remember(const std::string& name);

    /// A button that gives a command; lit where `on`. Its tooltip says what the command does and its key.
    void button(const char* label, Command command, float width, bool on = false);

    /// A label at the left, after which the row's control fills the rest.
    void label(const char* text, const char* tooltip);

    /// The same for a row of text.
    void fact(const char* text, const char* tooltip);
};

/// Sets colours, roundings and fonts for a scale.
void setTheme(Ui& ui);

/// The colours of the theme.
namespace palette {
constexpr ImU32 accent = IM_COL32(92, 200, 190, 255), warm = IM_COL32(240, 180, 90, 255),
                bad = IM_COL32(235, 105, 95, 255), text = IM_COL32(226, 230, 235, 255),
                faint = IM_COL32(150, 158, 168, 255), panel = IM_COL32(24, 27, 32, 255),
                line = IM_COL32(255, 255, 255, 24);
}

/// Width of the panel of controls, and of the panel of the picked patch, in window units.
float panelWidth(const Ui& ui);
float inspectorWidth(const Ui& ui);

void drawPanel(Ui& ui, float height);
void drawInspector(Ui& ui, float left, float height);

/// What lies over the picture between `left` and `right`: banners, the scale of colours, the help.
void drawOverlay(Ui& ui, float left, float right, float height);

/// The curves of unshot power and of the time that shots took.
void drawCurves(Ui& ui);

}  // namespace radlab

#include "viewer/window/ViewerWindow.h"

#include <algorithm>
#include <cmath>

#include <imgui.h>
#include <imgui_impl_glfw.h>
#include <imgui_impl_opengl2.h>
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "gl/SavedState.h"
#include "gl/window/Window.h"
#include "viewer/window/FrameMeter.h"
#include "viewer/window/Keyboard.h"
#include "viewer/window/Texture.h"
#include "viewer/window/Trace.h"
#include "viewer/window/Ui.h"

namespace radlab {

namespace {

constexpr int settlingFrames = 4;    // drawn after the last input, so that controls come to rest
constexpr double idleSeconds = 0.1;  // between two looks at the file while nothing happens
constexpr float dragStart = 4.0f;    // window units that a click may move

// ImGui with its two backends in the window's context, which becomes current, while it lives.
class ImGuiSession {
public:
    explicit ImGuiSession(Window& window) {
        window.makeCurrent();
        ImGui::CreateContext();
        ImGui::GetIO().IniFilename = nullptr;
        ImGui_ImplGlfw_InitForOpenGL(window.handle(), true);
        ImGui_ImplOpenGL2_Init();
    }
    ~ImGuiSession() {
        ImGui_ImplOpenGL2_Shutdown();
        ImGui_ImplGlfw_Shutdown();
        ImGui::DestroyContext();
    }
    ImGuiSession(const ImGuiSession&) = delete;
    ImGuiSession& operator=(const ImGuiSession&) = delete;
};

class ViewerWindow {
public:
    ViewerWindow(const WindowOptions& how, const ViewerOptions& options, SharedView& shared, const Restart& restart)
        : look(how),
          window(how.width, how.height, "radlab view", true),
          keyboard(window.handle()),
          session(window),
          viewer(options, shared, restart),
          ui(viewer),
          trace(how.trace),
          meter(how.benchSeconds) {
        glfwSetWindowSizeLimits(window.handle(), 320, 240, GLFW_DONT_CARE, GLFW_DONT_CARE);
        glfwSwapInterval(look.benchSeconds > 0.0 ? 0 : 1);
        viewer.setFrameMeanwhile([this] { frameMeanwhile(); });
        rescale();
    }

    int run() {
        while (!viewer.closing()) frame();
        if (look.benchSeconds > 0.0) meter.tell(viewer);
        return 0;
    }

private:
    // Fonts and paddings anew where the window has come to a display of another scale.
    void rescale() {
        float wanted = look.scale;
        if (!(wanted > 0.0f)) glfwGetWindowContentScale(window.handle(), &wanted, nullptr);
        int width = 0, pixels = 0;
        glfwGetWindowSize(window.handle(), &width, nullptr);
        glfwGetFramebufferSize(window.handle(), &pixels, nullptr);
        // Where a window unit is several pixels, as on macOS, units are scaled already.
        if (!(look.scale > 0.0f) && width > 0) wanted /= static_cast<float>(pixels) / static_cast<float>(width);
        if (wanted == ui.scale && ui.bold) return;
        ui.scale = wanted;
        setTheme(ui);
        // What was drawn with the fonts before, which are gone, is made anew in the next frame.
        ImGui_ImplOpenGL2_DestroyDeviceObjects();
    }

    void frame() {
        const bool animated = viewer.isPlaying() || viewer.hasRequests() || unsettled > 0;
        if (animated)
            glfwPollEvents();
        else
            glfwWaitEventsTimeout(idleSeconds);
        askForCommands();
        viewer.advance();
        rescale();
        drawFrame();
    }

    // In the middle of a shot: what is asked for now is done after it.
    void frameMeanwhile() {
        const SavedState saved;
        gl().bindFramebuffer(GL_FRAMEBUFFER, 0);
        glfwPollEvents();
        askForCommands();
        drawFrame();
    }

    void askForCommands() {
        if (glfwWindowShouldClose(window.handle())) viewer.perform(Command::quit);
        const std::vector<Command> commands = keyboard.take();
        unsettled = commands.empty() ? std::max(0, unsettled - 1) : settlingFrames;
        if (ImGui::GetIO().WantTextInput) return;
        for (const Command command : commands) viewer.perform(command);
    }

    void drawFrame() {
        ImGui_ImplOpenGL2_NewFrame();
        ImGui_ImplGlfw_NewFrame();
        ImGui::NewFrame();
        ui.rectangles.clear();
        const ImVec2 size = ImGui::GetIO().DisplaySize;
        layOut(size);
        obeyMouse(size);
        showTextures();
        if (viewer.state().panel) drawPanel(ui, size.y);
        if (inspecting()) drawInspector(ui, size.x - inspectorWidth(ui), size.y);
        drawOverlay(ui, picture.x, picture.z, size.y);
        ImGui::Render();
        const Place place = pictureInPixels(size);
        clearAll();
        viewer.draw(place);
        ImGui_ImplOpenGL2_RenderDrawData(ImGui::GetDrawData());
        while (glGetError() != GL_NO_ERROR) ++glErrors;
        glfwSwapBuffers(window.handle());
        trace.write(ui, picture, glErrors + viewer.glErrors(), unsettled == 0);
        meter.count(viewer);
        ui.framesPerSecond = meter.framesPerSecond();
    }

    bool inspecting() { return viewer.state().panel && viewer.picked().patch.has_value(); }

    void layOut(const ImVec2& size) {
        const float left = viewer.state().panel ? panelWidth(ui) : 0.0f;
        const float right = size.x - (inspecting() ? inspectorWidth(ui) : 0.0f);
        picture = {left, 0.0f, std::max(right, left + 1.0f), size.y};
    }

    Place pictureInPixels(const ImVec2& size) const {
        int width = 0, height = 0;
        glfwGetFramebufferSize(window.handle(), &width, &height);
        const float x = size.x > 0.0f ? static_cast<float>(width) / size.x : 1.0f;
        const int left = static_cast<int>(std::lround(picture.x * x)),
                  right = static_cast<int>(std::lround(picture.z * x));
        return {left, 0, std::max(1, right - left), std::max(1, height)};
    }

    static void clearAll() {
        glDisable(GL_SCISSOR_TEST);
        glClearColor(0.08f, 0.09f, 0.11f, 1.0f);
        glClear(GL_COLOR_BUFFER_BIT);
    }

    bool overPicture(const ImVec2& at) const { return at.x >= picture.x && at.x < picture.z; }

    void obeyMouse(const ImVec2& size) {
        const ImGuiIO& io = ImGui::GetIO();
        const bool down = io.MouseDown[0] || io.MouseDown[1] || io.MouseDown[2];
        if (io.MouseDelta.x != 0.0f || io.MouseDelta.y != 0.0f || down || io.MouseWheel != 0.0f)
            unsettled = settlingFrames;
        if (io.WantCaptureMouse && !dragging) return;
        if (!dragging && io.MouseWheel != 0.0f && overPicture(io.MousePos))
            viewer.state().camera.zoom(std::pow(0.9f, io.MouseWheel));
        for (int button = 0; button < 3; ++button)
            if (ImGui::IsMouseClicked(button) && overPicture(io.MousePos)) {
                dragging = true;
                moved = 0.0f;
            }
        if (!dragging) return;
        if (!ImGui::IsMouseClicked(0) && !ImGui::IsMouseClicked(1) && !ImGui::IsMouseClicked(2))
            drag(io, size);  // the way to where a button went down is no drag
        if (ImGui::IsMouseReleased(0) && moved < dragStart) pick(io.MousePos, size);
        if (!down) dragging = false;
    }

    void drag(const ImGuiIO& io, const ImVec2& size) {
        moved += std::abs(io.MouseDelta.x) + std::abs(io.MouseDelta.y);
        if (moved < dragStart) return;
        const float smaller = std::max(1.0f, std::min(picture.z - picture.x, size.y));
        OrbitCamera& camera = viewer.state().camera;
        if (io.MouseDown[2] || (io.MouseDown[0] && io.KeyShift))
            camera.pan(-io.MouseDelta.x / smaller, io.MouseDelta.y / smaller);
        else if (io.MouseDown[0])
            camera.orbit(-3.0f * io.MouseDelta.x / smaller, -3.0f * io.MouseDelta.y / smaller);
    }

    void pick(const ImVec2& at, const ImVec2& size) {
        const Place place = pictureInPixels(size);
        const float pixels = static_cast<float>(place.height) / size.y;
        viewer.pick(place, static_cast<int>((at.x - picture.x) * pixels),
                    place.height - 1 - static_cast<int>(at.y * pixels));
        unsettled = settlingFrames;
    }

    void showTextures() {
        const auto& view = viewer.picked().view;
        const bool shown = view && !view->ids.empty();
        if (!shown) {
            ui.idTexture = ui.weightTexture = 0;
            textured = nullptr;
            return;
        }
        if (textured == view->ids.data().data()) return;
        textured = view->ids.data().data();
        ids.show(view->ids);
        weights.show(view->weights);
        ui.idTexture = ids.id();
        ui.weightTexture = weights.id();
    }

    const WindowOptions look;
    Window window;
    Keyboard keyboard;
    ImGuiSession session;
    Viewer viewer;
    Ui ui;
    Trace trace;
    FrameMeter meter;
    Texture ids, weights;
    const void* textured = nullptr;
    ImVec4 picture{};
    bool dragging = false;
    float moved = 0.0f;
    int unsettled = settlingFrames, glErrors = 0;
};

}  // namespace

int runViewerWindow(const WindowOptions& look, const ViewerOptions& options, SharedView& shared,
                    const Restart& restart) {
    return ViewerWindow(look, options, shared, restart).run();
}

}  // namespace radlab

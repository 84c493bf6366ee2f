#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "display/Draw.h"
#include "display/PatchArrays.h"
#include "viewer/Simulation.h"
#include "viewer/ViewState.h"

namespace radlab {

/// Where a picture goes in the framebuffer, in pixels from the bottom left.
struct Place {
    int x = 0, y = 0, width = 1, height = 1;
};

/// What of a scene is drawn beside the state: the patch that was picked, and what it sees.
struct Picked {
    std::optional<std::size_t> patch;
    std::optional<PatchView> view;
};

/// Draws a simulation into the current framebuffer, a window's as well as any other; the same state gives the same picture.
///
/// @pre a GlContext is current, the same one for all calls
class SceneDrawing {
public:
    /// Takes the patches that are published now.
    void rebuild();

    /// Draws; all OpenGL state is put back afterwards.
    ///
    /// @param drawIds what draws in the mode of patch IDs: renderPatchIDs; called when the view has changed
    /// @cost  one pass over the patches, one draw
    void draw(const Simulation& simulation, const ViewState& state, const Picked& picked, const Place& place,
              const std::function<void()>& drawIds);

    /// The patch at a pixel of the picture, counted from its bottom left; nothing for background.
    std::optional<std::size_t> pick(const Simulation& simulation, const ViewState& state, const Place& place, int x,
                                    int y);

    /// The IDs of the last picture are no longer right: another function draws them.
    void forgetIds() { idKey.clear(); }

    /// How many errors OpenGL has had in all pictures.
    int glErrors() const { return errors; }

private:
    void color(const Simulation& simulation, const ViewState& state, const Picked& picked);
    void colorByRadiance(const Simulation& simulation, const ViewState& state);
    void showIds(const View& view, const Place& place, const std::function<void()>& drawIds);
    void showPatches(const ViewState& state, const Picked& picked);

    std::optional<PatchArrays> arrays;
    std::vector<std::uint8_t> idPixels;  // red, green, blue, alpha from the bottom
    int errors = 0;
    std::vector<float> idKey;  // of the view that they show
};

/// The exposure that pictures have: the state's, or one that suits the patches.
float exposureOf(const ViewState& state);

/// The picture of a state as SceneDrawing draws it, without a window.
Image drawnPicture(SceneDrawing& drawing, const Simulation& simulation, const ViewState& state, const Picked& picked,
                   int width, int height, const std::function<void()>& drawIds);

/// What lies in the current framebuffer at that place.
Image readPlace(const Place& place);

/// The false colour of unshot power: black at a ten-thousandth of the largest, pale at the largest. Ready for display.
glm::vec3 unshotColor(double power, double largest);

}  // namespace radlab

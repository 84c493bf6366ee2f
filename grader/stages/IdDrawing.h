#pragma once

#include <functional>

#include "grader/stages/IdRaster.h"
#include "grader/stages/Stage.h"

namespace radlab::grader {

/// A colour as a buffer of bytes holds it.
struct Shade {
    int red = 0, green = 0, blue = 0;
    bool sure = true;  ///< false where rounding decides

    double packed() const { return red * 65536.0 + green * 256.0 + blue; }
};

/// The byte that OpenGL makes of 0 to 1; sure is set to false where rounding decides.
int byteOf(double share, bool& sure);

/// The bytes of an ID, red the highest.
Shade shadeOf(std::uint32_t id);

/// What is drawn in place of the patches.
struct Drawn {
    State state;
    std::vector<int> owner;  ///< of each polygon drawn, the patch whose colour it has
};

/// A way to draw patches in colours; as it stands, the right one.
struct IdDrawing {
    std::function<Shade(const State&, int patch)> shade = [](const State&, int patch) {
        return shadeOf(static_cast<std::uint32_t>(patch) + 1);
    };
    RasterStyle style;
    Shade background;
    std::function<Drawn(const State&)> drawn;  ///< where it is not simply the patches
    bool viewKept = true;                      ///< false: the camera's matrix is lost, world coordinates are drawn
};

/// Draws; what has been rasterised once is kept for as long as the computation lives.
class IdDrawer {
public:
    IdDrawer();
    ~IdDrawer();

    Computation draws(const IdDrawing& drawing) const;

    /// With glBlendFunc(GL_ONE, GL_ONE): what is drawn over other patches is added to them.
    Computation addsUp(const RasterStyle& style) const;

private:
    struct Memory;
    std::shared_ptr<Memory> memory;
};

/// Only the outlines of patches, or only their corners, drawn as lines and points one pixel wide.
///
/// Which pixels next to them are drawn is left open.
Computation drawsOutlines(bool cornersOnly);

}  // namespace radlab::grader

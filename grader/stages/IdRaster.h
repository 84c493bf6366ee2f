#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "grader/protocol/State.h"
#include "grader/stages/ScreenPolygon.h"

namespace radlab::grader {

/// How patches are drawn: as they should be, or with one of the mistakes that drawing them invites.
struct RasterStyle {
    enum class Cull { none, back, front };  ///< front: counter-clockwise on screen
    enum class Corners {
        asTold,         ///< as many as MyPolygon::vertices says
        quadsOnly,      ///< triangles are not drawn
        trianglesOnly,  ///< quadrilaterals are not drawn
        firstThree,     ///< a quadrilateral loses its fourth corner
    };

    bool depthTest = true;  ///< GL_LESS; without it the patch drawn last is seen
    Cull cull = Cull::none;
    Corners corners = Corners::asTold;
    bool reverse = false;  ///< the last patch is drawn first

    /// GL_SUBPIXEL_BITS of the OpenGL that is compared with: 4 is the least allowed and holds for all; llvmpipe has 8,
    /// with which a tenth as many pixels are not sure.
    int subpixelBits = 4;
};

/// A picture of patch indices, with what is not sure about it. Pixel (x, y) is y·width + x, from the bottom left.
struct IdImage {
    int width = 0, height = 0;
    std::vector<int> patch;          ///< which patch each pixel shows, -1 for background
    std::vector<std::uint8_t> sure;  ///< whether every OpenGL shows that one
    std::vector<std::size_t> start;  ///< of each pixel's candidates, and their end
    std::vector<int> candidates;     ///< of pixels that are not sure, in no order

    /// The patches, and -1 for background, that an OpenGL may show where the pixel is not sure; none where it is.
    std::span<const int> candidatesOf(std::size_t pixel) const {
        return {candidates.data() + start[pixel], start[pixel + 1] - start[pixel]};
    }
};

/// For each pixel the patches whose fragments pass the depth test, for adding up colours that are blended.
struct LayerImage {
    int width = 0, height = 0;
    std::vector<std::uint8_t> sure;  ///< whether every OpenGL lets these pass and no others
    std::vector<std::size_t> start;  ///< of each pixel's patches, and their end
    std::vector<int> patches;        ///< in the order in which they are drawn

    std::span<const int> patchesOf(std::size_t pixel) const {
        return {patches.data() + start[pixel], start[pixel + 1] - start[pixel]};
    }
};

/// Draws patches as their indices, without OpenGL and in double precision.
///
/// A pixel shows what lies at its centre. It is not sure where its centre is so near the edge of a polygon that another
/// patch or the background may win it, or where another patch is so near in depth: two patches in one place are never
/// sure, unless one is culled. Edges of what is hidden do not matter. What "near" is, ScreenPolygon says.
///
/// @param views          drawn one after the other into one buffer, which is cleared once
/// @param width, height  of the buffer, in pixels
/// @pre   the views lie in the buffer; each patch has 3 or 4 corners, which are the state's
/// @return by patch index, width·height pixels
/// @cost  views times patches, plus the pixels of all polygons' boxes; 70,000 small patches on 512 x 512 pixels take
///        30 ms in one plane, 90 ms scattered
/// @source [CohenGreenberg1985] item buffer; [SutherlandHodgman1974] clipping
IdImage rasterIds(const State& state, std::span<const IdView> views, int width, int height,
                  const RasterStyle& style = {});

/// What each pixel lets pass where patches are blended with glBlendFunc(GL_ONE, GL_ONE).
///
/// With the depth test a fragment passes where it is nearer than all that were drawn before it; without, all pass.
///
/// @param views, width, height  as for rasterIds, which has the same conditions
/// @return by patch index, width·height pixels
/// @cost  that of rasterIds, plus one entry for each fragment that passes
LayerImage rasterLayers(const State& state, std::span<const IdView> views, int width, int height,
                        const RasterStyle& style = {});

}  // namespace radlab::grader

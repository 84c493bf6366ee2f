#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "course/Vec3f.h"

namespace radlab {
class Framebuffer;
}

/// Half a cube over a patch, onto whose faces the scene is drawn in patch IDs.
///
/// The five faces lie in one square buffer of rendersize = 2·size pixels each way: the top face in the middle square of
/// size x size, the four half faces of size x size/2 around it, corners unused. Pixel (0, 0) is at the bottom left; the
/// buffer's up is the up vector. A pixel at the rim of the buffer looks along the horizon of the patch.
///
/// @source [CohenGreenberg1985]
class Hemicube {
public:
    /// @param size edge of the top face in pixels, even and at least 2
    /// @pre   a GlContext is current, the same one for all calls
    /// Errors: an odd, too small or (for this OpenGL) too large size; no context.
    explicit Hemicube(int size);
    virtual ~Hemicube();
    Hemicube(const Hemicube&) = delete;
    Hemicube& operator=(const Hemicube&) = delete;

    /// Draws what is seen from eye into the five faces.
    ///
    /// draw is called once a face, with matrices, viewport and drawing state set for plain colours: no light, no smoothing,
    /// no culling, depth test on, background 0. All OpenGL state is put back afterwards, whatever draw does to it. The near
    /// plane lies at half the distance to the nearest of `polygons` in front, so that a patch that touches the shooter is
    /// drawn; without polygons, at 1e-3.
    ///
    /// @param eye        centre of the patch, in world coordinates
    /// @param up         any vector not along direction; what is up in the buffer
    /// @param direction  the patch's normal, of any length above 0
    /// Errors: up or direction zero, not finite or parallel; eye not finite; draw leaving a glBegin open.
    /// @cost five calls of draw
    virtual void renderScene(const Vec3f& eye, const Vec3f& up, const Vec3f& direction,
                             const std::function<void()>& draw);

    /// Reads the drawn IDs back, for getIndex.
    ///
    /// @cost rendersize² pixels
    virtual void readIndexBuffer();

    /// The ID that pixel (x, y) shows: index of the patch plus 1, or 0 for background.
    ///
    /// @pre x and y from 0 to rendersize - 1, else an Error
    int getIndex(int x, int y) const {
        const std::uint8_t* pixel = &pixels[4 * position(x, y)];
        return pixel[0] << 16 | pixel[1] << 8 | pixel[2];
    }

    /// The form factor of pixel (x, y): the share of the patch's power that leaves through it.
    ///
    /// Sampled at the pixel's centre, scaled so that the sum over all pixels is 1; 0 in the corners.
    ///
    /// @pre    x and y from 0 to rendersize - 1, else an Error
    /// @source [CohenGreenberg1985]
    float getDeltaFormFactor(int x, int y) const { return deltas[position(x, y)]; }

    const int rendersize;  ///< the buffer's edge in pixels, 2·size

private:
    std::size_t position(int x, int y) const {
        if (x < 0 || y < 0 || x >= rendersize || y >= rendersize) outside(x, y);
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(rendersize) + static_cast<std::size_t>(x);
    }
    [[noreturn]] void outside(int x, int y) const;

    std::unique_ptr<radlab::Framebuffer> framebuffer;
    std::vector<std::uint8_t> pixels;  // red, green, blue, alpha
    std::vector<float> deltas;
};

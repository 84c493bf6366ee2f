#pragma once

// What the files of exercises/extensions need: further stages, which are judged like the six but are worth no marks.

#include "base/Image.h"
#include "course/MirrorPass.h"
#include "course/PictureView.h"
#include "course/ProgRef.h"
#include "course/RandomNumbers.h"
#include "course/RayCaster.h"

/// Extension 1. Form factors from the brightest patch to every patch, by rays over the hemisphere.
///
/// Sends rays from the centre of the shooter, their directions drawn with the density cosθ/π: so every ray stands for
/// the same share of the power, 1/rays, and the form factor of a patch is the share of the rays that meet it. The
/// hemicube weights directions that it takes at equal steps; here the directions themselves are more where more light
/// goes.
///
/// @param scene   finds what a ray meets among `polygons`
/// @param rays    how many rays to send, > 0
/// @param random  where random numbers come from
/// @return the shooter s, or nullptr where there are no patches
/// @post   polygons[j]->formF = F(s→j), a whole number of rays over all rays: no unit, 0 to 1, right on average, with
///         the standard error √(F(1-F)/rays); in a closed scene they sum to 1; 0 for the shooter
/// @cost   linear in the number of rays
/// @source [Malley1988]; [CohenWallace1993, chapter 4]
MyPolygon* hemisphereFF(const RayCaster& scene, int rays, RandomNumbers& random);

/// Extension 2. A picture without steps at its edges: the mean of several samples in each pixel.
///
/// One sample at a pixel's centre shows either of two patches that meet in the pixel, so that edges become stairs. The
/// mean over the pixel shows both by the part of it that they cover. It is the mean of the light: radiance, before it
/// is cut off and bent for the screen.
///
/// @param view     tells the radiance at any point of the picture, and how it is shown
/// @param samples  along each side of a pixel, >= 1: samples² in each
/// @param picture  of the size wanted, whatever it holds; pixel (0, 0) is at the top left
/// @post  each pixel is cut into samples x samples squares, and shows the mean radiance at the centres of these, ready
///        for display
/// @cost  samples² calls of view.radiance a pixel
/// @source [Whitted1980]
void antialias(const PictureView& view, int samples, radlab::Image& picture);

/// Extension 3. Adds to a picture what a planar mirror in it shows, by a second pass.
///
/// A mirror shows a second world behind its plane, as far behind it as the scene is in front. So the scene is drawn
/// once more, carried into that world, for the same camera, and what came out is seen through the mirror as through a
/// window. One reflection is followed: a mirror that is seen in a mirror stays as the first pass drew it.
///
/// @param pass         says where the mirror is seen, and draws the second picture
/// @param point        of the mirror's plane
/// @param normal       of the plane, to the side that reflects; of any length above 0
/// @param reflectance  what share of the radiance is reflected, 0 to 1 per channel
/// @param picture      radiance out of the first pass: what the mirror's own surface sends is in it already
/// @post   pixels that show the mirror have reflectance times the radiance of the second picture added; all others are
///         as they were
/// @cost   one drawing of all patches
/// @source [Whitted1980]
void mirrorScene(const MirrorPass& pass, const Vec3f& point, const Vec3f& normal, const Vec3f& reflectance,
                 radlab::Image& picture);

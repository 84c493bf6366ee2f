#pragma once

// Everything that exercises/ProgRef.cpp needs: the data of the patches, vectors, the hemicube and OpenGL.

#ifndef _USE_MATH_DEFINES
#define _USE_MATH_DEFINES  // NOLINT(bugprone-reserved-identifier): for M_PI on Windows
#endif

#include <algorithm>
#include <cassert>
#include <cfloat>
#include <cmath>
#include <iostream>
#include <vector>

#include "base/Error.h"
#include "course/DataFormat.h"
#include "course/Hemicube.h"
#include "course/Vec3f.h"
#include "gl/OpenGL.h"

#ifndef M_PI
#define M_PI 3.14159265358979323846
#endif
#ifndef M_1_PI
#define M_1_PI 0.31830988618379067154
#endif

using radlab::NotImplemented;

/// Stage 1. The patch with the most unshot power: |ΔB| times area.
///
/// @return nullptr where there are no patches
/// @cost   linear in the number of patches
/// @source [Cohen1988]
MyPolygon* maxenergy_patch();

/// Stage 2. Form factors from the brightest patch to every patch, by the point to point formula.
///
/// Takes both patches as small against their distance, and sees nothing between them.
///
/// @return the shooter s, or nullptr where there are no patches
/// @post   polygons[j]->formF = F(s→j) = max(cosθs,0)·max(cosθj,0)·Aj/(π r²): no unit, >= 0, 0 for the shooter
/// @cost   linear in the number of patches
/// @source [CohenWallace1993, chapter 4]
MyPolygon* calcAnalyticalFF();

/// Stage 3. Shoots the unshot radiosity of maxP over all patches, by their form factors.
///
/// @pre    polygons[j]->formF = F(maxP→j)
/// @post   every other patch j has ΔBj = ρj·ΔBs·F(s→j)·As/Aj added to rad and unshot_rad; that of maxP is shot: 0
/// @return false where maxP is nullptr, else true
/// @cost   linear in the number of patches
/// @source [Cohen1988]
bool distributeEnergy(MyPolygon* maxP);

/// Stage 4. Turns radiosities into colours to display.
///
/// @post   polygons[i]->color = B/π, the radiance of patch i in W/(m² sr) per channel; vertices[k]->color the mean colour
///         of the patches that share vertex k, colorcount their number, rad their mean radiosity; 0 where none does
/// @cost   linear in the number of patches
/// @source [Gouraud1971]; [CohenWallace1993, chapter 9] nodal averaging
void colorReconstruction();

/// Stage 5. Draws every patch in the colour that is its ID, for Hemicube::getIndex.
///
/// Patch i has the ID i+1, red the high byte, green the middle one, blue the low one; 0 is background.
///
/// @pre    a GL context is current; matrices, viewport and drawing state are set
/// @cost   one drawing of all patches
void renderPatchIDs();

/// Stage 6. Form factors from the brightest patch to every patch, by hemicube.
///
/// Draws patch IDs around the centre of the shooter and adds up the delta form
/// factor of every pixel that sees a patch.
///
/// @pre    a GL context of at least rendersize x rendersize pixels is current
/// @return the shooter s, or nullptr where there are no patches
/// @post   polygons[i]->formF = F(s→i): no unit, >= 0, summing to 1 in a closed scene
///         up to the hemicube's resolution
/// @cost   five draws of all patches, rendersize² pixels read back
/// @source [CohenGreenberg1985] hemicube; [Cohen1988] shooting order
MyPolygon* calcFF(Hemicube* hemicube);

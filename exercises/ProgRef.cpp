// The exercise: six functions, to be written in this order. This is the one file that you edit.
//
// ProgRef.h brings all that you need: the global vectors `polygons` (the patches) and `vertices`, the types MyPolygon
// and MyVertex (see DataFormat.h for what each member means), Vec3f with dot, cross, length, sqr_length
// and normalize, the Hemicube, and OpenGL. Write helper functions of your own where they make things clearer.
//
// A function that is not written yet throws NotImplemented; take that line out when you begin.

#include "ProgRef.h"

// Stage 1. Return the patch with the most unshot power: the length of unshot_rad times area.
// Shooting the brightest patch first makes the picture good early. Return nullptr where there are no patches.
// You may call: length.
MyPolygon* maxenergy_patch() {
    // TODO stage 1
    throw NotImplemented("maxenergy_patch");
}

// Stage 2. Find the brightest patch s, set formF of every patch j to the form factor from s to j, and return s.
// Between two small patches at the distance r, with the angles θs and θj between their normals and the line
// that joins their centres, it is max(cos θs, 0) · max(cos θj, 0) · Aj / (π r²). A patch does not see itself: formF of s is
// 0. The formula knows nothing of what stands in between. Return nullptr where there are no patches.
// You may call: maxenergy_patch, dot, normalize, sqr_length; M_1_PI is 1/π.
MyPolygon* calcAnalyticalFF() {
    // TODO stage 2
    throw NotImplemented("calcAnalyticalFF");
}

// Stage 3. Shoot the unshot radiosity of maxP at every other patch j. What j reflects, in each colour channel, is
// its reflectance (diffuse) · unshot_rad of maxP · formF of j · area of maxP / area of j; add it to rad and to
// unshot_rad of j. Then nothing is left to shoot on maxP. Return false where maxP is nullptr, otherwise true.
// You may call: nothing is needed; Vec3f multiplies channel by channel.
bool distributeEnergy(MyPolygon* maxP) {
    // TODO stage 3
    (void)maxP;
    throw NotImplemented("distributeEnergy");
}

// Stage 4. Set the colour of every patch to its radiance, rad / π. That is all for flat shading.
// Then, for smooth shading, average at the vertices: for every vertex, color is the mean color of
// the patches that have it as a corner, rad their mean rad, and colorcount how many they are. The function is called
// again and again, so begin from zero each time; a vertex that no patch uses stays black.
// You may call: nothing is needed; patch->vertex[0 .. patch->vertices - 1] are indices into `vertices`.
void colorReconstruction() {
    // TODO stage 4
    throw NotImplemented("colorReconstruction");
}

// Stage 5. Draw every patch in a colour that is its ID, so that a pixel tells which patch it shows. The ID of
// polygons[i] is i + 1, since 0 is the background; red is its high byte, green the middle one, blue the low one. Camera
// and drawing state are set already: only draw.
// You may call: glBegin (GL_QUADS or GL_TRIANGLES), glColor3ub, glVertex3f, glEnd.
void renderPatchIDs() {
    // TODO stage 5
    throw NotImplemented("renderPatchIDs");
}

// Stage 6. Find the brightest patch s, set formF of every patch to the form factor from s, and return s, as in stage
// 2, but by hemicube, which sees what stands in between. Render the patch IDs from the centre of s along its
// normal, with an up vector that lies in the patch, and read the index buffer back. Then add the delta form factor of
// every pixel of the hemicube to the patch that the pixel shows. Return nullptr where there are no patches.
// You may call: maxenergy_patch, renderPatchIDs, and the members of hemicube: rendersize, renderScene,
// readIndexBuffer, getIndex, getDeltaFormFactor.
MyPolygon* calcFF(Hemicube* hemicube) {
    // TODO stage 6
    (void)hemicube;
    throw NotImplemented("calcFF");
}

#pragma once

#include <vector>

#include "course/Vec3f.h"

/// A corner of patches: the patches of one face share their corners, patches of different faces do not.
struct MyVertex {
    Vec3f position{0.0f};

    // For nodal averaging.
    int colorcount = 0;  ///< how many patches have this vertex as a corner
    Vec3f color{0.0f};   ///< mean radiance of those patches, W/(m² sr) per channel
    Vec3f rad{0.0f};     ///< mean radiosity of those patches, W/m² per channel
};

/// A patch: a planar quadrilateral or triangle that is taken to have one radiosity all over.
struct MyPolygon {
    int vertices = 0;                  ///< how many corners: 3 or 4
    int vertex[4] = {-1, -1, -1, -1};  ///< indices into the global `vertices`, counter-clockwise seen from the front
    Vec3f diffuse{0.0f};               ///< reflectance ρ, 0 to 1 per channel
    Vec3f emissive{0.0f};              ///< radiosity that the patch emits by itself, E in W/m² per channel
    Vec3f normal{0.0f};                ///< unit normal, pointing to the side that emits and reflects
    Vec3f center{0.0f};                ///< centroid of the area
    float area = 0.0f;                 ///< A, in squared units of the scene
    float formF = 0.0f;                ///< form factor from the shooter to this patch, F(s→j), 0 to 1

    Vec3f rad{0.0f};         ///< radiosity B found so far, W/m² per channel
    Vec3f unshot_rad{0.0f};  ///< the part of B that has not been shot yet, W/m² per channel
    Vec3f color{0.0f};       ///< radiance B/π to display, W/(m² sr) per channel
};

/// The patches and vertices of the scene at hand, owned by the radlab::PatchMesh that is published.
extern std::vector<MyPolygon*> polygons;
extern std::vector<MyVertex*> vertices;

#pragma once

#include <vector>

#include "course/PatchMesh.h"
#include "engine/Polygon.h"
#include "engine/Radiosity.h"
#include "scene/Effects.h"
#include "scene/Scene.h"

namespace radlab::engine {

/// What a material does with the light that arrives: shares per channel.
///
/// A share passes straight on, at fronts and backs alike. Of the rest, fronts reflect a part diffusely and a part about
/// the mirror direction; backs swallow it. Fronts alone emit.
struct Scattering {
    Point emission{0.0};    ///< E in W/m², >= 0
    Point diffuse{0.0};     ///< of all that arrives at the front
    Point specular{0.0};    ///< of all that arrives at the front
    double through = 0.0;   ///< passes straight on
    double exponent = 0.0;  ///< of the specular lobe
    bool mirror = false;    ///< the lobe is the mirror direction alone

    bool isSpecular() const { return specular != Point(0.0); }
    bool isMatt() const { return through == 0.0 && !isSpecular(); }
};

/// The scattering of a material: transparency t passes on, (1 - t)·ρ is reflected diffusely, (1 - t)·ks specularly.
///
/// Where ρ + ks is more than 1, ks is cut to 1 - ρ. A shininess of 1 is a perfect mirror, less the lobe of exponent
/// 128·shininess.
Scattering scatteringOf(const Material& material);

/// The scattering of each face of a scene.
std::vector<Scattering> scatteringsOf(const Scene& scene);

/// The same without the effects that are off: no face then is specular, or none transparent.
std::vector<Scattering> scatteringsOf(const Scene& scene, const Effects& effects);

/// The share that each face lets through, as Geometry::through has it: empty where all are opaque.
std::vector<double> throughOf(const std::vector<Scattering>& scatterings);

/// The surfaces of a mesh's patches, for the scatterings of its faces: what passes straight on is not reflected.
Surfaces surfacesOf(const PatchMesh& mesh, const std::vector<Scattering>& scatterings);

/// The larger of the three channels.
inline double largest(const Point& color) { return std::max({color.r, color.g, color.b}); }

/// A direction about a unit normal for two numbers from 0 to 1: where these are spread evenly, its density is cosθ/π.
Point cosineDirection(const Point& normal, double u, double v);

/// Where a mirror sends a direction.
Point mirrored(const Point& direction, const Point& normal);

struct LobeDirection {
    Point direction;
    double weight;  ///< of the light that arrives from there, times ks; 0 under the surface
};

/// A direction of the reciprocal Phong lobe for two numbers from 0 to 1, drawn about the mirror direction.
///
/// The lobe is ks·(n + 2)/(2π)·cosⁿα, α being the angle to the mirror direction: light that arrives along the normal is
/// reflected with the share ks, light that grazes with less.
///
/// @param direction  of a unit of light on its way to the front
/// @source [LafortuneWillems1994]
LobeDirection lobeDirection(const Point& direction, const Point& normal, double exponent, double u, double v);

/// What a surface reflects of light from a direction.
struct Reflection {
    double value;    ///< reflected radiance by arriving radiance and solid angle, at a share of 1; 0 under the surface
    double density;  ///< with which that direction is drawn, by solid angle
};

/// Of light from a direction that leaves the surface: cosθ/π, drawn by cosineDirection.
Reflection diffuseReflection(const Point& normal, const Point& towards);

/// Of light from a direction that leaves the surface: the lobe, drawn by lobeDirection.
Reflection lobeReflection(const Point& direction, const Point& normal, double exponent, const Point& towards);

}  // namespace radlab::engine

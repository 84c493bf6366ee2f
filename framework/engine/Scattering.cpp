#include "engine/Scattering.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "course/FacePolygon.h"

namespace radlab::engine {

namespace {

constexpr double largestExponent = 128.0;  // of X3D's shininess 1

Point around(const Point& axis, double cosine, double turn) {
    const double sine = std::sqrt(std::max(0.0, 1.0 - cosine * cosine)), angle = 2.0 * std::numbers::pi * turn;
    const Point x = glm::normalize(glm::cross(axisAcross(axis), axis)), y = glm::cross(axis, x);
    return sine * std::cos(angle) * x + sine * std::sin(angle) * y + cosine * axis;
}

double lobeWeight(const Point& normal, double exponent, const Point& towards) {
    return (exponent + 2.0) / (exponent + 1.0) * std::max(0.0, glm::dot(normal, towards));
}

}  // namespace

Scattering scatteringOf(const Material& material) {
    const double transparency = static_cast<double>(material.transparency), rest = 1.0 - transparency;
    const Point diffuse(material.diffuse), specular(material.specular);
    Scattering made;
    made.emission = Point(material.emissive);
    made.diffuse = rest * diffuse;
    made.specular = rest * glm::clamp(specular, Point(0.0), glm::max(Point(0.0), 1.0 - diffuse));
    made.through = transparency;
    made.exponent = largestExponent * static_cast<double>(material.shininess);
    made.mirror = material.shininess >= 1.0f;
    return made;
}

std::vector<Scattering> scatteringsOf(const Scene& scene) {
    std::vector<Scattering> scatterings;
    for (const Face& face : scene.faces) scatterings.push_back(scatteringOf(*face.material));
    return scatterings;
}

std::vector<Scattering> scatteringsOf(const Scene& scene, const Effects& effects) {
    std::vector<Scattering> scatterings;
    for (const Face& face : scene.faces) {
        Material material = *face.material;
        if (!effects.has(Effect::specular)) material.specular = Vec3f(0.0f);
        if (!effects.has(Effect::transparency)) material.transparency = 0.0f;
        scatterings.push_back(scatteringOf(material));
    }
    return scatterings;
}

std::vector<double> throughOf(const std::vector<Scattering>& scatterings) {
    const auto letsThrough = [](const Scattering& scattering) { return scattering.through > 0.0; };
    if (std::none_of(scatterings.begin(), scatterings.end(), letsThrough)) return {};
    std::vector<double> through;
    for (const Scattering& scattering : scatterings) through.push_back(scattering.through);
    return through;
}

Surfaces surfacesOf(const PatchMesh& mesh, const std::vector<Scattering>& scatterings) {
    Surfaces surfaces;
    for (const int face : mesh.faceOf) {
        const Scattering& scattering = scatterings[static_cast<std::size_t>(face)];
        surfaces.emission.push_back(scattering.emission);
        surfaces.reflectance.push_back(scattering.diffuse);
    }
    return surfaces;
}

Point cosineDirection(const Point& normal, double u, double v) { return around(normal, std::sqrt(1.0 - u), v); }

Point mirrored(const Point& direction, const Point& normal) {
    return direction - 2.0 * glm::dot(direction, normal) * normal;
}

LobeDirection lobeDirection(const Point& direction, const Point& normal, double exponent, double u, double v) {
    const Point sent = around(mirrored(direction, normal), std::pow(1.0 - u, 1.0 / (exponent + 1.0)), v);
    return {sent, lobeWeight(normal, exponent, sent)};
}

Reflection diffuseReflection(const Point& normal, const Point& towards) {
    const double value = std::max(0.0, glm::dot(normal, towards)) * std::numbers::inv_pi;
    return {value, value};
}

Reflection lobeReflection(const Point& direction, const Point& normal, double exponent, const Point& towards) {
    const double cosine = glm::dot(mirrored(direction, normal), towards);
    if (cosine <= 0.0) return {0.0, 0.0};
    const double density = (exponent + 1.0) * 0.5 * std::numbers::inv_pi * std::pow(cosine, exponent);
    return {density * lobeWeight(normal, exponent, towards), density};
}

}  // namespace radlab::engine

#include "engine/Geometry.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/Interrupts.h"

namespace radlab::engine {

namespace {

std::vector<Polygon> facesOf(const Scene& scene) {
    std::vector<Polygon> faces;
    for (const Face& face : scene.faces) {
        Interrupts::check();
        std::vector<Point> corners;
        for (const int corner : face.corners) corners.emplace_back(scene.vertices[static_cast<std::size_t>(corner)]);
        faces.emplace_back(std::move(corners));
    }
    return faces;
}

}  // namespace

double patchSizeFor(const Scene& scene, double patches) {
    double area = 0.0;
    for (const Polygon& face : facesOf(scene)) area += face.area;
    return std::sqrt(area / patches);
}

double patchesAt(const Scene& scene, double patchSize, double lightSize) {
    const std::vector<Polygon> faces = facesOf(scene);
    double patches = 0.0;
    for (std::size_t i = 0; i < faces.size(); ++i) {
        const double size = scene.faces[i].material->emits() ? lightSize : patchSize;
        patches += std::max(faces[i].area / (size * size), 1.0);
    }
    return patches;
}

std::vector<double> areasOf(const Geometry& geometry) {
    std::vector<double> areas;
    for (const Polygon& patch : geometry.patches) areas.push_back(patch.area);
    return areas;
}

Geometry geometryOf(const Scene& scene, const PatchMesh& mesh) {
    Geometry geometry;
    geometry.faces = facesOf(scene);
    for (const MyPolygon& patch : mesh.patches) {
        Interrupts::check();
        std::vector<Point> corners;
        for (int i = 0; i < patch.vertices; ++i)
            corners.emplace_back(mesh.corners[static_cast<std::size_t>(patch.vertex[i])].position);
        geometry.patches.emplace_back(std::move(corners));
    }
    geometry.faceOf.assign(mesh.faceOf.begin(), mesh.faceOf.end());
    return geometry;
}

Geometry geometryOf(const Scene& scene) {
    Geometry geometry;
    geometry.faces = geometry.patches = facesOf(scene);
    geometry.faceOf.resize(geometry.faces.size());
    std::iota(geometry.faceOf.begin(), geometry.faceOf.end(), std::size_t{0});
    return geometry;
}

}  // namespace radlab::engine

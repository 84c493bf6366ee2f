#include "course/PatchMesh.h"

#include "base/Error.h"
#include "course/Mesher.h"

std::vector<MyPolygon*> polygons;
std::vector<MyVertex*> vertices;

namespace radlab {

namespace {

const PatchMesh* published = nullptr;

}  // namespace

PatchMesh::PatchMesh(const std::vector<Vec3f>& positions, const std::vector<Face>& faces, float patchSize,
                     float lightSize) {
    faceOf = Mesher::mesh(positions, faces, corners, patches, patchSize, lightSize);
    if (patches.empty())
        throw Error(faces.empty() ? Location{} : faces.front().where,
                    "nothing to light: no face has any area, expected at least one");
}

PatchMesh::~PatchMesh() {
    if (published != this) return;
    polygons.clear();
    vertices.clear();
    published = nullptr;
}

void PatchMesh::publish() {
    if (patches.size() > mostPatches)
        throw Error("too many patches for 24-bit patch IDs: found " + std::to_string(patches.size()) +
                    ", expected at most " + std::to_string(mostPatches) + "; take a larger patch size");
    polygons.clear();
    vertices.clear();
    for (MyPolygon& patch : patches) polygons.push_back(&patch);
    for (MyVertex& corner : corners) vertices.push_back(&corner);
    published = this;
}

void PatchMesh::reset() {
    for (MyPolygon& patch : patches) {
        patch.rad = patch.unshot_rad = patch.emissive;
        patch.color = Vec3f(0.0f);
        patch.formF = 0.0f;
    }
    for (MyVertex& corner : corners) {
        corner.color = corner.rad = Vec3f(0.0f);
        corner.colorcount = 0;
    }
}

}  // namespace radlab

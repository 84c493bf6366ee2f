#include "display/RayMirrorPass.h"

#include "course/RayCaster.h"
#include "display/RayView.h"

namespace radlab {

namespace {

using Outline = std::vector<glm::dvec4>;

const glm::vec4 everything(0.0f, 0.0f, 0.0f, 1.0f);

// What lies on the kept side of a plane.
Outline clipped(const Outline& outline, const glm::dvec4& plane) {
    Outline kept;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const glm::dvec4 &here = outline[i], &next = outline[(i + 1) % outline.size()];
        const double a = glm::dot(plane, here), b = glm::dot(plane, next);
        if (a >= 0.0) kept.push_back(here);
        if ((a >= 0.0) != (b >= 0.0)) kept.push_back(here + (next - here) * (a / (a - b)));
    }
    return kept;
}

// The patches as they are drawn: triangles, each with the patch that it is a part of.
struct Carried {
    std::vector<MyPolygon> patches;
    std::vector<MyVertex> corners;
    std::vector<const MyPolygon*> of;

    void add(const MyPolygon* patch, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
        MyPolygon part;
        part.vertices = 3;
        part.color = patch->color;
        for (const glm::dvec3& place : {a, b, c}) {
            part.vertex[corners.size() % 3] = static_cast<int>(corners.size());
            corners.push_back({Vec3f(place)});
        }
        patches.push_back(part);
        of.push_back(patch);
    }
};

template <class Item>
std::vector<Item*> pointersTo(std::vector<Item>& items) {
    std::vector<Item*> pointers;
    for (Item& item : items) pointers.push_back(&item);
    return pointers;
}

// Where a camera in perspective stands: the one point that no depth moves in the picture.
glm::dvec3 eyeOf(const glm::mat4& camera) {
    const glm::dvec4 eye = glm::inverse(glm::dmat4(camera)) * glm::dvec4(0.0, 0.0, 1.0, 0.0);
    return glm::dvec3(eye) / eye.w;
}

class Drawing {
public:
    Drawing(const glm::mat4& seenBy, const glm::mat4& carry, const glm::vec4& plane, bool clockwiseFronts)
        : eye(eyeOf(seenBy)), world(carry), clip(plane), side(clockwiseFronts ? -1.0 : 1.0) {}

    void add(const MyPolygon* patch, const std::vector<MyVertex*>& corners) {
        Outline outline;
        for (int k = 0; k < patch->vertices; ++k)
            outline.emplace_back(glm::dvec3(corners[static_cast<std::size_t>(patch->vertex[k])]->position), 1.0);
        std::vector<glm::dvec3> places;
        for (const glm::dvec4& corner : clipped(outline, clip)) {
            const glm::dvec4 at = world * corner;
            places.push_back(glm::dvec3(at) / at.w);
        }
        for (std::size_t k = 1; k + 1 < places.size(); ++k) {
            const glm::dvec3 normal = glm::cross(places[k] - places[0], places[k + 1] - places[0]);
            if (side * glm::dot(normal, eye - places[0]) > 0.0) carried.add(patch, places[0], places[k], places[k + 1]);
        }
    }

    Carried carried;

private:
    glm::dvec3 eye;
    glm::dmat4 world;
    glm::dvec4 clip;
    double side;
};

}  // namespace

RayMirrorPass::RayMirrorPass(const std::vector<MyPolygon*>& patches, const std::vector<MyVertex*>& corners,
                             IsMirror isMirror, const glm::mat4& clipFromWorld, int columns, int rows)
    : polygons(patches), vertices(corners), camera(clipFromWorld), width(columns), height(rows) {
    Drawing drawing(camera, glm::mat4(1.0f), everything, false);
    for (const MyPolygon* patch : polygons) drawing.add(patch, vertices);
    Carried& carried = drawing.carried;
    const RayCaster caster(pointersTo(carried.patches), pointersTo(carried.corners));
    const RayView view(caster, camera, width, height, 1.0f);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const MyPolygon* part = view.patchAt(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
            mirror.push_back(part && isMirror(carried.of[static_cast<std::size_t>(part - carried.patches.data())]));
        }
}

bool RayMirrorPass::showsMirror(int x, int y) const {
    return mirror.at(static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x));
}

Image RayMirrorPass::draw(const glm::mat4& world, const glm::vec4& clip, bool clockwise) const {
    return drawAt(Vec3f(0.5f), world, clip, clockwise);
}

Image RayMirrorPass::drawAt(const Vec3f& inPixel, const glm::mat4& world, const glm::vec4& clip, bool clockwise) const {
    Drawing drawing(camera, world, clip, clockwise);
    for (const MyPolygon* patch : polygons) drawing.add(patch, vertices);
    const RayCaster caster(pointersTo(drawing.carried.patches), pointersTo(drawing.carried.corners));
    const RayView view(caster, camera, width, height, 1.0f);
    Image picture(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            picture.at(x, y) = view.radiance(static_cast<float>(x) + inPixel.x, static_cast<float>(y) + inPixel.y);
    return picture;
}

Image RayMirrorPass::first() const { return draw(glm::mat4(1.0f), everything, false); }

}  // namespace radlab

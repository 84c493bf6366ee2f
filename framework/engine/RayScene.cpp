#include "engine/RayScene.h"

#include <algorithm>
#include <cmath>

#include "base/Error.h"
#include "engine/Embree.h"
#include "engine/Triangles.h"

namespace radlab::engine {

namespace {

constexpr double startsOff =
    1e-6;  // of the scene's radius: below that, floats cannot tell a surface from its neighbour

// What a filter is told beside Embree's own; the context comes first, so that a pointer to it is a pointer to this.
struct Passing {
    embree::Context context;
    const std::size_t* polygonOf;
    std::size_t first, second;  // polygons that the ray passes through
    const Plane* planes = nullptr;
    Point from{0.0};
    double near = 0.0;  // up to here doubles decide, where floats cannot: a ray that starts in a plane does not meet it
    const Point* towards = nullptr;      // given where only fronts stop the ray: its direction
    const double* through = nullptr;     // given where polygons let a share of the light pass:
    double share = 1.0;                  // what is left of it,
    std::size_t pane = RayHit::nothing;  // and the last that it passed, which the ray may meet twice at an inner edge
};

bool startsInPlane(const Passing& passing, std::size_t polygon) {
    const Plane& plane = passing.planes[polygon];
    return heightOver(passing.from, plane.on, plane.normal) == 0.0;
}

bool meetsBack(const Passing& passing, std::size_t polygon) {
    return passing.towards && glm::dot(*passing.towards, passing.planes[polygon].normal) >= 0.0;
}

bool isPassedThrough(Passing& passing, std::size_t polygon) {
    if (!(passing.through[polygon] > 0.0)) return false;
    if (polygon != passing.pane) passing.share *= passing.through[polygon];
    passing.pane = polygon;
    return true;
}

void passThrough(const RTCFilterFunctionNArguments* arguments) {
    auto* passing = reinterpret_cast<Passing*>(arguments->context);
    const std::size_t polygon = passing->polygonOf[RTCHitN_primID(arguments->hit, arguments->N, 0)];
    if (polygon == passing->first || polygon == passing->second || meetsBack(*passing, polygon))
        arguments->valid[0] = 0;
    const double distance = double(RTCRayN_tfar(arguments->ray, arguments->N, 0));
    if (passing->planes && distance < passing->near && startsInPlane(*passing, polygon)) arguments->valid[0] = 0;
    if (passing->through && arguments->valid[0] != 0 && isPassedThrough(*passing, polygon)) arguments->valid[0] = 0;
}

RTCRay rayFrom(const Point& from, const Point& direction, double nearest, double farthest) {
    RTCRay ray{};
    ray.org_x = static_cast<float>(from.x);
    ray.org_y = static_cast<float>(from.y);
    ray.org_z = static_cast<float>(from.z);
    ray.dir_x = static_cast<float>(direction.x);
    ray.dir_y = static_cast<float>(direction.y);
    ray.dir_z = static_cast<float>(direction.z);
    ray.tnear = static_cast<float>(nearest);
    ray.tfar = static_cast<float>(farthest);
    ray.mask = ~0u;
    return ray;
}

}  // namespace

struct RayScene::Tree {
    RTCDevice device = rtcNewDevice(nullptr);
    RTCScene scene = rtcNewScene(device);
    double offset = 0.0;  // how far from its start a ray looks for hits

    ~Tree() {
        rtcReleaseScene(scene);
        rtcReleaseDevice(device);
    }
    Tree() = default;
    Tree(const Tree&) = delete;
    Tree& operator=(const Tree&) = delete;

    void build(const std::vector<Triangle>& triangles, const Point& middle) {
        RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
        const std::size_t count = triangles.size();
        auto* corner = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0,
                                                                   RTC_FORMAT_FLOAT3, 3 * sizeof(float), 3 * count));
        auto* index = static_cast<unsigned*>(
            rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(unsigned), count));
        if (count > 0 && (!corner || !index)) throw Error("Embree found no memory for the scene's triangles");
        unsigned next = 0;
        for (const Triangle& triangle : triangles)
            for (const Point& point : triangle) {
                for (int axis = 0; axis < 3; ++axis) *corner++ = static_cast<float>(point[axis] - middle[axis]);
                *index++ = next++;
            }
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene, geometry);
        rtcReleaseGeometry(geometry);
        // Without it, one ray in eight slips through between two triangles that share an edge.
        rtcSetSceneFlags(scene, static_cast<RTCSceneFlags>(RTC_SCENE_FLAG_ROBUST | embree::filterOfEachRay));
        rtcCommitScene(scene);
    }

    Passing passing(const std::vector<std::size_t>& owners, std::size_t first, std::size_t second) const {
        return {{}, owners.data(), first, second, nullptr, Point(0.0), 0.0};
    }

    bool stops(const Point& from, const Point& between, Passing& passing) const {
        const double near = offset / glm::length(between);
        if (!(near < 0.5)) return false;
        RTCRay ray = rayFrom(from, between, near, 1.0 - near);
        embree::occlude(scene, passing.context, passThrough, ray);
        return ray.tfar < 0.0f;
    }
};

RayScene::RayScene(const std::vector<Polygon>& list) : tree(std::make_unique<Tree>()) {
    std::vector<Triangle> triangles;
    Point low(0.0), high(0.0);
    for (const Polygon& polygon : list) planes.push_back({polygon.center, polygon.normal});
    for (std::size_t i = 0; i < list.size(); ++i)
        for (const Triangle& triangle : trianglesOf(list[i])) {
            for (const Point& point : triangle) {
                low = triangles.empty() ? point : glm::min(low, point);
                high = triangles.empty() ? point : glm::max(high, point);
            }
            triangles.push_back(triangle);
            polygonOf.push_back(i);
        }
    origin = 0.5 * (low + high);
    tree->offset = startsOff * 0.5 * glm::length(high - low);
    tree->build(triangles, origin);
}

RayScene::~RayScene() = default;

bool RayScene::hides(const Point& from, const Point& to, std::size_t first, std::size_t second) const {
    traced.fetch_add(1, std::memory_order_relaxed);
    Passing passing = tree->passing(polygonOf, first, second);
    return tree->stops(from - origin, to - from, passing);
}

double RayScene::transmittance(const Point& from, const Point& to, std::size_t first, std::size_t second,
                               const std::vector<double>& through) const {
    if (through.empty()) return hides(from, to, first, second) ? 0.0 : 1.0;
    traced.fetch_add(1, std::memory_order_relaxed);
    Passing passing = tree->passing(polygonOf, first, second);
    passing.through = through.data();
    return tree->stops(from - origin, to - from, passing) ? 0.0 : passing.share;
}

RayHit RayScene::meet(const Point& from, const Point& direction, std::size_t start, Sides sides) const {
    RTCRayHit hit{};
    hit.ray = rayFrom(from - origin, direction, 0.0, 1e30);
    hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    Passing passing = tree->passing(polygonOf, start, start);
    passing.planes = planes.data();
    passing.from = from;
    passing.near = tree->offset / glm::length(direction);
    if (sides == Sides::fronts) passing.towards = &direction;
    traced.fetch_add(1, std::memory_order_relaxed);
    embree::intersect(tree->scene, passing.context, passThrough, hit);
    if (hit.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
    return {polygonOf[hit.hit.primID], double(hit.ray.tfar)};
}

}  // namespace radlab::engine

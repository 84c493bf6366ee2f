#include "course/RayCaster.h"

#include <doctest/doctest.h>

#include "course/PatchMesh.h"
#include "course/RandomNumbers.h"
#include "course/TestMeshes.h"

namespace {

Vec3f directionFrom(RandomNumbers& random) {
    for (;;) {
        const Vec3f v(2 * random.next() - 1, 2 * random.next() - 1, 2 * random.next() - 1);
        if (sqr_length(v) > 0.01f && sqr_length(v) < 1.0f) return normalize(v);
    }
}

// Where the ray meets the patch's plane.
double distanceTo(const MyPolygon* patch, const Vec3f& origin, const Vec3f& direction) {
    const glm::dvec3 normal(patch->normal);
    return glm::dot(glm::dvec3(patch->center - origin), normal) / glm::dot(glm::dvec3(direction), normal);
}

// The nearest of the patches that a ray meets where they are alone.
MyPolygon* nearestAlone(const std::vector<RayCaster>& alone, const Vec3f& origin, const Vec3f& direction) {
    MyPolygon* nearest = nullptr;
    for (const RayCaster& caster : alone)
        if (MyPolygon* patch = caster.hit(origin, direction))
            if (!nearest || distanceTo(patch, origin, direction) < distanceTo(nearest, origin, direction))
                nearest = patch;
    return nearest;
}

}  // namespace

TEST_CASE("a ray inside a closed room meets the wall that it leaves the room's box through, and never slips out") {
    radlab::test::Faces room;
    const Vec3f high(3.0f, 2.0f, 5.0f);
    room.addRoom(Vec3f(0.0f), high, radlab::test::material(Vec3f(0.5f)));
    const auto mesh = room.mesh(0.37f);
    mesh->publish();
    const RayCaster caster(polygons, vertices);
    RandomNumbers random(1);
    for (int i = 0; i < 20000; ++i) {
        const Vec3f origin = high * Vec3f(random.next(), random.next(), random.next()) * 0.98f + 0.01f,
                    direction = directionFrom(random);
        const MyPolygon* patch = caster.hit(origin, direction);
        REQUIRE(patch);
        const double distance = distanceTo(patch, origin, direction);
        const glm::dvec3 end = glm::dvec3(origin) + distance * glm::dvec3(direction);
        REQUIRE(distance > 0.0);
        for (int axis = 0; axis < 3; ++axis) {
            REQUIRE(end[axis] >= -1e-5);
            REQUIRE(end[axis] <= static_cast<double>(high[axis]) + 1e-5);
        }
    }
}

TEST_CASE("of many patches, a ray meets the nearest of those that it meets where they are alone") {
    radlab::test::Faces crowd;
    RandomNumbers random(2);
    const auto coordinate = [&] { return 10.0f * random.next(); };
    for (int i = 0; i < 60; ++i) {
        const Vec3f corner(coordinate(), coordinate(), coordinate());
        crowd.add({corner, corner + 2.0f * directionFrom(random), corner + 3.0f * directionFrom(random)});
    }
    const auto mesh = crowd.mesh(1.0f);
    mesh->publish();
    const RayCaster caster(polygons, vertices);
    std::vector<RayCaster> alone;
    for (MyPolygon* patch : polygons) alone.push_back(RayCaster({patch}, vertices));
    int met = 0;
    for (int i = 0; i < 2000; ++i) {
        const Vec3f origin(coordinate(), coordinate(), coordinate()), direction = directionFrom(random);
        const MyPolygon* expected = nearestAlone(alone, origin, direction);
        CHECK(caster.hit(origin, direction) == expected);
        CHECK(caster.hit(origin, 100.0f * direction) == expected);
        met += expected != nullptr;
    }
    CHECK(met > 300);
}

TEST_CASE("a ray that starts on a patch meets it, unless it is named; then its back is not in the way either") {
    radlab::test::Faces sheets;
    sheets.add(radlab::test::square(0.0f, true));
    sheets.add(radlab::test::square(0.0f, false));
    sheets.add(radlab::test::square(1.0f, false));
    const auto mesh = sheets.mesh(2.0f);
    mesh->publish();
    REQUIRE(polygons.size() == 3);
    const RayCaster caster(polygons, vertices);
    const Vec3f center(0.5f, 0.5f, 0.0f), up(0.1f, 0.2f, 1.0f);
    CHECK(caster.hit(center, up) != polygons[2]);
    CHECK(caster.hit(center, up) != nullptr);
    CHECK(caster.hit(center, up, polygons[0]) == polygons[2]);
    CHECK(caster.hit(center, -up, polygons[0]) == nullptr);
}

TEST_CASE("among no patches, a ray meets nothing") {
    CHECK(RayCaster({}, {}).hit(Vec3f(0.0f), Vec3f(1.0f, 0.0f, 0.0f)) == nullptr);
}

TEST_CASE("a direction that is none meets nothing") {
    radlab::test::Faces room;
    room.addRoom(Vec3f(0.0f), Vec3f(1.0f), radlab::test::material(Vec3f(0.5f)));
    const auto mesh = room.mesh(1.0f);
    mesh->publish();
    const RayCaster caster(polygons, vertices);
    CHECK(caster.hit(Vec3f(0.5f), Vec3f(0.0f)) == nullptr);
    CHECK(caster.hit(Vec3f(0.5f), Vec3f(NAN, 0.0f, 1.0f)) == nullptr);
}

TEST_CASE("random numbers lie in 0 to 1, spread evenly, and are the same for the same seed") {
    RandomNumbers random(7), again(7), other(8);
    double sum = 0.0;
    int same = 0;
    for (int i = 0; i < 10000; ++i) {
        const float number = random.next();
        REQUIRE(number >= 0.0f);
        REQUIRE(number < 1.0f);
        REQUIRE(again.next() == number);
        same += other.next() == number;
        sum += static_cast<double>(number);
    }
    CHECK(sum / 10000 == doctest::Approx(0.5).epsilon(0.02));
    CHECK(same < 10);
}

#include "course/ViewDepth.h"

#include <random>

#include <doctest/doctest.h>

#include "course/TestMeshes.h"

using namespace radlab;
using namespace radlab::test;

TEST_CASE("far from the origin, the shooter's own plane does not pull the near plane to the eye") {
    std::mt19937 random(3);
    std::uniform_real_distribution<float> share(-1.0f, 1.0f);
    for (int i = 0; i < 2000; ++i) {
        const Vec3f place = 100.0f * Vec3f(share(random), share(random), share(random));
        const Vec3f normal = glm::normalize(Vec3f(share(random), share(random), 1.5f));
        const Vec3f right = glm::normalize(glm::cross(normal, Vec3f(1, 0, 0))), up = glm::cross(normal, right);
        Faces faces;
        for (const float height : {0.0f, 2.0f}) {
            const Vec3f c = place + height * normal, r = 0.03f * right, u = 0.03f * up;
            faces.add({c - r - u, c + r - u, c + r + u, c - r + u});
        }
        const auto mesh = faces.mesh(1.0f);
        mesh->publish();
        const ViewDepth depth =
            viewDepth(polygons, vertices, glm::dvec3(polygons[0]->center), glm::dvec3(polygons[0]->normal));
        REQUIRE(depth.nearest == doctest::Approx(1.0).epsilon(1e-3));
    }
}

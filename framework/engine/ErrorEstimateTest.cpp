#include "engine/ErrorEstimate.h"

#include <cmath>

#include <doctest/doctest.h>
#include <tbb/global_control.h>

#include "engine/FormFactors.h"
#include "engine/HierarchicalRadiosity.h"
#include "engine/MeshError.h"
#include "engine/SceneTestHelp.h"
#include "engine/SpecularTransport.h"

using namespace radlab;
using namespace radlab::engine;
using doctest::Approx;

namespace {

std::vector<Point> solved(const CutScene& cut, Method method, std::size_t rays) {
    FormFactorOptions options;
    options.method = method;
    options.rays = rays;
    FormFactorMatrix matrix = formFactors(cut.geometry, options);
    makeReciprocal(matrix);
    return solveRadiosity(matrix, cut.surfaces);
}

std::vector<Point> linked(const CutScene& cut, double threshold) {
    HierarchicalOptions options;
    options.threshold = threshold;
    return solveHierarchical(cut.geometry, cut.surfaces, options);
}

}  // namespace

TEST_CASE("the estimated error is the true one within a factor of 1.6, for links and for rays") {
    for (const auto& room : {std::pair{"cornell_2.x3d", 60.0}, std::pair{"l_room.x3d", 0.5}}) {
        CAPTURE(room.first);
        const CutScene cut(room.first, room.second);
        const std::vector<Point> truth = solved(cut, Method::visibility, 256);
        const auto holds = [&](const std::vector<Point>& found) {
            const double error = cut.relativeError(found, truth);
            const double estimate = estimateError(cut.geometry, cut.surfaces, found);
            CAPTURE(error);
            CHECK(estimate > error / 1.6);
            CHECK(estimate < error * 1.6);
        };
        holds(linked(cut, 1e-2));
        holds(linked(cut, 1e-4));
        holds(solved(cut, Method::hemisphere, 256));
        holds(solved(cut, Method::hemisphere, 4096));
    }
}

TEST_CASE("with a mirror, too, the estimated error is the true one within a factor of 1.6: by few rays, or none") {
    const CutScene cut("mirror.x3d", 140.0);
    const std::vector<Scattering> scatterings = scatteringsOf(cut.scene);
    FormFactorOptions factors;
    factors.rays = 256;
    const FormFactorMatrix matrix = formFactors(cut.geometry, factors);
    const auto solved = [&](std::size_t rays) {
        std::optional<SpecularTransport> specular;
        SpecularOptions over;
        over.rays = rays;
        if (rays > 0) specular.emplace(cut.geometry, scatterings, over);
        Transport transport = transportOf(matrix);
        if (specular) transport.further = specular->further();
        return solveRadiosity(transport, cut.surfaces);
    };
    const std::vector<Point> truth = solved(8192);
    for (const std::size_t rays : {0, 16, 64, 256}) {
        CAPTURE(rays);
        const std::vector<Point> found = solved(rays);
        ErrorEstimateOptions options;
        options.scatterings = scatterings;
        options.specularRays = std::max<std::size_t>(4 * rays, 256);
        const double error = cut.relativeError(found, truth);
        const double estimate = estimateError(cut.geometry, cut.surfaces, found, options);
        CAPTURE(error);
        CHECK(estimate > error / 1.6);
        CHECK(estimate < error * 1.6);
    }
}

TEST_CASE("an error that all patches share counts as often as it is reflected") {
    const CutScene furnace("furnace.x3d", 0.25);
    const std::vector<Point> right(furnace.geometry.patches.size(), Point(2.0)), low(right.size(), Point(1.9));
    const ErrorEstimateOptions options{.samples = 64, .rays = 16, .occlusion = false};
    CHECK(estimateError(furnace.geometry, furnace.surfaces, right, options) < 1e-5);
    CHECK(estimateError(furnace.geometry, furnace.surfaces, low, options) == Approx(0.1 / 1.9).epsilon(1e-3));
}

TEST_CASE("a black scene has no error, and the estimate is the same for any number of threads") {
    const CutScene dark("dark.x3d", 0.5);
    CHECK(estimateError(dark.geometry, dark.surfaces, std::vector<Point>(dark.geometry.patches.size(), Point(0.0))) ==
          0.0);
    const CutScene cut("cornell_2.x3d", 90.0);
    const std::vector<Point> found = linked(cut, 1e-3);
    std::vector<double> estimates;
    for (const std::size_t threads : {1, 2}) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        estimates.push_back(estimateError(cut.geometry, cut.surfaces, found));
    }
    CHECK(estimates[0] == estimates[1]);
}

TEST_CASE("light that changes evenly deviates from its patches by the twelfth of its step, in squares") {
    const std::vector<Vec3f> corners = {{0, 0, 0}, {8, 0, 0}, {8, 4, 0}, {0, 4, 0}};
    Face face;
    face.corners = {0, 1, 2, 3};
    face.material = std::make_shared<Material>();
    const PatchMesh mesh(corners, {face}, 1.0f, 1.0f);
    std::vector<Point> slope;
    double square = 0.0;
    for (const MyPolygon& patch : mesh.patches) {
        slope.emplace_back(0.0, 10.0 + double(patch.center.x), 0.0);
        square += slope.back().y * slope.back().y / double(mesh.patches.size());
    }
    // A patch has neighbours along x and along y, and only the former differ: at the ends one of three, else two of four.
    CHECK(estimateMeshError(mesh, slope) == Approx(std::sqrt(1.0 / 12.0 / square)).epsilon(0.1));
    CHECK(estimateMeshError(mesh, std::vector<Point>(slope.size(), Point(1.0))) == 0.0);
    const PatchMesh whole(corners, {face}, 10.0f, 10.0f);
    CHECK(std::isinf(estimateMeshError(whole, {Point(1.0)})));
    CHECK(estimateMeshError(whole, {Point(0.0)}) == 0.0);
}

TEST_CASE("the mesh's estimated error is the true one within a factor of 1.6") {
    for (const auto& room : {std::pair{"cornell_2.x3d", 60.0}, std::pair{"l_room.x3d", 0.5}}) {
        CAPTURE(room.first);
        const CutScene coarse(room.first, room.second), fine(room.first, room.second / 4);
        const std::vector<Point> found = linked(coarse, 1e-4), truth = linked(fine, 1e-4);
        double error = 0.0, all = 0.0;
        for (std::size_t i = 0; i < truth.size(); ++i) {
            // The patch of the coarse mesh whose centre is nearest, among those of the same face.
            std::size_t best = found.size();
            double nearest = INFINITY;
            for (std::size_t j = 0; j < found.size(); ++j) {
                const double distance =
                    glm::length(coarse.geometry.patches[j].center - fine.geometry.patches[i].center);
                if (coarse.geometry.faceOf[j] != fine.geometry.faceOf[i] || distance >= nearest) continue;
                nearest = distance;
                best = j;
            }
            const Point off = found[best] - truth[i];
            error += fine.geometry.patches[i].area * glm::dot(off, off);
            all += fine.geometry.patches[i].area * glm::dot(truth[i], truth[i]);
        }
        const double estimate = estimateMeshError(coarse.mesh, found), truly = std::sqrt(error / all);
        CHECK(estimate > truly / 1.6);
        CHECK(estimate < truly * 1.6);
    }
}

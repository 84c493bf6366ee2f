#include "engine/Visibility.h"

#include <cmath>

#include <doctest/doctest.h>

#include "engine/ClosedFormRoom.h"
#include "engine/FormFactors.h"
#include "engine/LowDiscrepancy.h"
#include "engine/SceneTestHelp.h"

using namespace radlab::engine;
using doctest::Approx;

namespace {

// A room with a turned block on its floor and a concave board in the air, each side in count x count patches.
Geometry furnishedRoom(int count) {
    std::vector<Polygon> faces = boxSides(4, 4, 3);
    const Point foot(1.2, 1.4, 0), u(0.9, 0.4, 0), v(-0.4, 0.9, 0), up(0, 0, 1.3);
    for (const Polygon& side :
         {parallelogram(foot + up, u, v), parallelogram(foot, u, up), parallelogram(foot + u, v, up),
          parallelogram(foot + u + v, -u, up), parallelogram(foot + v, -v, up)})
        faces.push_back(side);
    Geometry room = cut(faces, count);
    const Polygon board({Point(2, 2, 2), Point(3.5, 2.2, 2.3), Point(2.5, 2.5, 2.2), Point(2.3, 3.5, 2.3)});
    room.faceOf.push_back(room.faces.size());
    room.faces.push_back(board);
    room.patches.push_back(board);
    return room;
}

// Lines between points spread over two patches, but for those along which one of them is not seen from its front.
template <class Visit>
void forLines(const Geometry& room, std::size_t i, std::size_t j, std::uint64_t key, std::uint64_t count, double least,
              const Visit& visit) {
    const AreaSampler one(room.patches[i]), other(room.patches[j]);
    const LowDiscrepancy points(key);
    for (std::uint64_t k = 0; k < count; ++k) {
        const auto at = points.at(k);
        const Point from = one.at(at[0], at[1]), to = other.at(at[2], at[3]);
        if (glm::dot(to - from, room.patches[i].normal) <= least) continue;
        if (glm::dot(from - to, room.patches[j].normal) <= least) continue;
        visit(from, to);
    }
}

}  // namespace

TEST_CASE("what the shafts say of a pair is what rays find") {
    const Geometry room = furnishedRoom(6);
    const Shafts shafts(room);
    const RayScene rays(room.faces);
    Blockers between;
    std::size_t found[3] = {}, wrong = 0, cast = 0, missed = 0;
    for (std::size_t i = 0; i < room.patches.size(); ++i)
        for (std::size_t j = i + 1; j < room.patches.size(); ++j) {
            const Sight sight = shafts.sight(i, j, between);
            ++found[static_cast<int>(sight)];
            forLines(room, i, j, i * 1000 + j, 8, 1e-3, [&](const Point& from, const Point& to) {
                const bool stopped = rays.hides(from, to, room.faceOf[i], room.faceOf[j]);
                ++cast;
                wrong += (sight == Sight::clear && stopped) || (sight == Sight::hidden && !stopped);
                if (sight != Sight::partly) return;
                bool blocked = false;
                for (const Blocker* blocker : between) blocked = blocked || blocker->meets(from, to);
                missed += blocked != stopped;
            });
        }
    CHECK(found[static_cast<int>(Sight::clear)] > 300);
    CHECK(found[static_cast<int>(Sight::hidden)] > 20);
    CHECK(found[static_cast<int>(Sight::partly)] > 100);
    CHECK(cast > 10000);
    CHECK(double(wrong) < 2e-4 * double(cast));  // rays run in floats, and may slip through at an edge
    CHECK(double(missed) < 2e-3 * double(cast));
}

namespace {

// A closed ball of triangles: rings of parallels, halved; every one of its edges is shared by two.
std::vector<Polygon> ball(const Point& center, double radius, int rings) {
    const auto at = [&](int ring, int step) {
        const double polar = M_PI * ring / rings, turn = M_PI * (step % (2 * rings)) / rings;
        const double across = ring == 0 || ring == rings ? 0.0 : std::sin(polar);
        return center + radius * Point(across * std::cos(turn), across * std::sin(turn), std::cos(polar));
    };
    std::vector<Polygon> faces;
    for (int ring = 0; ring < rings; ++ring)
        for (int step = 0; step < 2 * rings; ++step) {
            const Point a = at(ring, step), b = at(ring + 1, step), c = at(ring + 1, step + 1), d = at(ring, step + 1);
            if (ring + 1 < rings) faces.push_back(Polygon({a, b, c}));
            if (ring > 0) faces.push_back(Polygon({a, c, d}));
        }
    return faces;
}

// A room with two balls and loose triangles in it, 600 faces and more.
Geometry fullRoom() {
    Geometry room = cut(boxSides(4, 4, 3), 6);
    std::vector<Polygon> faces;
    for (const auto& [center, radius] : {std::pair(Point(1.4, 1.3, 1.1), 0.7), std::pair(Point(2.7, 2.8, 1.8), 0.5)})
        for (const Polygon& face : ball(center, radius, 9)) faces.push_back(face);
    for (std::uint64_t i = 0; i < 60; ++i) {
        const LowDiscrepancy points(1000 + i);
        std::vector<Point> corners;
        const auto middle = points.at(0);
        for (std::uint64_t k = 1; k <= 3; ++k) {
            const auto at = points.at(k);
            corners.push_back(Point(0.4 + 3.2 * middle[0], 0.4 + 3.2 * middle[1], 0.4 + 2.2 * middle[2]) +
                              0.4 * Point(at[0] - 0.5, at[1] - 0.5, at[2] - 0.5));
        }
        faces.push_back(Polygon(corners));
    }
    for (const Polygon& face : faces) {
        room.faceOf.push_back(room.faces.size());
        room.faces.push_back(face);
        room.patches.push_back(face);
    }
    return room;
}

// Whether any face but the two patches' own stops the line.
bool isStopped(const Geometry& geometry, const std::vector<Blocker>& blockers, std::size_t i, std::size_t j,
               const Point& from, const Point& to) {
    for (std::size_t face = 0; face < blockers.size(); ++face)
        if (face != geometry.faceOf[i] && face != geometry.faceOf[j] && blockers[face].meets(from, to)) return true;
    return false;
}

}  // namespace

TEST_CASE("among many faces, what the shafts say of a pair is what every face says, line by line") {
    const Geometry room = fullRoom();
    CHECK(room.faces.size() > 600);
    const Shafts shafts(room);
    std::vector<Blocker> blockers;
    for (const Polygon& face : room.faces) blockers.emplace_back(face, 6.4e-6);
    Blockers between;
    std::size_t found[3] = {}, wrong[3] = {}, together = 0, cast = 0;
    for (std::size_t i = 0; i < room.patches.size(); i += 3)
        for (std::size_t j = i + 1; j < room.patches.size(); j += 7) {
            if (!faceEachOther(room.patches[i], room.patches[j])) continue;
            const Sight sight = shafts.sight(i, j, between);
            ++found[static_cast<int>(sight)];
            together += sight == Sight::hidden && between.size() > 1;
            forLines(room, i, j, i * 1000 + j, 4, 1e-3, [&](const Point& from, const Point& to) {
                bool said = sight == Sight::hidden;
                for (const Blocker* blocker : between)
                    said = said || (sight == Sight::partly && blocker->meets(from, to));
                ++cast;
                wrong[static_cast<int>(sight)] += said != isStopped(room, blockers, i, j, from, to);
            });
        }
    CHECK(found[static_cast<int>(Sight::clear)] > 1000);
    CHECK(found[static_cast<int>(Sight::hidden)] > 30);
    CHECK(found[static_cast<int>(Sight::partly)] > 1000);
    CHECK(together > 30);
    CHECK(cast > 10000);
    for (const std::size_t count : wrong) CHECK(count == 0);
}

TEST_CASE("pairs of the teapot's room that are decided are so by thousands of rays") {
    const CutScene teapot("teapot.x3d", 0.9);
    const Geometry& room = teapot.geometry;
    const Visibility visibility(room, 16);
    const RayScene rays(room.faces);
    std::size_t found[3] = {}, cast[3] = {}, stopped[3] = {};
    const LowDiscrepancy pairs(5);
    const auto some = [&](double share) { return static_cast<std::size_t>(share * double(room.patches.size())); };
    for (std::uint64_t k = 0; k < 6000; ++k) {
        const std::size_t i = some(pairs.at(k)[0]), j = some(pairs.at(k)[1]);
        if (i == j || !faceEachOther(room.patches[i], room.patches[j])) continue;
        const int sight = static_cast<int>(visibility.sight(i, j));
        ++found[sight];
        forLines(room, i, j, k, 16, 1e-2, [&](const Point& from, const Point& to) {
            ++cast[sight];
            stopped[sight] += rays.hides(from, to, room.faceOf[i], room.faceOf[j]);
        });
    }
    const int clear = static_cast<int>(Sight::clear), hidden = static_cast<int>(Sight::hidden);
    CHECK(found[clear] > 500);
    CHECK(found[hidden] > 50);
    CHECK(cast[clear] > 5000);
    CHECK(stopped[clear] == 0);
    CHECK(double(cast[hidden] - stopped[hidden]) <= 1e-3 * double(cast[hidden]));  // floats slip through at edges
}

TEST_CASE("a closed ball of many faces hides what is behind it without a ray") {
    std::vector<Polygon> faces = {onFloor(0.4, 0.4, 0.2, 0.2), onCeiling(0.4, 0.4, 2, 0.2, 0.2)};
    for (const Polygon& face : ball(Point(0.5, 0.5, 1), 0.6, 12)) faces.push_back(face);
    const Geometry geometry = geometryOfFaces(faces);
    CHECK(geometry.faces.size() > 500);
    const Visibility visibility(geometry, 64);
    CHECK(visibility.visibleShare(0, 1) == 0.0);
    CHECK(visibility.rays() == 0);
}

TEST_CASE("among many faces, an occluder that hides a hundredth is seen") {
    std::vector<Polygon> faces = {onFloor(0, 0, 1, 1), onCeiling(0, 0, 1, 1, 1), onCeiling(0.45, 0.45, 0.5, 0.1, 0.1)};
    for (int i = 0; i < 300; ++i) faces.push_back(onFloor(5.0 + i, 5, 0.5, 0.5));
    for (std::size_t seed = 0; seed < 8; ++seed) {
        const Geometry geometry = geometryOfFaces(faces);
        const Visibility visibility(geometry, 4096, seed);
        CHECK(visibility.sight(0, 1) == Sight::partly);
        const double share = visibility.visibleShare(0, 1);
        CHECK(share < 0.98);
        CHECK(share > 0.95);
    }
}

TEST_CASE("a blocker stops what crosses it, and nothing that only touches it or ends on it") {
    const Blocker square(onFloor(0, 0, 1, 1), 1e-9);
    CHECK(square.meets(Point(.5, .5, 1), Point(.5, .5, -1)));
    CHECK(square.meets(Point(.5, .5, -1), Point(.9, .1, 3)));
    CHECK_FALSE(square.meets(Point(.5, .5, 1), Point(.5, .5, 0)));
    CHECK_FALSE(square.meets(Point(.5, .5, 0), Point(.5, .5, 1)));
    CHECK_FALSE(square.meets(Point(1.5, .5, 1), Point(1.5, .5, -1)));
    CHECK_FALSE(square.meets(Point(0, .5, 1), Point(0, .5, -1)));
    CHECK_FALSE(square.meets(Point(0, 0, 0), Point(1, 1, 0)));
    CHECK(square.between(onCeiling(.4, .4, 1, .2, .2), onFloor(.4, .4, .2, .2)) == Sight::partly);
    const auto below = [](double x) { return parallelogram(Point(x, .4, -1), Point(.2, 0, 0), Point(0, .2, 0)); };
    CHECK(square.between(onCeiling(.4, .4, 1, .2, .2), below(.4)) == Sight::hidden);
    CHECK(square.between(onCeiling(.4, .4, 1, .2, .2), below(1.5)) == Sight::partly);
    CHECK(square.between(onCeiling(.4, .4, 1, .2, .2), below(1.7)) == Sight::clear);
}

TEST_CASE("triangles of a polygon of any shape add up to it, and samples lie in it") {
    const Polygon arrow({Point(-1, -1, 2), Point(0, 1, 2), Point(1, -1, 2), Point(0, -0.5, 2)});
    double area = 0.0;
    for (const Triangle& t : trianglesOf(arrow)) area += Polygon({t[0], t[1], t[2]}).area;
    CHECK(area == Approx(arrow.area).epsilon(1e-12));
    const AreaSampler sampler(arrow);
    const LowDiscrepancy points(1);
    Point mean(0.0);
    for (std::uint64_t k = 0; k < 4096; ++k) {
        const auto at = points.at(k);
        const Point point = sampler.at(at[0], at[1]);
        CHECK(point.y >= -0.5 - 0.5 * std::abs(point.x) - 1e-12);
        CHECK(point.y <= 1.0 - 2.0 * std::abs(point.x) + 1e-12);
        mean += point / 4096.0;
    }
    CHECK(glm::length(mean - arrow.center) < 1e-3);
}

namespace {

// The factor from a floor to a ceiling at distance 1 where panes stand between, and faces that hide nothing far away.
double factorThrough(const std::vector<Polygon>& panes, double through, Method method, std::size_t farFaces = 0) {
    std::vector<Polygon> faces = {onFloor(0, 0, 1, 1), onCeiling(0, 0, 1, 1, 1)};
    faces.insert(faces.end(), panes.begin(), panes.end());
    for (std::size_t i = 0; i < farFaces; ++i) faces.push_back(onFloor(5.0 + double(i), 5, 0.5, 0.5));
    Geometry geometry = geometryOfFaces(faces);
    geometry.through.assign(faces.size(), 0.0);
    for (std::size_t i = 0; i < panes.size(); ++i) geometry.through[2 + i] = through;
    FormFactorOptions options;
    options.method = method;
    options.rays = 16384;
    return formFactors(geometry, options).at(0, 1);
}

}  // namespace

TEST_CASE("a pane that covers all lines weakens a form factor by the share that it lets through, two by its square") {
    const double open = 0.199824895698387;
    const Polygon fromBelow = onCeiling(-1, -1, 0.3, 3, 3),
                  fromAbove = parallelogram({-1, -1, 0.7}, {3, 0, 0}, {0, 3, 0});
    for (const double through : {0.0, 0.5, 1.0}) {
        CAPTURE(through);
        for (const Polygon& pane : {fromBelow, fromAbove}) {
            CHECK(factorThrough({pane}, through, Method::visibility) == Approx(through * open).epsilon(1e-6));
            CHECK(factorThrough({pane}, through, Method::visibility, 300) == Approx(through * open).epsilon(1e-6));
            CHECK(factorThrough({pane}, through, Method::hemisphere) == Approx(through * open).epsilon(0.01));
        }
        const double twice = through * through * open;
        CHECK(factorThrough({fromBelow, fromAbove}, through, Method::visibility) == Approx(twice).epsilon(1e-6));
        CHECK(factorThrough({fromBelow, fromAbove}, through, Method::visibility, 300) == Approx(twice).epsilon(1e-6));
        CHECK(factorThrough({fromBelow, fromAbove}, through, Method::hemisphere) == Approx(twice).epsilon(0.01));
    }
}

TEST_CASE("a pane that covers some lines takes its share of what an opaque face would hide") {
    const double open = 0.199824895698387, hidden = 0.149868671773790;
    const Polygon quarter = onCeiling(0, 0, 0.5, 0.5, 0.5);
    for (const double through : {0.0, 0.25, 0.75}) {
        CAPTURE(through);
        const double expected = through * open + (1.0 - through) * hidden;
        CHECK(factorThrough({quarter}, through, Method::visibility) == Approx(expected).epsilon(0.002));
        CHECK(factorThrough({quarter}, through, Method::visibility, 300) == Approx(expected).epsilon(0.002));
        CHECK(factorThrough({quarter}, through, Method::hemisphere) == Approx(expected).epsilon(0.01));
    }
}

TEST_CASE("rays over the hemisphere count light at a pane and behind it") {
    Geometry geometry = geometryOfFaces(boxSides(1, 1, 1));
    const Polygon pane = onCeiling(-0.001, -0.001, 0.5, 1.002, 1.002);
    geometry.faces.push_back(pane);
    geometry.patches.push_back(pane);
    geometry.faceOf.push_back(6);
    const auto row = [&](double through) {
        geometry.through.assign(7, 0.0);
        geometry.through[6] = through;
        FormFactorOptions options;
        options.method = Method::hemisphere;
        const FormFactorMatrix matrix = formFactors(geometry, options);
        return std::vector<double>(matrix.row(0), matrix.row(0) + 7);
    };
    const std::vector<double> opaque = row(0.0), half = row(0.5);
    double sum = 0.0, halfSum = 0.0;
    for (std::size_t j = 0; j < 7; ++j) {
        sum += opaque[j];
        halfSum += half[j];
    }
    CHECK(sum == Approx(1.0));
    CHECK(half[6] == opaque[6]);
    CHECK(halfSum == Approx(1.0 + 0.5 * half[6]).epsilon(1e-3));
}

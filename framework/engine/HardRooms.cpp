#include "engine/HardRooms.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/Error.h"
#include "engine/ClosedFormRoom.h"
#include "engine/FormFactorRows.h"
#include "engine/HierarchicalRadiosity.h"
#include "engine/Shooting.h"

namespace radlab::engine {

namespace {

constexpr double unfit = std::numeric_limits<double>::infinity();
constexpr std::size_t largestMatrix = 5000;  // patches

HardRoom room(const std::string& what, Geometry geometry, double emission, double reflectance) {
    HardRoom made;
    made.what = what;
    made.geometry = std::move(geometry);
    const std::size_t count = made.geometry.patches.size();
    made.surfaces = {std::vector<Point>(count, Point(emission)), std::vector<Point>(count, Point(reflectance))};
    return made;
}

HardRoom furnace(const std::string& what, Geometry geometry, double emission, double reflectance) {
    HardRoom made = room(what, std::move(geometry), emission, reflectance);
    made.truth.assign(made.geometry.patches.size(), emission / (1.0 - reflectance));
    made.source = "E/(1-ρ) in a closed room";
    made.matrix = 1e-9 + 1e-11 / (1.0 - reflectance);
    made.links = 0.1;
    if (reflectance > 0.9) made.links = made.shooting = unfit;
    return made;
}

std::vector<HardRoom> furnaces() {
    const Geometry cube = cut(boxSides(1, 1, 1), 3);
    std::vector<HardRoom> all = {furnace("a black room", cube, 1.0, 0.0),
                                 furnace("a furnace, albedo 0.5", cube, 1.0, 0.5),
                                 furnace("a furnace, albedo 0.9", cube, 1.0, 0.9),
                                 furnace("a furnace, albedo 0.99", cube, 1.0, 0.99),
                                 furnace("a furnace, albedo 0.999", cube, 1.0, 0.999),
                                 furnace("a furnace, albedo 1 - 1e-6", cube, 1.0, 1.0 - 1e-6),
                                 furnace("a furnace of 1e-9 W/m²", cube, 1e-9, 0.5),
                                 furnace("a furnace of 1e9 W/m²", cube, 1e9, 0.5),
                                 furnace("a corridor of 1 to 1,000", cut(boxSides(1, 1, 1000), 3), 1.0, 0.5),
                                 furnace("a slab of 1,000 to 1", cut(boxSides(1000, 1000, 1), 3), 1.0, 0.5)};
    HardRoom endless = room("a furnace, albedo 1: refused", cube, 1.0, 1.0);
    endless.source = "light never ends";
    endless.matrix = 0.0;
    endless.shooting = endless.links = unfit;  // their form factors lose some light, so that it does end
    all.push_back(endless);
    return all;
}

// A cube of six patches whose floor emits 1 and reflects nothing.
HardRoom litCube(const std::string& what, double size, double offset, double brightness, double allowed) {
    std::vector<Polygon> sides;
    for (const Polygon& side : boxSides(size, size, size)) sides.push_back(moved(side, 1.0, offset));
    HardRoom made = room(what, geometryOfFaces(sides), 0.0, 0.5);
    made.surfaces.emission[0] = Point(brightness);
    made.surfaces.reflectance[0] = Point(0.0);
    const double opposite = 0.166600339499 * brightness, beside = 0.166683245434 * brightness;
    made.truth = {brightness, opposite, beside, beside, beside, beside};
    made.source = "six equations with the closed forms of squares";
    made.matrix = allowed;
    made.links = 1e-3;
    return made;
}

std::vector<HardRoom> scaled() {
    return {litCube("a cube with one lit side", 1.0, 0.0, 1.0, 1e-9),
            litCube("the same of size 1e-6", 1e-6, 0.0, 1.0, 1e-9),
            litCube("the same of size 1e6", 1e6, 0.0, 1.0, 1e-9),
            litCube("the same a million from the origin", 1.0, 1e6, 1.0, 1e-5),
            litCube("the same, lit by 1e-12", 1.0, 0.0, 1e-12, 1e-9)};
}

// Two facing unit squares, a gap of 1: F = 0.1998 each way.
HardRoom plates(const std::string& what, const Point& emission, const Point& reflectance) {
    constexpr double factor = 0.199824895698387;
    HardRoom made = room(what, geometryOfFaces({onFloor(0, 0, 1, 1), onCeiling(0, 0, 1, 1, 1)}), 0.0, 0.0);
    for (const std::size_t i : {0u, 1u}) {
        made.surfaces.emission[i] = Point(emission[static_cast<int>(i)]);
        made.surfaces.reflectance[i] = Point(reflectance[static_cast<int>(i)]);
    }
    const double ending = 1.0 - reflectance.x * reflectance.y * factor * factor;
    made.truth = {(emission.x + reflectance.x * factor * emission.y) / ending,
                  (emission.y + reflectance.y * factor * emission.x) / ending};
    made.source = "two equations with the closed form of squares";
    made.links = 1e-3;
    return made;
}

std::vector<HardRoom> open() {
    return {plates("two plates, open to all sides", {1.0, 0.0, 0.0}, {0.5, 0.5, 0.0}),
            plates("two plates of albedo 1: light ends outside", {1.0, 1.0, 0.0}, {1.0, 1.0, 0.0}),
            plates("two plates, emissions twelve orders apart", {1.0, 1e-12, 0.0}, {0.0, 0.5, 0.0}),
            plates("two plates, both black", {1.0, 1e-12, 0.0}, {0.0, 0.0, 0.0})};
}

// A cube whose sides are cut in different numbers: corners of some lie on edges of others.
HardRoom junctions() {
    const std::vector<Polygon> sides = boxSides(1, 1, 1);
    Geometry geometry;
    geometry.faces = sides;
    for (std::size_t side = 0; side < sides.size(); ++side)
        for (const Polygon& patch : cut({sides[side]}, 1 + static_cast<int>(side)).patches) {
            geometry.patches.push_back(patch);
            geometry.faceOf.push_back(side);
        }
    return furnace("a furnace with T-junctions at all edges", geometry, 1.0, 0.5);
}

// A cube inside a cube: all that leaves the inner one reaches the outer one.
HardRoom concentric() {
    std::vector<Polygon> sides = boxSides(3, 3, 3);
    for (const Polygon& side : boxSides(1, 1, 1)) sides.push_back(turned(moved(side, 1.0, 1.0)));
    HardRoom made = furnace("a furnace with a box in it", cut(sides, 2), 1.0, 0.5);
    made.occlusion = true;
    made.source = "E/(1-ρ) in a closed room; visible shares by rays";
    made.matrix = made.shooting = 2e-2;
    return made;
}

HardRoom oneAmongMany() {
    HardRoom made = room("one lit patch among 1e5", cut(boxSides(1, 1, 1), 129), 0.0, 0.5);
    made.surfaces.emission[made.geometry.patches.size() / 3] = Point(1.0);
    made.truth = {1.0 / static_cast<double>(made.geometry.patches.size()) / 0.5};
    made.source = "what is emitted is absorbed";
    made.links = 0.1;
    return made;
}

std::vector<HardRoom> table() {
    std::vector<HardRoom> all;
    for (const std::vector<HardRoom>& some :
         {furnaces(), scaled(), open(), {junctions(), concentric(), oneAmongMany()}})
        all.insert(all.end(), some.begin(), some.end());
    return all;
}

std::vector<Point> solved(const HardRoom& hard, Solver solver) {
    if (solver == Solver::links) {
        HierarchicalOptions options;
        options.occlusion = hard.occlusion;
        options.threshold = 1e-4;
        return solveHierarchical(hard.geometry, hard.surfaces, options);
    }
    FormFactorOptions factors;
    factors.occlusion = hard.occlusion;
    factors.tolerance = 1e-12;
    if (solver == Solver::matrix) return solveRadiosity(formFactors(hard.geometry, factors), hard.surfaces);
    const FormFactorRows rows(hard.geometry, factors);
    ShootingOptions options;
    options.unshot = 1e-7;
    options.mostShots = 100'000;
    return shootRadiosity(
        areasOf(hard.geometry), hard.surfaces, [&](std::size_t i, double* row) { rows.row(i, row); }, options);
}

double errorIn(const HardRoom& hard, const std::vector<Point>& found) {
    if (hard.truth.empty()) return unfit;
    double worst = 0.0, mean = 0.0, area = 0.0;
    for (std::size_t i = 0; i < found.size(); ++i) {
        if (!std::isfinite(found[i].x) || found[i].x < hard.surfaces.emission[i].x) return unfit;
        mean += hard.geometry.patches[i].area * found[i].x;
        area += hard.geometry.patches[i].area;
        if (hard.truth.size() == found.size()) worst = std::max(worst, std::abs(found[i].x / hard.truth[i] - 1.0));
    }
    return hard.truth.size() == found.size() ? worst : std::abs(mean / area / hard.truth[0] - 1.0);
}

}  // namespace

std::string nameOf(Solver solver) {
    return solver == Solver::matrix ? "matrix" : solver == Solver::shooting ? "shooting" : "links";
}

const std::vector<HardRoom>& hardRooms() {
    static const std::vector<HardRoom> rooms = table();
    return rooms;
}

double allowedError(const HardRoom& hard, Solver solver) {
    if (solver == Solver::links) return hard.links;
    if (hard.geometry.patches.size() > largestMatrix) return unfit;
    return solver == Solver::matrix ? hard.matrix : hard.shooting;
}

double errorOf(const HardRoom& hard, Solver solver) {
    try {
        return errorIn(hard, solved(hard, solver));
    } catch (const Error&) {
        return hard.truth.empty() ? 0.0 : unfit;
    }
}

}  // namespace radlab::engine

#include "engine/HardRooms.h"

#include <cmath>
#include <limits>

#include "engine/ClosedFormRoom.h"

namespace radlab::engine {

namespace {

constexpr double unfit = std::numeric_limits<double>::infinity();

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
    if (reflectance > 0.9999) made.links = unfit;
    if (reflectance > 0.9) made.shooting = unfit;  // takes hundreds of shots a patch
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

// A cube whose ceiling shows its back, or lies there twice and is black: nothing comes back from it either way.
HardRoom darkCeiling(const std::string& what, std::vector<Polygon> sides, double ceilings) {
    HardRoom made = room(what, geometryOfFaces(std::move(sides)), 0.0, 0.5);
    const double beside = 0.142879476192826;
    made.truth = {1.0, ceilings, beside, beside, beside, beside};
    made.truth.resize(made.geometry.patches.size(), ceilings);
    for (std::size_t i = 0; i < made.truth.size(); ++i)
        if (i < 2 || i > 5) {
            made.surfaces.emission[i] = Point(made.truth[i]);
            made.surfaces.reflectance[i] = Point(0.0);
        }
    made.source = "one equation with the closed forms of squares";
    made.links = 1e-3;
    return made;
}

std::vector<HardRoom> darkCeilings() {
    std::vector<Polygon> flipped = boxSides(1, 1, 1), twice = boxSides(1, 1, 1);
    flipped[1] = turned(flipped[1]);
    twice.push_back(twice[1]);
    return {darkCeiling("a cube with its ceiling turned inside out", flipped, 1.0),
            darkCeiling("a cube with its black ceiling given twice", twice, 0.0)};
}

// Two facing plates and a smaller one between them that hides a quarter; nothing round them.
HardRoom openWithOccluder() {
    const Polygon plate = onCeiling(0, 0, 0.5, 0.5, 0.5);
    HardRoom made =
        room("two plates in the open, a quarter hidden",
             geometryOfFaces({onFloor(0, 0, 1, 1), onCeiling(0, 0, 1, 1, 1), plate, turned(plate)}), 0.0, 0.5);
    made.surfaces.emission[0] = Point(1.0);
    made.truth = {1.016728782880768, 0.07701793423401126, 0.2110999827993174, 0.01599097504250096};
    made.source = "four equations with the closed forms of rectangles";
    made.occlusion = true;
    made.matrix = made.shooting = made.links = 5e-2;
    return made;
}

// Two cubes side by side, with a wall of two faces between them.
std::vector<Polygon> twoCubes() {
    std::vector<Polygon> sides;
    for (const Point& corner : {Point(0.0), Point(1, 0, 0)})
        for (const Polygon& side : boxSides(1, 1, 1)) {
            std::vector<Point> corners = side.corners;
            for (Point& at : corners) at += corner;
            sides.emplace_back(std::move(corners));
        }
    return sides;
}

// Their floor is one patch, half of it in either cube; the ceiling of the first emits 1.
HardRoom underTheWall() {
    std::vector<Polygon> sides = twoCubes();
    sides[0] = onFloor(0, 0, 2, 1);
    sides.erase(sides.begin() + 6);
    HardRoom made = room("a floor that goes on under a wall into another cube", geometryOfFaces(sides), 0.0, 0.5);
    made.surfaces.emission[1] = Point(1.0);
    const double lit = 0.1666892768762592, dim = 0.01514699206986983;
    made.truth = {0.09087291305389424, 1.075769639941612, lit, lit, lit, lit, 0.01513945816608342, dim, dim, dim, dim};
    made.source = "eleven equations with the closed forms of rectangles";
    made.occlusion = true;
    made.matrix = made.shooting = made.links = 5e-2;
    return made;
}

// A shelf sticks through the wall into both cubes.
HardRoom throughTheWall() {
    std::vector<Polygon> sides = twoCubes();
    const Polygon shelf = onFloor(0.5, 0.25, 1, 0.5);
    std::vector<Point> corners = shelf.corners;
    for (Point& at : corners) at.z = 0.5;
    sides.emplace_back(corners);
    sides.push_back(turned(sides.back()));
    HardRoom made = furnace("a furnace with a shelf through its wall", geometryOfFaces(sides), 1.0, 0.5);
    made.occlusion = true;
    made.source = "E/(1-ρ) in a closed room; visible shares by rays";
    made.matrix = made.shooting = 3e-2;
    return made;
}

// Corners within the sides move off their planes, as far as the Mesher allows: patches are bent, and the room stays closed.
HardRoom bent() {
    Geometry geometry = cut(boxSides(1, 1, 1), 2);
    for (std::size_t i = 0; i < geometry.patches.size(); ++i) {
        const Point normal = geometry.faces[geometry.faceOf[i]].normal;
        std::vector<Point> corners = geometry.patches[i].corners;
        for (Point& at : corners) {
            const int onSides = (at.x * (1 - at.x) == 0.0) + (at.y * (1 - at.y) == 0.0) + (at.z * (1 - at.z) == 0.0);
            if (onSides == 1) at += 3e-4 * std::sin(40.0 * (at.x + 2.0 * at.y + 3.0 * at.z)) * normal;
        }
        geometry.patches[i] = Polygon(std::move(corners));
    }
    HardRoom made = furnace("a furnace of quads that are not planar", geometry, 1.0, 0.5);
    made.matrix = made.shooting = 1e-3;
    return made;
}

HardRoom withoutArea() {
    std::vector<Polygon> sides = boxSides(1, 1, 1);
    const Point middle(0.5);
    sides.push_back(Polygon({middle, middle, middle}));
    sides.push_back(Polygon({middle, middle + Point(0.1), middle + Point(0.2)}));
    HardRoom made = furnace("a furnace with faces without area", geometryOfFaces(sides), 1.0, 0.5);
    made.truth[6] = made.truth[7] = 1.0;
    return made;
}

HardRoom oneAmongMany() {
    HardRoom made = room("one lit patch among 1e5", cut(boxSides(1, 1, 1), 130), 0.0, 0.5);
    made.surfaces.emission[made.geometry.patches.size() / 3] = Point(1.0);
    made.truth = {1.0 / static_cast<double>(made.geometry.patches.size()) / 0.5};
    made.source = "what is emitted is absorbed";
    made.links = 0.1;
    return made;
}

std::vector<HardRoom> roomTable() {
    std::vector<HardRoom> all;
    for (const std::vector<HardRoom>& some : {furnaces(),
                                              scaled(),
                                              open(),
                                              darkCeilings(),
                                              {junctions(), concentric(), openWithOccluder(), underTheWall(),
                                               throughTheWall(), bent(), withoutArea(), oneAmongMany()}})
        all.insert(all.end(), some.begin(), some.end());
    return all;
}

}  // namespace

const std::vector<HardRoom>& hardRooms() {
    static const std::vector<HardRoom> rooms = roomTable();
    return rooms;
}

}  // namespace radlab::engine

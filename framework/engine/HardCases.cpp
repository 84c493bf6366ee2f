#include "engine/HardCases.h"

#include <cmath>
#include <limits>
#include <numbers>

#include "engine/ClosedFormRoom.h"
#include "engine/ExchangeArea.h"

namespace radlab::engine {

namespace {

const std::string rectangles = "closed form of two rectangles, 60 digits";

HardCase pair(const std::string& what, Polygon from, Polygon to, double truth, const std::string& source = rectangles) {
    HardCase hard;
    hard.what = what;
    hard.geometry = geometryOfFaces({std::move(from), std::move(to)});
    hard.truth = truth;
    hard.source = source;
    return hard;
}

HardCase farPair(const std::string& what, Polygon from, Polygon to, double truth) {
    HardCase hard = pair(what, std::move(from), std::move(to), truth);
    hard.apart = true;
    return hard;
}

HardCase thin(HardCase hard) {
    hard.exact = 1e-9;  // long edges close together cancel in the integral along outlines
    return hard;
}

HardCase coincident(HardCase hard) {
    hard.coincident = true;
    return hard;
}

// A floor and a ceiling with plates between them that hide from both sides.
HardCase blocked(const std::string& what, Polygon floor, Polygon ceiling, const std::vector<Polygon>& plates,
                 double truth, const std::string& source) {
    HardCase hard = pair(what, std::move(floor), std::move(ceiling), truth, source);
    std::vector<Polygon> all = hard.geometry.faces;
    all.insert(all.end(), plates.begin(), plates.end());
    hard.geometry = geometryOfFaces(std::move(all));
    hard.hidden = true;
    return hard;
}

std::vector<HardCase> wedges() {
    const struct {
        double degrees, truth;
    } table[] = {{30, .619028323091},  {45, .483347695479},  {60, .370905321150},  {75, .277410291997},
                 {90, .200043776075},  {105, .136887204283}, {120, .086615001118}, {135, .048309447802},
                 {150, .021345325413}, {165, .005317985921}};
    std::vector<HardCase> all;
    for (const auto& [degrees, truth] : table) {
        const double angle = degrees * std::numbers::pi / 180.0;
        all.push_back(pair("squares that share an edge at " + std::to_string(static_cast<int>(degrees)) + " degrees",
                           onFloor(0, 0, 1, 1),
                           parallelogram({0, 0, 0}, {0, 1, 0}, {std::cos(angle), 0, std::sin(angle)}), truth,
                           "double integral along the outlines, 50 digits"));
        all.back().exact = 0.6e-12 / truth;  // the truth has twelve decimals
    }
    return all;
}

std::vector<HardCase> nearAndFar() {
    const Polygon floor = onFloor(0, 0, 1, 1);
    return {
        pair("facing squares, a gap of 1e-4", floor, onCeiling(0, 0, 1e-4, 1, 1), 0.99980007097778849),
        pair("facing squares, a gap of 1e-6", floor, onCeiling(0, 0, 1e-6, 1, 1), 0.99999800001002952),
        pair("facing squares, a gap of 1e-8", floor, onCeiling(0, 0, 1e-8, 1, 1), 0.9999999800000013),
        farPair("facing squares, 100 sizes apart", floor, onCeiling(0, 0, 100, 1, 1), 3.1828866732829196e-5),
        farPair("facing squares, 1,000 sizes apart", floor, onCeiling(0, 0, 1000, 1, 1), 3.1830967397738026e-7),
        farPair("facing squares, 10,000 sizes apart", floor, onCeiling(0, 0, 1e4, 1, 1), 3.1830988406172478e-9),
        farPair("squares of 1e-3, 100 apart", onFloor(0, 0, 1e-3, 1e-3), onCeiling(0, 0, 100, 1e-3, 1e-3),
                3.1830988616257001e-11),
        farPair("a square of 1e-3, a unit square 100 apart", onFloor(0, 0, 1e-3, 1e-3), onCeiling(0, 0, 100, 1, 1),
                3.1826751441018989e-5),
        pair("facing squares, set off by 10", floor, onCeiling(10, 0, 1, 1, 1), 3.1613637304168129e-5),
        pair("facing squares, set off by 1,000", floor, onCeiling(1000, 0, 1, 1, 1), 3.1830967397667998e-13),
        pair("a wall 10 away", onFloor(10, 0, 1, 1), onWall(0, 0, 1, 1), 0.0001364474034390309),
        pair("a wall 1,000 away", onFloor(1000, 0, 1, 1), onWall(0, 0, 1, 1), 1.5891631691286935e-10),
        pair("a wall set off by 10", floor, onWall(10, 0, 1, 1), 7.9303027085430681e-6),
        pair("a wall 1e-6 away from the floor's edge", onFloor(1e-6, 0, 1, 1), onWall(0, 0, 1, 1), 0.20004334176022314),
        pair("a wall that meets the floor in a corner alone", floor, onWall(1, 0, 1, 1), 0.040592230101558543),
        pair("side by side above each other, a gap of 1e-3", floor, onCeiling(1, 0, 1e-3, 1, 1),
             0.00049739816185990701)};
}

std::vector<HardCase> unequal() {
    return {
        pair("areas 1 to 1e-8, facing", onFloor(0, 0, 1e-4, 1e-4), onCeiling(0, 0, 1, 1, 1), 0.13854594799098763),
        pair("areas 1 to 1e-12, facing", onFloor(0, 0, 1e-6, 1e-6), onCeiling(0, 0, 1, 1, 1), 0.13853174941365135),
        pair("areas 1 to 1e-12, a gap of 1e-3", onFloor(.5, .5, 1e-6, 1e-6), onCeiling(0, 0, 1e-3, 1, 1),
             0.99999672677154817),
        pair("areas 1 to 1e-8, on a shared edge", onFloor(0, .25, 1e-4, 1e-4), onWall(0, 0, 1, 1), 0.49995049392263903),
        pair("areas 1 to 1e-12, on a shared edge", onFloor(0, .25, 1e-6, 1e-6), onWall(0, 0, 1, 1),
             0.49999950488439855),
        pair("areas 1 to 1e-12, in a corner", onFloor(0, 0, 1e-6, 1e-6), onWall(0, 0, 1, 1), 0.37499985792246877),
        pair("a patch of 1e-9, 1e-6 away from a corner", onFloor(1e-6, 1e-6, 1e-9, 1e-9), onWall(0, 0, 1, 1),
             0.37499971570274047),
        pair("areas 100 to 1, a gap of 1e-2", onFloor(0, 0, 1, 1), onCeiling(-5, -5, 0.01, 10, 10),
             0.99999657255878142),
        thin(pair("a strip of 1e-4 along a wall", onFloor(0, 0, 1e-4, 1), onWall(0, 0, 1, 1), 0.49982255552878213)),
        thin(pair("a strip of 1e-6 along a wall", onFloor(0, 0, 1e-6, 1), onWall(0, 0, 1, 1), 0.49999749261968876)),
        thin(pair("two strips of 1e-6 that touch", onFloor(0, 0, 1e-6, 1), onWall(0, 0, 1, 1e-6), 0.2928931084956524)),
        thin(pair("a wall of 1e-6 along a floor", onFloor(0, 0, 1, 1), onWall(0, 0, 1, 1e-6), 4.9999749261968876e-7)),
        thin(pair("a sliver of 1e-6 below a square", onFloor(0, 0, 1e-6, 1), onCeiling(0, 0, 1, 1, 1),
                  0.16559490835175575)),
        thin(pair("two slivers of 1e-6 crosswise", onFloor(0, 0, 1e-6, 1), onCeiling(0, 0, 1, 1, 1e-6),
                  1.3853174941365135e-7)),
        pair("the ends of a corridor of 50", onFloor(0, 0, 1, 1), onCeiling(0, 0, 50, 1, 1), 0.00012729001295852927),
        pair("strips of 1 to 1,000 that face each other", onFloor(0, 0, 1, 1000), onCeiling(0, 0, 1, 1, 1000),
             0.41393419807935092)};
}

std::vector<HardCase> nothing() {
    const Polygon floor = onFloor(0, 0, 1, 1);
    const std::string why = "no point of one lies in front of the other";
    return {pair("in one plane, side by side", floor, onFloor(1, 0, 1, 1), 0.0, why),
            pair("the same square twice", floor, floor, 0.0, why),
            pair("back to back", floor, turned(floor), 0.0, why),
            pair("front to front in one plane", turned(floor), floor, 0.0, why),
            pair("just past grazing", floor, parallelogram({0, 0, 0}, {0, 1, 0}, {-1, 0, -1e-9}), 0.0, why),
            pair("facing, with the winding flipped", floor, turned(onCeiling(0, 0, 1, 1, 1)), 0.0, why),
            pair("a receiver behind", floor, onCeiling(0, 0, -1, 1, 1), 0.0, why),
            pair("a receiver without area", floor, Polygon({Point(0, 0, 1), Point(0, 0, 1), Point(0, 0, 1)}), 0.0, why),
            pair("a receiver with its corners on one line", floor,
                 Polygon({Point(0, 0, 1), Point(1, 0, 1), Point(2, 0, 1)}), 0.0, why),
            pair("a shooter without area", Polygon({Point(0, 0, 0), Point(1, 0, 0), Point(0.5, 0, 0)}),
                 onCeiling(0, 0, 1, 1, 1), 0.0, why)};
}

std::vector<HardCase> cutAndMoved() {
    const double half = 0.200043776075403;
    const Polygon a({Point(0), Point(1, 0, 0), Point(0, 1, 0)});
    const Polygon b({Point(.2, .1, 1), Point(.3, .9, 1.4), Point(1.2, .3, .8)});
    const double skew = 0.0794017110027708;
    const std::string digits = "double integral along the outlines, 50 digits";
    const Polygon halved = onFloor(-0.5, 0, 1, 1);
    std::vector<HardCase> all = {
        pair("a patch with its centre on the other's edge", halved, onWall(0, 0, 1, 1), 0.14618667910571332),
        pair("a patch with its centre on the other's corner", halved, onWall(.5, 0, 1, 1), 0.090517187705223526),
        pair("a patch with its centre on the other", halved, onWall(0, -1, 1, 2), 0.14618667910571332),
        pair("a quad with a corner 1e-3 off its plane", onFloor(0, 0, 1, 1),
             Polygon({Point(0, 0, 1), Point(0, 1, 1), Point(1, 1, 1.001), Point(1, 0, 1)}), 0.19975925069297057,
             digits),
        pair("a wall that goes on below the floor", onFloor(0, 0, 1, 1), onWall(0, -1, 1, 2), half),
        pair("a floor that goes on behind the wall", onFloor(-3, 0, 4, 1), onWall(0, 0, 1, 1), half / 4.0),
        pair("skew triangles", a, b, skew, digits),
        pair("skew triangles of 1e-6", moved(a, 1e-6, 0), moved(b, 1e-6, 0), skew, digits),
        pair("skew triangles of 1e6", moved(a, 1e6, 0), moved(b, 1e6, 0), skew, digits),
        pair("skew triangles, a million from the origin", moved(a, 1, 1e6), moved(b, 1, 1e6), skew, digits)};
    all.back().exact = 1e-8;  // so far off, doubles keep ten digits of a place
    return all;
}

std::vector<HardCase> occluded() {
    const Polygon floor = onFloor(0, 0, 1, 1), ceiling = onCeiling(0, 0, 1, 1, 1);
    const double open = 0.199824895698387;
    const std::string quarter = "closed form of a quarter hidden", all = "nothing or everything is hidden";
    const auto plate = [](double x, double y, double z, double size) {
        return std::vector<Polygon>{onCeiling(x, y, z, size, size), turned(onCeiling(x, y, z, size, size))};
    };
    return {
        blocked("a quarter at half the height over a corner", floor, ceiling, plate(0, 0, 0.5, 0.5), .149868671773790,
                quarter),
        blocked("a shadow that the other plate holds", onFloor(-1, -1, 2, 2), onCeiling(-1, -1, 1.0001, 2, 2),
                plate(-.45, -.45, .75, .9), .28285406835, "closed form less that of the shadow"),
        blocked("a plate that hides all", floor, ceiling, plate(-1, -1, 0.5, 3), 0.0, all),
        coincident(blocked("a plate that lies on the receiver", floor, ceiling, plate(-1, -1, 1.0, 3), open, all)),
        coincident(blocked("a plate that lies on the shooter", floor, ceiling, plate(-1, -1, 0.0, 3), open, all)),
        blocked("a plate beside", floor, ceiling, plate(3, 3, 0.5, 1), open, all),
        blocked("a plate exactly edge-on, beside both", floor, ceiling, {onWall(-1, 0, 4, 1)}, open, all),
        blocked("a wall from the middle of one to that of the other", floor, ceiling,
                {parallelogram({0.5, 0, 0}, {0, 1, 0}, {0, 0, 1})}, 0.1166536918036229, "closed form of both halves"),
        blocked("a wall through the middle of both", floor, ceiling,
                {parallelogram({0.5, -1, -1}, {0, 4, 0}, {0, 0, 4})}, 0.1166536918036229,
                "closed form of both halves")};
}

std::vector<HardCase> caseTable() {
    std::vector<HardCase> all;
    for (const std::vector<HardCase>& some : {wedges(), nearAndFar(), unequal(), nothing(), cutAndMoved(), occluded()})
        all.insert(all.end(), some.begin(), some.end());
    return all;
}

}  // namespace

const std::vector<HardCase>& hardCases() {
    static const std::vector<HardCase> cases = caseTable();
    return cases;
}

namespace {

// Of n pixels under a square, at most 2√n + 1 are counted too many or too few; those above have the largest share.
double hemicubeError(double truth) {
    const double size = FormFactorOptions{}.hemicubeSize, pixel = 4.0 / (std::numbers::pi * size * size);
    return 2.0 * std::sqrt(truth * pixel) + pixel;
}

}  // namespace

double allowedError(const HardCase& hard, Method method, std::size_t rays) {
    const auto count = static_cast<double>(rays);
    switch (method) {
        case Method::point:
        case Method::polygon:
            return hard.apart || (hard.truth == 0.0 && !hard.hidden) ? 1e-3 * hard.truth
                                                                     : std::numeric_limits<double>::infinity();
        case Method::hemicube:
            if (hard.truth == 0.0) return 0.0;
            return hard.apart ? 1e-3 * hard.truth + hemicubeError(hard.truth) : std::numeric_limits<double>::infinity();
        case Method::hemisphere:
            if (hard.coincident) return std::numeric_limits<double>::infinity();
            return 4.0 * std::sqrt(hard.truth * (1.0 - hard.truth) / count) + 4.0 / count;
        case Method::visibility:
            if (hard.hidden) return hard.truth * 2.0 / std::sqrt(count);
            [[fallthrough]];
        default:
            return hard.hidden && method == Method::exact ? std::numeric_limits<double>::infinity()
                                                          : hard.exact * hard.truth;
    }
}

double formFactorOf(const HardCase& hard, Method method, std::size_t rays) {
    FormFactorOptions options;
    options.method = method;
    options.rays = rays;
    options.tolerance = finestTolerance;
    return formFactors(hard.geometry, options).at(0, 1);
}

}  // namespace radlab::engine

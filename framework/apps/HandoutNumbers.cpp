#include "apps/HandoutNumbers.h"

#include <cmath>
#include <cstdio>

#include "apps/HandoutScene.h"
#include "base/NumberText.h"
#include "course/Hemicube.h"
#include "engine/ExchangeArea.h"
#include "engine/FormFactorRows.h"
#include "engine/PointFormFactor.h"

namespace radlab {

namespace {

using namespace engine;
using Json = nlohmann::ordered_json;

// With commas from a thousand on.
std::string rounded(double value) {
    return value < 1000.0 ? numberText("%.3g", value) : withCommas(static_cast<std::size_t>(std::lround(value)));
}

// As TeX has it: 1.94 times a power of ten.
std::string scientific(double value) {
    const int power = static_cast<int>(std::floor(std::log10(value)));
    return "$" + numberText("%.2f", value / std::pow(10.0, power)) + "\\cdot 10^{" + std::to_string(power) + "}$";
}

const Point right(1.0, 0.0, 0.0), up(0.0, 1.0, 0.0), out(0.0, 0.0, 1.0);

// A form factor by the point to point formula, from the centre to the whole, and exactly.
void addPair(Json& numbers, const std::string& name, const Polygon& from, const Polygon& to) {
    const double exact = exchangeArea(from, to) / from.area, point = pointToPoint(from, to);
    const double centre = pointToPolygon(from.center, from.normal, to);
    numbers[name + "_exact"] = numberText("%.4f", exact);
    numbers[name + "_point"] = numberText("%.4f", point);
    numbers[name + "_centre"] = numberText("%.4f", centre);
    numbers[name + "_point_error"] = rounded(100.0 * std::abs(point / exact - 1.0)) + " %";
    numbers[name + "_centre_error"] = numberText("%.2g %%", 100.0 * std::abs(centre / exact - 1.0));
}

void addPairs(Json& numbers) {
    const Polygon floor = unitSquare(Point(0.0), right, up);
    for (const auto& [name, distance] : {std::pair{"gap_tenth", 0.1}, {"gap_1", 1.0}, {"gap_3", 3.0}, {"gap_10", 10.0}})
        addPair(numbers, name, floor, unitSquare(distance * out, up, right));
    addPair(numbers, "corner", floor, unitSquare(Point(-0.5, 0.0, 0.5), up, out));
}

// The largest sum of a row by the point to point formula: over 1 in corners.
void addRowSum(Json& numbers, const std::string& name, float patchSize) {
    const HandoutScene room("cornell_1", patchSize);
    const FormFactorRows rows(room.geometry, handoutMethod(Method::point));
    std::vector<double> factors(room.geometry.patches.size());
    double highest = 0.0;
    for (std::size_t i = 0; i < factors.size(); ++i) {
        rows.row(i, factors.data());
        double sum = 0.0;
        for (const double factor : factors) sum += factor;
        highest = std::max(highest, sum);
    }
    numbers[name + "_patches"] = withCommas(factors.size());
    numbers[name + "_highest_sum"] = numberText("%.3f", highest);
}

void addMesh(Json& numbers, const std::string& name, float patchSize) {
    const HandoutScene room("cornell_2", patchSize);
    numbers[name + "_patches"] = withCommas(room.mesh.patches.size());
    numbers[name + "_vertices"] = withCommas(room.mesh.corners.size());
    numbers[name + "_matrix"] = rounded(matrixBytes(static_cast<double>(room.mesh.patches.size())) / 1e6);
}

void addHemicube(Json& numbers) {
    const Hemicube large(256), small(8);
    numbers["delta_256_top"] = scientific(static_cast<double>(large.getDeltaFormFactor(256, 256)));
    numbers["delta_256_rim"] = scientific(static_cast<double>(large.getDeltaFormFactor(0, 256)));
    numbers["delta_256_ratio"] =
        numberText("%.0f", static_cast<double>(large.getDeltaFormFactor(256, 256) / large.getDeltaFormFactor(0, 256)));
    double top = 0.0;
    for (int y = 128; y < 384; ++y)
        for (int x = 128; x < 384; ++x) top += static_cast<double>(large.getDeltaFormFactor(x, y));
    numbers["delta_top_share"] = numberText("%.1f %%", 100.0 * top);
    numbers["delta_side_share"] = numberText("%.1f %%", 100.0 * (1.0 - top) / 4.0);
    Json& table = numbers["delta_8_table"] = Json::array();
    for (int y = 0; y < small.rendersize; ++y)
        for (int x = 0; x < small.rendersize; ++x)
            table.push_back(std::round(1e5 * static_cast<double>(small.getDeltaFormFactor(x, y))) / 1e5);
}

}  // namespace

nlohmann::ordered_json handoutNumbers() {
    Json numbers;
    addPairs(numbers);
    addRowSum(numbers, "rows_100", 100.0f);
    addRowSum(numbers, "rows_50", 50.0f);
    addRowSum(numbers, "rows_25", 25.0f);
    addMesh(numbers, "mesh_100", 100.0f);
    addMesh(numbers, "mesh_50", 50.0f);
    addMesh(numbers, "mesh_25", 25.0f);
    addMesh(numbers, "mesh_12", 12.5f);
    addHemicube(numbers);
    return numbers;
}

}  // namespace radlab

#include "apps/HandoutCurves.h"

#include <cmath>
#include <functional>
#include <random>

#include "apps/HandoutScene.h"
#include "base/NumberText.h"
#include "base/ProgressBar.h"
#include "base/WholeFile.h"
#include "course/ProgRef.h"
#include "engine/ExchangeArea.h"
#include "engine/FormFactorRows.h"
#include "engine/PointFormFactor.h"
#include "engine/Radiosity.h"
#include "engine/RelativeError.h"
#include "solver/Progressive.h"

namespace radlab {

namespace {

using namespace engine;
using Json = nlohmann::ordered_json;

std::string line(std::initializer_list<double> values) {
    std::string written;
    for (const double value : values) written += numberText("%.6g ", value);
    written.back() = '\n';
    return written;
}

// Facing unit squares: how far two simple formulas are off, over the distance.
void writePoint(const std::filesystem::path& file) {
    const Point right(1.0, 0.0, 0.0), up(0.0, 1.0, 0.0);
    std::string table;
    const Polygon from = unitSquare(Point(0.0), right, up);
    for (double distance = 0.1; distance < 31.0; distance *= 1.1) {
        const Polygon to = unitSquare(Point(0.0, 0.0, distance), up, right);
        const double exact = exchangeArea(from, to);
        table += line({distance, std::abs(pointToPoint(from, to) / exact - 1.0),
                       std::abs(pointToPolygon(from.center, from.normal, to) / exact - 1.0)});
    }
    writeFile(file, table);
}

// Which patch shoots next.
using Order = std::function<MyPolygon*(int shot)>;

// The unshot share after each shot, where patches shoot in that order.
std::vector<double> unshotBy(HandoutScene& room, const Order& order, int shots) {
    room.mesh.publish();
    room.mesh.reset();
    const FormFactorRows rows(room.geometry, handoutMethod(Method::point));
    std::vector<double> factors(polygons.size()), shares;
    int shot = 0;
    Progressive solver(room.mesh, [&] {
        MyPolygon* shooter = order(shot++);
        rows.row(static_cast<std::size_t>(shooter - room.mesh.patches.data()), factors.data());
        for (std::size_t i = 0; i < factors.size(); ++i) polygons[i]->formF = static_cast<float>(factors[i]);
        return shooter;
    });
    for (int i = 0; i < shots; ++i) {
        solver.shoot();  // a shot of nothing is paid for, too
        shares.push_back(solver.progress().unshotShare);
    }
    return shares;
}

std::string shotsUntil(const std::vector<double>& shares, double share) {
    for (std::size_t i = 0; i < shares.size(); ++i)
        if (shares[i] <= share) return std::to_string(i + 1);
    return "more than " + std::to_string(shares.size());
}

void writeOrders(const std::filesystem::path& file, Json& numbers) {
    HandoutScene room("cornell_1", 55.0f);
    const auto count = room.mesh.patches.size();
    std::minstd_rand random(1);  // the same numbers on every machine
    const int shots = 3000;
    const std::vector<double> brightest = unshotBy(
        room, [](int) { return maxenergy_patch(); }, shots);
    const std::vector<double> inTurn = unshotBy(
        room, [&](int shot) { return polygons[static_cast<std::size_t>(shot) % count]; }, shots);
    const std::vector<double> drawn = unshotBy(
        room, [&](int) { return polygons[random() % count]; }, shots);
    std::string table;
    for (int i = 0; i < shots; i += i < 100 ? 1 : 10) {
        const auto at = static_cast<std::size_t>(i);
        table += line({i + 1.0, brightest[at], inTurn[at], drawn[at]});
    }
    writeFile(file, table);
    numbers["orders_patches"] = std::to_string(count);
    numbers["orders_brightest"] = shotsUntil(brightest, 0.1);
    numbers["orders_in_turn"] = shotsUntil(inTurn, 0.1);
    numbers["orders_drawn"] = shotsUntil(drawn, 0.1);
}

struct Quality {
    double error = 0.0;         // of the form factors: root of the mean square, over that of the truth
    double missed = 0.0;        // share of the pairs above a millionth that are 0
    double light = 0.0;         // relative error of the radiosities
    double milliseconds = 0.0;  // a row
};

std::vector<Point> lightOf(const HandoutScene& room, const FormFactorMatrix& factors) {
    return solveRadiosity(transportOf(factors), surfacesOf(room.mesh));
}

// What is compared with: exact form factors, what the patches' centres see, the light.
struct Truth {
    explicit Truth(const HandoutScene& room)
        : exact(formFactors(room.geometry, handoutMethod(Method::visibility, 1024))),
          centre(formFactors(room.geometry, handoutMethod(Method::hemicube, 0, 1024))),
          light(lightOf(room, exact)) {}

    FormFactorMatrix exact, centre;
    std::vector<Point> light;
};

double errorOf(const FormFactorMatrix& found, const FormFactorMatrix& truth) {
    double squares = 0.0, ofTruth = 0.0;
    for (std::size_t i = 0; i < truth.size(); ++i) {
        for (std::size_t j = 0; j < truth.size(); ++j) {
            squares += std::pow(found.at(i, j) - truth.at(i, j), 2.0);
            ofTruth += truth.at(i, j) * truth.at(i, j);
        }
    }
    return std::sqrt(squares / ofTruth);
}

double missedBy(const FormFactorMatrix& found, const FormFactorMatrix& truth) {
    double missed = 0.0, seen = 0.0;
    for (std::size_t i = 0; i < truth.size(); ++i) {
        for (std::size_t j = 0; j < truth.size(); ++j) {
            if (truth.at(i, j) <= 1e-6) continue;
            seen += 1.0;
            missed += found.at(i, j) == 0.0 ? 1.0 : 0.0;
        }
    }
    return missed / seen;
}

Quality qualityOf(const HandoutScene& room, const FormFactorOptions& options, const Truth& truth) {
    FormFactorReport report;
    FormFactorMatrix found = formFactors(room.geometry, options, &report);
    const bool centre = options.method == Method::hemicube;
    Quality quality;
    quality.error = errorOf(found, truth.exact);
    quality.missed = missedBy(found, centre ? truth.centre : truth.exact);
    quality.milliseconds = 1e3 * report.seconds / static_cast<double>(found.size());
    makeReciprocal(found);
    quality.light = relativeError(found.areas(), lightOf(room, found), truth.light);
    return quality;
}

void addQuality(Json& numbers, const std::string& name, const Quality& quality) {
    numbers[name + "_error"] = numberText("%.2g %%", 100.0 * quality.error);
    numbers[name + "_missed"] = numberText("%.2g %%", 100.0 * quality.missed);
    numbers[name + "_light"] = numberText("%.2g %%", 100.0 * quality.light);
    numbers[name + "_ms"] = numberText("%.2g", quality.milliseconds);
}

std::string line(double setting, const Quality& quality, double samples) {
    return line({setting, quality.error, quality.missed, quality.milliseconds, samples, quality.light});
}

// What size and rays buy, in the furnished box.
void writeSampling(const std::filesystem::path& folder, Json& numbers) {
    const HandoutScene room("cornell_2", 44.0f);
    ProgressBar bar("form factors by hemicube and hemisphere", 12.0, "matrices");
    const Truth truth(room);
    numbers["sampling_patches"] = std::to_string(truth.exact.size());
    std::string hemicubes, hemispheres;
    double done = 1.0;
    for (int size = 16; size <= 512; size *= 2) {
        const Quality quality = qualityOf(room, handoutMethod(Method::hemicube, 0, size), truth);
        hemicubes += line(size, quality, 3.0 * size * size);
        addQuality(numbers, "hemicube_" + std::to_string(size), quality);
        bar.show(done += 1.0);
    }
    for (std::size_t rays = 256; rays <= 16384; rays *= 4) {
        const Quality quality = qualityOf(room, handoutMethod(Method::hemisphere, rays), truth);
        hemispheres += line(static_cast<double>(rays), quality, static_cast<double>(rays));
        addQuality(numbers, "hemisphere_" + std::to_string(rays), quality);
        bar.show(done += 1.0);
    }
    writeFile(folder / "hemicube.dat", hemicubes);
    writeFile(folder / "hemisphere.dat", hemispheres);
}

}  // namespace

nlohmann::ordered_json writeHandoutCurves(const std::filesystem::path& folder) {
    Json numbers;
    writePoint(folder / "point.dat");
    writeOrders(folder / "orders.dat", numbers);
    writeSampling(folder, numbers);
    return numbers;
}

}  // namespace radlab

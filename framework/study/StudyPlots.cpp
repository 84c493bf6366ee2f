#include "study/StudyPlots.h"

#include <algorithm>
#include <cstdio>
#include <functional>

#include "study/PowerFit.h"

namespace radlab::study {

namespace {

using Rows = std::vector<const Measurement*>;

// Where a row is drawn; a coordinate of 0 where it is not.
using PointOf = std::function<glm::dvec2(const Measurement&)>;

// Its own curve of the plot's for each method, points from left to right.
std::vector<Curve> curvesOf(const Rows& rows, const PointOf& pointOf) {
    std::vector<Curve> curves;
    for (const Measurement* row : rows) {
        const glm::dvec2 point = pointOf(*row);
        if (!(point.x > 0.0) || !(point.y > 0.0)) continue;
        auto curve =
            std::find_if(curves.begin(), curves.end(), [&](const Curve& c) { return c.method == row->method; });
        if (curve == curves.end()) curve = curves.insert(curve, {row->method, row->method, {}});
        curve->points.push_back(point);
    }
    for (Curve& curve : curves)
        std::stable_sort(curve.points.begin(), curve.points.end(),
                         [](const glm::dvec2& a, const glm::dvec2& b) { return a.x < b.x; });
    return curves;
}

// Against patches: the setting of each method that was measured at several numbers of them.
Plot growthPlot(const std::string& file, const Rows& rows, const Axis& y,
                const std::function<double(const Measurement&)>& valueOf) {
    Plot plot{file, {"patches", Unit::count}, y, {}, {}};
    plot.curves = curvesOf(
        rows, [&](const Measurement& row) { return glm::dvec2(static_cast<double>(row.patches), valueOf(row)); });
    std::erase_if(plot.curves, [](const Curve& curve) { return !fitPower(curve.points); });
    for (Curve& curve : plot.curves) {
        char text[32];
        std::snprintf(text, sizeof text, ", n^%.2f", fitPower(curve.points)->exponent);
        curve.label += text;
    }
    return plot;
}

// The rows of settings that were measured at another number of patches, too.
Rows comparedOverPatches(const Rows& rows, const StudyPlan& plan) {
    Rows compared;
    for (const Measurement* row : rows) {
        const bool elsewhere = std::any_of(rows.begin(), rows.end(), [&](const Measurement* other) {
            return other->wanted != plan.patches && other->method == row->method && other->setting == row->setting;
        });
        if (elsewhere) compared.push_back(row);
    }
    return compared;
}

// Error against seconds.
Plot errorPlot(const std::string& file, const Rows& joined, const Rows& loose, const ErrorKind& error) {
    const PointOf pointOf = [&error](const Measurement& row) {
        return glm::dvec2(row.seconds, error.of(row).value_or(0.0));
    };
    Plot plot{file, {"time", Unit::seconds}, {"error (RMS over RMS)", Unit::share}, {}, {}};
    plot.curves = curvesOf(joined, pointOf);
    for (Curve& others : curvesOf(loose, pointOf)) {
        const auto same = std::find_if(plot.curves.begin(), plot.curves.end(),
                                       [&](const Curve& curve) { return curve.method == others.method; });
        if (same != plot.curves.end())
            same->loose = std::move(others.points);
        else
            plot.curves.push_back(std::move(others));
    }
    Rows all = joined;
    all.insert(all.end(), loose.begin(), loose.end());
    for (const Measurement* row : bestRows(all, error)) plot.front.push_back(pointOf(*row));
    return plot;
}

}  // namespace

Plot wholePlot(const std::string& file, const Rows& rows, const StudyPlan& plan) {
    const Rows joined = comparedOverPatches(rows, plan);
    Rows loose;
    for (const Measurement* row : rows)
        if (std::find(joined.begin(), joined.end(), row) == joined.end()) loose.push_back(row);
    return errorPlot(file, joined, loose, wholeError);
}

Plot solverPlot(const std::string& file, const Rows& rows) { return errorPlot(file, rows, {}, solverError); }

Plot shotsPlot(const std::string& file, const Rows& rows) {
    Plot plot{file, {"shots", Unit::count}, {"error of the solver (RMS over RMS)", Unit::share}, {}, {}};
    plot.curves = curvesOf(rows, [](const Measurement& row) {
        return glm::dvec2(static_cast<double>(row.shots), solverError.of(row).value_or(0.0));
    });
    return plot;
}

Plot secondsPlot(const std::string& file, const Rows& rows, const StudyPlan& plan) {
    return growthPlot(file, comparedOverPatches(rows, plan), {"time", Unit::seconds},
                      [](const Measurement& row) { return row.seconds; });
}

Plot memoryPlot(const std::string& file, const Rows& rows, const StudyPlan& plan) {
    constexpr double least = 1e6;  // bytes: what grows by less is lost in what the program holds anyway
    return growthPlot(file, comparedOverPatches(rows, plan), {"memory", Unit::bytes},
                      [](const Measurement& row) { return row.bytes.value_or(0.0) < least ? 0.0 : *row.bytes; });
}

}  // namespace radlab::study

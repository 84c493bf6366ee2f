#include "engine/FormFactors.h"

#include <algorithm>
#include <array>

#include "base/Error.h"
#include "base/Stopwatch.h"
#include "engine/FormFactorRows.h"

namespace radlab::engine {

namespace {

struct Named {
    const char* name;
    Method method;
};

constexpr std::array<Named, 7> names = {{{"point", Method::point},
                                         {"polygon", Method::polygon},
                                         {"exact", Method::exact},
                                         {"hemicube", Method::hemicube},
                                         {"hemisphere", Method::hemisphere},
                                         {"visibility", Method::visibility},
                                         {"auto", Method::automatic}}};

// Both entries of a pair are written by the row of the first.
void fillPairs(FormFactorMatrix& matrix, const FormFactorRows& rows, const Progress& progress) {
    const std::vector<double>& areas = matrix.areas();
    forAll(matrix.size(), progress, [&](std::size_t i) {
        for (std::size_t j = i + 1; j < matrix.size(); ++j) {
            const double area = rows.exchange(i, j);
            if (area <= 0.0) continue;
            matrix.at(i, j) = area / areas[i];
            matrix.at(j, i) = area / areas[j];
        }
    });
}

}  // namespace

Method methodNamed(const std::string& name) {
    std::string known;
    for (const Named& one : names) {
        if (name == one.name) return one.method;
        known += (known.empty() ? "" : ", ") + std::string(one.name);
    }
    throw Error("method: found '" + name + "', expected one of " + known);
}

std::string nameOf(Method method) {
    return std::find_if(names.begin(), names.end(), [=](const Named& one) { return one.method == method; })->name;
}

bool isReciprocal(Method method) {
    return method != Method::polygon && method != Method::hemicube && method != Method::hemisphere;
}

bool seesOcclusion(Method method) {
    return method != Method::point && method != Method::polygon && method != Method::exact;
}

FormFactorOptions settled(FormFactorOptions options) {
    if (options.method == Method::automatic) options.method = options.occlusion ? Method::visibility : Method::exact;
    if (options.rays == 0) options.rays = options.method == Method::hemisphere ? hemisphereRays : pairRays;
    return options;
}

FormFactorMatrix formFactors(const Geometry& geometry, const FormFactorOptions& options, FormFactorReport* report) {
    const Stopwatch watch;
    FormFactorMatrix matrix(geometry.patches);
    const FormFactorRows rows(geometry, options);
    if (isReciprocal(rows.method()))
        fillPairs(matrix, rows, options.progress);
    else
        forAll(matrix.size(), options.progress, [&](std::size_t i) { rows.row(i, &matrix.at(i, 0)); });
    if (report) *report = {rows.method(), rows.rays(), watch.seconds()};
    return matrix;
}

}  // namespace radlab::engine

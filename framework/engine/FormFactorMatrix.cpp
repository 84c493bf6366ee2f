#include "engine/FormFactorMatrix.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <new>

#include <tbb/parallel_for.h>

#include "base/Interrupts.h"
#include "base/Memory.h"

namespace radlab::engine {

namespace {

constexpr double closedWithin = 0.02;
constexpr int mostRounds = 1000;
constexpr double enough = 1e-12;

// All pairs i < j, tile by tile: both F(i→j) and F(j→i) are then near in memory.
template <class Visit>
void forPairs(std::size_t count, const Visit& visit) {
    constexpr std::size_t tile = 64;
    for (std::size_t top = 0; top < count; top += tile)
        for (std::size_t left = top; left < count; left += tile)
            for (std::size_t i = top; i < std::min(top + tile, count); ++i) {
                Interrupts::check();
                for (std::size_t j = std::max(left, i + 1); j < std::min(left + tile, count); ++j) visit(i, j);
            }
}

std::vector<double> sumsOf(const FormFactorMatrix& matrix, const std::vector<double>& weights) {
    std::vector<double> sums(matrix.size());
    tbb::parallel_for(std::size_t{0}, matrix.size(), [&](std::size_t i) {
        Interrupts::check();
        const double* row = matrix.row(i);
        double sum = 0.0;
        for (std::size_t j = 0; j < matrix.size(); ++j) sum += weights[j] * row[j];
        sums[i] = sum;
    });
    return sums;
}

std::vector<double> rowSums(const FormFactorMatrix& matrix) {
    return sumsOf(matrix, std::vector<double>(matrix.size(), 1.0));
}

bool isClosed(const std::vector<double>& sums) {
    double mean = 0.0;
    for (const double sum : sums) mean += sum / static_cast<double>(sums.size());
    return std::abs(mean - 1.0) <= closedWithin;
}

double deviation(const std::vector<double>& sums, const std::vector<double>& targets) {
    double worst = 0.0;
    for (std::size_t i = 0; i < sums.size(); ++i)
        if (sums[i] > 0.0) worst = std::max(worst, std::abs(sums[i] - targets[i]));
    return worst;
}

}  // namespace

FormFactorMatrix::FormFactorMatrix(const std::vector<Polygon>& patches) {
    requireMemory(matrixBytes(static_cast<double>(patches.size())),
                  "the form factors of " + std::to_string(patches.size()) + " patches",
                  "take larger patches, or a way that stores no matrix (render: --method links, or --unshot)");
    for (const Polygon& patch : patches) patchAreas.push_back(patch.area);
    factors.reset(static_cast<double*>(std::calloc(std::max<std::size_t>(size() * size(), 1), sizeof(double))));
    if (!factors) throw std::bad_alloc();
}

MatrixQuality qualityOf(const FormFactorMatrix& matrix) {
    MatrixQuality quality;
    const std::size_t count = matrix.size();
    if (count == 0) return quality;
    const std::vector<double> sums = rowSums(matrix);
    const auto highest = std::max_element(sums.begin(), sums.end());
    quality.highestSum = *highest;
    quality.highestRow = static_cast<std::size_t>(highest - sums.begin());
    quality.lowestSum = *std::min_element(sums.begin(), sums.end());
    for (const double sum : sums) quality.meanSum += sum / static_cast<double>(count);
    const std::vector<double>& areas = matrix.areas();
    forPairs(count, [&](std::size_t i, std::size_t j) {
        const double smaller = std::min(areas[i], areas[j]);
        if (smaller <= 0.0) return;
        const double off = std::abs(areas[i] * matrix.at(i, j) - areas[j] * matrix.at(j, i)) / smaller;
        if (off <= quality.reciprocity) return;
        quality.reciprocity = off;
        quality.worstI = i;
        quality.worstJ = j;
    });
    return quality;
}

std::string describe(const MatrixQuality& quality) {
    char text[400];
    std::snprintf(text, sizeof text,
                  "rows add up to %.6g at least, %.6g on average, %.6g at most (patch %zu)\n"
                  "reciprocity holds within %.2g (worst: patches %zu and %zu)",
                  quality.lowestSum, quality.meanSum, quality.highestSum, quality.highestRow, quality.reciprocity,
                  quality.worstI, quality.worstJ);
    return text;
}

void makeReciprocal(FormFactorMatrix& matrix) {
    const std::vector<double>& areas = matrix.areas();
    forPairs(matrix.size(), [&](std::size_t i, std::size_t j) {
        const double exchange = 0.5 * (areas[i] * matrix.at(i, j) + areas[j] * matrix.at(j, i));
        matrix.at(i, j) = areas[i] > 0.0 ? exchange / areas[i] : 0.0;
        matrix.at(j, i) = areas[j] > 0.0 ? exchange / areas[j] : 0.0;
    });
}

double enforceLaws(FormFactorMatrix& matrix) {
    std::vector<double> scale(matrix.size(), 1.0), targets(matrix.size(), 1.0);
    const bool closed = isClosed(rowSums(matrix));
    makeReciprocal(matrix);
    std::vector<double> sums = rowSums(matrix);
    if (!closed)
        for (std::size_t i = 0; i < targets.size(); ++i) targets[i] = std::min(sums[i], 1.0);
    // The matrix sought is K·F·K with K diagonal: each round takes the mean, in logarithms, of the step that
    // would set a row right and of none, which keeps the rounds from swinging.
    double worst = deviation(sums, targets);
    for (int round = 0; round < mostRounds && worst > enough; ++round) {
        for (std::size_t i = 0; i < scale.size(); ++i)
            if (sums[i] > 0.0) scale[i] *= std::sqrt(targets[i] / sums[i]);
        sums = sumsOf(matrix, scale);
        for (std::size_t i = 0; i < scale.size(); ++i) sums[i] *= scale[i];
        worst = deviation(sums, targets);
    }
    tbb::parallel_for(std::size_t{0}, matrix.size(), [&](std::size_t i) {
        for (std::size_t j = 0; j < matrix.size(); ++j) matrix.at(i, j) *= scale[i] * scale[j];
    });
    return worst;
}

}  // namespace radlab::engine

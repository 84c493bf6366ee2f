#include "grader/stages/ExponentFit.h"

#include <Eigen/Dense>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "base/Error.h"

namespace radlab::grader {

namespace {

constexpr double leftOver = 1e-3;
constexpr std::size_t samplesPerUnknown = 3;

struct Fit {
    double constant = 0.0;  // logarithm
    std::vector<double> exponents;
};

double halves(double x) { return std::round(2.0 * x) / 2.0; }

std::optional<Fit> leastSquares(const std::vector<double>& ratios, const std::vector<Factor>& factors) {
    const auto rows = static_cast<Eigen::Index>(ratios.size()), columns = static_cast<Eigen::Index>(factors.size());
    if (ratios.size() < samplesPerUnknown * (factors.size() + 1)) return std::nullopt;
    Eigen::MatrixXd matrix(rows, columns + 1);
    matrix.col(0).setOnes();
    for (Eigen::Index f = 0; f < columns; ++f) {
        const std::vector<double>& logs = factors[static_cast<std::size_t>(f)].logs;
        RADLAB_CHECK(logs.size() == ratios.size());
        matrix.col(f + 1) = Eigen::Map<const Eigen::VectorXd>(logs.data(), rows);
    }
    const Eigen::Map<const Eigen::VectorXd> right(ratios.data(), rows);
    const Eigen::VectorXd solution = matrix.completeOrthogonalDecomposition().solve(right);
    Fit fit;
    for (Eigen::Index f = 0; f < columns; ++f) fit.exponents.push_back(halves(solution(f + 1)));
    const Eigen::Map<const Eigen::VectorXd> rounded(fit.exponents.data(), columns);
    const Eigen::VectorXd rest = right - matrix.rightCols(columns) * rounded;
    fit.constant = rest.mean();
    if (!((rest.array() - fit.constant).abs().maxCoeff() < leftOver)) return std::nullopt;
    return fit;
}

std::string shortNumber(double x) {
    char text[32];
    std::snprintf(text, sizeof text, "%.4g", x);
    return text;
}

std::string power(const std::string& base, int exponent) {
    return exponent == 1 ? base : base + (exponent == 2 ? "²" : exponent == 3 ? "³" : "^" + std::to_string(exponent));
}

// "2π", "1/π", "1/(4π²)", or digits where it is no product of powers of 2 and π.
std::string constantText(double logarithm) {
    for (const int pi : {0, 1, -1, 2, -2})
        for (const int two : {0, 1, -1, 2, -2, 3, -3}) {
            if (std::abs(logarithm - pi * std::log(std::numbers::pi) - two * std::log(2.0)) > leftOver) continue;
            const std::string above = (two > 0 ? std::to_string(1 << two) : "") + (pi > 0 ? power("π", pi) : "");
            const std::string below = (two < 0 ? std::to_string(1 << -two) : "") + (pi < 0 ? power("π", -pi) : "");
            const bool product = two < 0 && pi < 0;
            return (above.empty() ? "1" : above) + (below.empty() ? "" : "/" + (product ? "(" + below + ")" : below));
        }
    return shortNumber(std::exp(logarithm));
}

std::string powerOf(const std::string& symbol, double exponent) {
    const double size = std::abs(exponent);
    const std::string written = size == 1   ? symbol
                                : size == 2 ? symbol + "²"
                                : size == 3 ? symbol + "³"
                                            : symbol + "^" + shortNumber(size);
    return exponent < 0 ? "1/" + written : written;
}

std::string wrongFactor(const Factor& factor, double deviation) {
    const double exponent = factor.right + deviation;
    if (!factor.symbol.empty() && factor.right < 0 && exponent < 0)
        return "it falls as " + powerOf(factor.symbol, exponent) + ", not " + powerOf(factor.symbol, factor.right);
    if (exponent == 0) return factor.name + " is missing";
    if (factor.right == 0)
        return factor.name + (exponent < 0 ? " divides, and should not be there" : " is a factor too many");
    if (exponent == 2 * factor.right) return factor.name + " is squared";
    if (exponent == -factor.right)
        return factor.name +
               (exponent > 0 ? " multiplies where it should divide" : " divides where it should multiply");
    return factor.name + " has the power " + shortNumber(exponent) + ", not " + shortNumber(factor.right);
}

}  // namespace

std::optional<Diagnosis> fitExponents(const std::vector<double>& logRatios, const std::vector<Factor>& factors) {
    const std::optional<Fit> fit = leastSquares(logRatios, factors);
    if (!fit) return std::nullopt;
    std::string faults;
    const auto add = [&](const std::string& fault) { faults += (faults.empty() ? "" : "; ") + fault; };
    for (std::size_t f = 0; f < factors.size(); ++f)
        if (fit->exponents[f] != 0.0) add(wrongFactor(factors[f], fit->exponents[f]));
    if (std::abs(fit->constant) > leftOver) add("all is " + constantText(fit->constant) + " times what it should be");
    if (faults.empty()) return std::nullopt;
    return Diagnosis{"exponents", "Your numbers follow the formula but for this: " + faults + ".",
                     "Write your formula and that of the task one under the other, and compare them factor by factor."};
}

}  // namespace radlab::grader

#include "engine/EdgeIntegral.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>

#include "engine/GaussLegendre.h"

namespace radlab::engine {

namespace {

constexpr double bernstein =
    3.4;  // Gauss's error on a panel is a small part of it times 3.4 to the power of minus twice the nodes
constexpr int mostHalvings = 60;
constexpr double parallelSine = 1e-12;

// Second antiderivative of ½ ln(u² + d²) by u.
double twiceIntegrated(double u, double d) {
    const double r2 = u * u + d * d;
    if (r2 == 0.0) return 0.0;
    return 0.25 * (u * u - d * d) * std::log(r2) + d * u * std::atan2(u, d) - 0.75 * u * u;
}

// Antiderivative of ½ ln(t² + d²) by t, but for its part with the arc tangent.
double logPart(double t, double d2) {
    const double r2 = t * t + d2;
    return r2 > 0.0 ? 0.5 * t * std::log(r2) - t : 0.0;
}

// ∫ ln |p - y| over the edge from y0 in the direction of a unit vector.
double innerIntegral(const Point& p, const Point& begin, const Point& direction, double length) {
    const Point from = begin - p;
    const double t0 = glm::dot(from, direction), t1 = t0 + length;
    const Point across = from - t0 * direction;
    const double d2 = glm::dot(across, across), d = std::sqrt(d2);
    return logPart(t1, d2) - logPart(t0, d2) + d * std::atan2(d * length, d2 + t0 * t1);
}

class OuterIntegral {
public:
    OuterIntegral(const Edge& along, double length, const Edge& other, double otherLength, double tolerance)
        : rule(gaussLegendre(static_cast<int>(std::ceil(-0.5 * std::log(tolerance) / std::log(bernstein))))),
          begin(along.begin),
          direction((along.end - along.begin) / length),
          otherBegin(other.begin),
          otherDirection((other.end - other.begin) / otherLength),
          inner(otherLength) {
        singularities[0] = atPoint(other.begin);
        singularities[1] = atPoint(other.end);
        singularities[2] = atLine();
    }

    double over(double from, double to, int halvings = 0) const {
        const double middle = 0.5 * (from + to), half = 0.5 * (to - from);
        if (halvings == mostHalvings || isSmooth(middle, half)) return gauss(from, to - from);
        return over(from, middle, halvings + 1) + over(middle, to, halvings + 1);
    }

private:
    using Complex = std::complex<double>;

    Complex atPoint(const Point& point) const {
        const Point from = point - begin;
        const double along = glm::dot(from, direction);
        return {along, glm::length(from - along * direction)};
    }

    // Where the distance to the other line is 0.
    Complex atLine() const {
        const Point from = begin - otherBegin;
        const Point across = direction - glm::dot(direction, otherDirection) * otherDirection;
        const Point apart = from - glm::dot(from, otherDirection) * otherDirection;
        const double a = glm::dot(across, across);
        const double nearest = -glm::dot(apart, across) / a;
        return {nearest, glm::length(apart + nearest * across) / std::sqrt(a)};
    }

    // Gauss's error falls as the size of the largest ellipse around the panel that no singularity lies in.
    bool isSmooth(double middle, double half) const {
        return std::all_of(singularities.begin(), singularities.end(), [&](const Complex& singularity) {
            const Complex w = (singularity - middle) / half;
            return std::abs(w + std::sqrt(w - 1.0) * std::sqrt(w + 1.0)) >= bernstein;
        });
    }

    double gauss(double from, double length) const {
        double sum = 0.0;
        for (const GaussNode& node : rule)
            sum += node.weight * innerIntegral(begin + (from + node.position * length) * direction, otherBegin,
                                               otherDirection, inner);
        return sum * length;
    }

    const std::vector<GaussNode>& rule;
    Point begin, direction, otherBegin, otherDirection;
    double inner;
    std::array<Complex, 3> singularities;
};

double ofParallels(const Edge& a, double lengthA, const Edge& b, const Point& direction) {
    const Point from = b.begin - a.begin;
    const double along = glm::dot(from, direction), along2 = glm::dot(b.end - a.begin, direction);
    const double low = std::min(along, along2), high = std::max(along, along2);
    const double d = glm::length(from - along * direction);
    return twiceIntegrated(high, d) - twiceIntegrated(high - lengthA, d) - twiceIntegrated(low, d) +
           twiceIntegrated(low - lengthA, d);
}

}  // namespace

double edgeIntegral(const Edge& a, const Edge& b, double tolerance) {
    const double lengthA = glm::length(a.end - a.begin), lengthB = glm::length(b.end - b.begin);
    if (lengthA == 0.0 || lengthB == 0.0) return 0.0;
    if (lengthA > lengthB) return edgeIntegral(b, a, tolerance);
    const Point direction = (a.end - a.begin) / lengthA;
    if (glm::length(glm::cross(direction, (b.end - b.begin) / lengthB)) < parallelSine)
        return ofParallels(a, lengthA, b, direction);
    return OuterIntegral(a, lengthA, b, lengthB, tolerance).over(0.0, lengthA);
}

}  // namespace radlab::engine

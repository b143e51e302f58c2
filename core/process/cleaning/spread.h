// The middle of numbers and how far they spread about it, whatever a minority of them is.
#pragma once

#include "core/base/ranked.h"

#include <cmath>
#include <vector>

namespace process {

/// Standard deviation over median absolute deviation, of a normal distribution.
inline constexpr double deviationOverMad = 1.4826;
/// Standard deviations at which Tukey's biweight is zero: 95 % as efficient as least squares where nothing is wrong.
inline constexpr double robustReach = 4.685;

struct Spread {
    double median = 0, deviation = 0;
};

inline Spread spreadOf(std::vector<double> values) {
    Spread out;
    out.median = base::median(values);
    for (double& v : values)
        v = std::abs(v - out.median);
    out.deviation = deviationOverMad * base::median(values);
    return out;
}

/// 1 at no residual, 0 from `reach` on.
inline double biweight(double residual, double reach) {
    const double t = residual / reach, u = 1 - t * t;
    return std::abs(residual) < reach ? u * u : 0;
}

} // namespace process

#include "core/process/measuring/histogram.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace process {

Histogram histogramOf(std::span<const double> values, std::size_t bins, bool sided,
                      const std::optional<std::pair<double, double>>& range) {
    Histogram out;
    out.counts.assign(bins, 0);
    for (const double v : values)
        if (!std::isnan(v))
            out.high = std::max(out.high, std::abs(v));
    if (!(out.high > 0))
        out.high = 1; // all are zero
    out.low = sided ? -out.high : 0;
    if (range)
        std::tie(out.low, out.high) = *range;
    for (const double v : values) {
        if (std::isnan(v))
            continue;
        if (v < out.low || v > out.high) {
            ++(v < out.low ? out.below : out.above);
            continue;
        }
        // The edge as it is told decides, not a quotient.
        const double part = (v - out.low) / (out.high - out.low) * static_cast<double>(bins);
        auto k = std::min(bins - 1, static_cast<std::size_t>(std::max(0.0, part)));
        while (k > 0 && v < out.edge(k))
            --k;
        while (k + 1 < bins && v >= out.edge(k + 1))
            ++k;
        ++out.counts[k];
    }
    return out;
}

} // namespace process

// How often which numbers occur.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace process {

/// Bins of equal width: the k-th holds [low + k w, low + (k + 1) w), the last one its end, too.
struct Histogram {
    double low = 0, high = 0;
    std::vector<std::size_t> counts;
    std::size_t below = 0, above = 0; ///< outside of the bins

    double edge(std::size_t k) const {
        return low + (high - low) * static_cast<double>(k) / static_cast<double>(counts.size());
    }
};

/// NaN is left out. Without a range all numbers are within: signed ones symmetric about zero, others from 0. REQUIRES:
/// bins >= 1; low < high of a range.
Histogram histogramOf(std::span<const double> values, std::size_t bins, bool sided,
                      const std::optional<std::pair<double, double>>& range = {});

} // namespace process

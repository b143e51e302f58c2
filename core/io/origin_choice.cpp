#include "core/io/origin_choice.h"

#include <algorithm>
#include <vector>

namespace io {

base::Vec3d chooseOrigin(std::span<const base::Vec3d> sample, std::size_t count) {
    if (sample.empty())
        return {};
    base::Vec3d middle;
    double extent = 0, reach = 0;
    std::vector<double> values(sample.size());
    for (std::size_t k = 0; k < 3; ++k) {
        std::transform(sample.begin(), sample.end(), values.begin(), [k](const base::Vec3d& p) { return p[k]; });
        std::sort(values.begin(), values.end());
        const std::size_t cut = values.size() / 50;
        const double lo = values[cut], hi = values[values.size() - 1 - cut];
        middle[k] = lo + (hi - lo) / 2;
        extent = std::max(extent, hi - lo);
        reach = std::max({reach, std::abs(lo), std::abs(hi)});
    }
    const double spacing = extent / std::sqrt(static_cast<double>(std::max<std::size_t>(count, 1)));
    if (!std::isfinite(extent) || extent <= 0 || reach <= 8 * extent || reach * 0x1p-24 <= 1e-4 * spacing)
        return {};
    const double step = std::pow(10.0, std::floor(std::log10(extent)));
    for (std::size_t k = 0; k < 3; ++k)
        middle[k] = std::round(middle[k] / step) * step + 0.0; // no negative zero
    return base::isFinite(middle) ? middle : base::Vec3d{};
}

} // namespace io

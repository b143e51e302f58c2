#include "core/raycast/edge_aware_filter.h"

#include "core/base/parallel.h"

namespace raycast {

/// Do both show the same part of the surface? Their normals are alike, and the way between them runs along it.
static bool together(const LightPoint& a, const LightPoint& b) {
    constexpr float alike = 0.8f, slope = 0.35f;
    if (a.seen != b.seen || dot(a.n, b.n) < alike)
        return false;
    const base::Vec3f way = b.x - a.x;
    const float off = dot(way, a.n);
    return off * off <= slope * slope * lengthSq(way);
}

void edgeAwareFilter(std::span<const LightPoint> points, int width, std::span<float> values) {
    if (width <= 0)
        return;
    const int height = static_cast<int>(points.size()) / width;
    const std::vector<float> from(values.begin(), values.end());
    base::parallelFor(static_cast<std::size_t>(height), 8, [&](std::size_t line) {
        const int y = static_cast<int>(line);
        for (int x = 0; x < width; ++x) {
            const auto i = static_cast<std::size_t>(y * width + x);
            if (points[i].seen == Seen::Nothing)
                continue;
            float sum = 0, weights = 0;
            for (int row = std::max(0, y - 2); row <= std::min(height - 1, y + 2); ++row)
                for (int column = std::max(0, x - 2); column <= std::min(width - 1, x + 2); ++column) {
                    const auto k = static_cast<std::size_t>(row * width + column);
                    if (!together(points[i], points[k]))
                        continue;
                    const float w = (std::abs(row - y) == 2 ? 0.5f : 1.0f) * (std::abs(column - x) == 2 ? 0.5f : 1.0f);
                    sum += w * from[k];
                    weights += w;
                }
            values[i] = sum / weights;
        }
    });
}

} // namespace raycast

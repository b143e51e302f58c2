#include "core/process/neighbours/knn.h"

#include "core/process/neighbours/curve_order.h"

#include <atomic>

namespace process {

namespace {

constexpr std::size_t grain = 1 << 14;

} // namespace

Cloud::Cloud(std::span<const surfel::Surfel> points, const base::Progress& progress) : m_count(points.size()) {
    progress.step(0, "Sorting points");
    const CurveOrder sorted(points);
    progress.step(0.5, "Sorting points");
    const std::size_t n = points.size();
    m_positions = base::LargeArray<base::Vec3f>(n);
    const auto numberAt = [&](std::size_t i) {
        return sorted.order.empty() ? static_cast<std::uint32_t>(i) : sorted.order[i];
    };
    base::parallelFor(n, grain, [&](std::size_t i) { m_positions[i] = points[numberAt(i)].position; });
    std::atomic<bool> distinct = true;
    base::parallelChunks(n, grain, [&](std::size_t begin, std::size_t end, std::size_t) {
        for (std::size_t i = std::max<std::size_t>(begin, 1); i < end; ++i)
            if (m_positions[i] == m_positions[i - 1])
                distinct.store(false, std::memory_order_relaxed);
    });
    if (!distinct || !sorted.order.empty())
        m_places = base::LargeArray<std::uint32_t>(n);
    if (distinct && !sorted.order.empty()) {
        base::parallelFor(n, grain, [&](std::size_t i) { m_places[numberAt(i)] = static_cast<std::uint32_t>(i); });
    } else if (!distinct) {
        std::size_t kept = 0;
        for (std::size_t i = 0; i < n; ++i) {
            if (kept == 0 || m_positions[i] != m_positions[kept - 1])
                m_positions[kept++] = m_positions[i];
            m_places[numberAt(i)] = static_cast<std::uint32_t>(kept - 1);
        }
        m_positions.shrink(kept);
    }
    progress.step(0.9, "Indexing points");
    m_cells = PointCells(m_positions, sorted.grid);
}

void Cloud::nearest(std::size_t i, std::size_t k, Neighbours& out) const {
    k = std::min(k, size() - 1);
    out.index.resize(k);
    out.distanceSq.resize(k);
    if (k > 0)
        nearestOfOne(m_cells, m_positions, static_cast<std::uint32_t>(i), k, out.index.data(), out.distanceSq.data());
}

float Cloud::reach(const base::Vec3f& x, std::size_t k) const {
    k = std::min(k, size());
    std::vector<std::uint32_t> index(k);
    std::vector<float> distanceSq(k);
    nearestFrom(m_cells, m_positions, x, k, index.data(), distanceSq.data());
    return std::sqrt(distanceSq.back());
}

} // namespace process

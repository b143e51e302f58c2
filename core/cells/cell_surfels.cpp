#include "core/cells/cell_surfels.h"

#include "core/base/clones.h"
#include "core/surface/evaluation/clusters.h"
#include "core/surfel/shape.h"

#include <algorithm>
#include <bit>

namespace cells {

namespace {

constexpr int lanes = surfel::clusterSize;

/// A bit for each of a cluster's width of surfels that reach a box. `x`, `y`, `z`: where they are; `h`: their supports.
POINTCLAY_CLONES
unsigned reaching(const base::Box3f& box, float reach, const float* x, const float* y, const float* z, const float* h) {
    const base::Vec3f lo = box.lo, hi = box.hi;
    float beyond[lanes]; // how far the box is beyond the support, squared
    for (int lane = 0; lane < lanes; ++lane) {
        const float dx = std::max(std::max(lo.x - x[lane], x[lane] - hi.x), 0.0f);
        const float dy = std::max(std::max(lo.y - y[lane], y[lane] - hi.y), 0.0f);
        const float dz = std::max(std::max(lo.z - z[lane], z[lane] - hi.z), 0.0f);
        const float support = reach * h[lane];
        beyond[lane] = dx * dx + dy * dy + dz * dz - support * support;
    }
    unsigned out = 0;
    for (int lane = 0; lane < lanes; ++lane)
        out |= static_cast<unsigned>(beyond[lane] < 0) << lane;
    return out;
}

struct Found {
    const surfel::SurfelBlock* block;
    int slot;
    Label label;
};

} // namespace

CellSurfels::CellSurfels(const CellSurface& surface, const base::Box3f& box)
    : m_shape(surfel::shapeChannel(*surface.surface().tree().layout())),
      m_channels(static_cast<std::size_t>(m_shape > 0 ? m_shape + 3 : surfel::Support + 1)),
      m_scale(surface.surface().supportScale()), m_reach(surface::queryReach(m_scale)) {
    std::vector<Found> found;
    surface.surface().tree().forClustersInSupport(
        box,
        [&](const surfel::SurfelBlock& block, int cluster) {
            const float* x = block.channel(cluster, surfel::X);
            const int begin = cluster * lanes, count = std::min(lanes, block.size() - begin);
            unsigned left =
                reaching(box, m_reach, x, x + lanes, x + 2 * lanes, block.channel(cluster, surfel::Support));
            for (left &= (1u << count) - 1; left != 0; left &= left - 1) {
                const int slot = begin + std::countr_zero(left);
                found.push_back({&block, slot, surface.labels().at(block, slot)});
            }
        },
        m_reach);
    std::stable_sort(found.begin(), found.end(),
                     [](const Found& a, const Found& b) { return a.label.cell < b.label.cell; });
    constexpr auto width = static_cast<std::size_t>(lanes);
    m_stride = (found.size() + width - 1) / width * width;
    m_values.assign(m_channels * m_stride, 0);
    m_labels.reserve(found.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
        const auto& [block, slot, label] = found[i];
        const float* from = block->channel(slot / lanes, surfel::X) + slot % lanes;
        for (std::size_t channel = 0; channel < m_channels; ++channel)
            m_values[channel * m_stride + i] = from[channel * width];
        m_labels.push_back(label);
    }
}

void CellSurfels::inSupport(const base::Box3f& box, std::vector<std::uint32_t>& out) const {
    const auto channel = [&](int c) { return m_values.data() + static_cast<std::size_t>(c) * m_stride; };
    for (std::uint32_t begin = 0; begin < m_labels.size(); begin += lanes) {
        unsigned left = reaching(box, m_reach, channel(surfel::X) + begin, channel(surfel::Y) + begin,
                                 channel(surfel::Z) + begin, channel(surfel::Support) + begin);
        for (; left != 0; left &= left - 1)
            if (const auto i = begin + static_cast<std::uint32_t>(std::countr_zero(left)); i < m_labels.size())
                out.push_back(i);
    }
}

void CellSurfels::copy(std::uint32_t i, float* to) const {
    for (std::size_t channel = 0; channel < m_channels; ++channel)
        to[channel * static_cast<std::size_t>(lanes)] = m_values[channel * m_stride + i];
}

} // namespace cells

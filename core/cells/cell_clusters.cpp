#include "core/cells/cell_clusters.h"

#include "core/surfel/shape.h"

#include <algorithm>

namespace cells {

namespace {

constexpr int lanes = surfel::clusterSize;
constexpr float farAway = 1e15f; ///< of slots without a surfel, as in blocks: no weight, and finite squares
constexpr std::uint32_t nowhere = std::numeric_limits<std::uint32_t>::max();

} // namespace

CellClusters::CellClusters(const CellSurface& surface, const base::Box3f& box)
    : m_shape(surfel::shapeChannel(*surface.surface().tree().layout())),
      m_channels(static_cast<std::size_t>(m_shape > 0 ? m_shape + 3 : surfel::Support + 1)) {
    std::vector<Found> found;
    collect(surface, box, found);
    // in tree order within a cell: neighbours share clusters
    std::stable_sort(found.begin(), found.end(),
                     [](const Found& a, const Found& b) { return a.label.cell < b.label.cell; });
    pack(found);
    const float scale = surface.surface().supportScale();
    for (const Found& each : found)
        if (each.label.meeting != Meeting::None)
            m_beside.push_back({each.block->position(each.slot), surfel::shapeOf(*each.block, each.slot, m_shape),
                                scale * each.block->support(each.slot), place(each.label.cell),
                                place(each.label.partner), each.label});
    packFades(found);
    for (std::size_t at = 0; at < m_packed.size(); at += m_channels)
        m_pointers.push_back(m_packed[at].lanes);
    for (Cell& a : m_cells)
        for (const Cell& b : m_cells)
            a.joined |= a.cell != b.cell && a.face == b.face;
}

void CellClusters::collect(const CellSurface& surface, const base::Box3f& box, std::vector<Found>& out) {
    const float reach = surface::queryReach(surface.surface().supportScale());
    surface.surface().tree().forClustersInSupport(
        box,
        [&](const surfel::SurfelBlock& block, int cluster) {
            const float* x = block.channel(cluster, surfel::X);
            const float* h = block.channel(cluster, surfel::Support);
            const int begin = cluster * lanes, count = std::min(lanes, block.size() - begin);
            float beyond[lanes]; // how far the box is beyond the support, squared
            for (int lane = 0; lane < lanes; ++lane) {
                const float dx = std::max({box.lo.x - x[lane], x[lane] - box.hi.x, 0.0f});
                const float dy = std::max({box.lo.y - x[lane + lanes], x[lane + lanes] - box.hi.y, 0.0f});
                const float dz = std::max({box.lo.z - x[lane + 2 * lanes], x[lane + 2 * lanes] - box.hi.z, 0.0f});
                const float support = reach * h[lane];
                beyond[lane] = dx * dx + dy * dy + dz * dz - support * support;
            }
            for (int lane = 0; lane < count; ++lane)
                if (beyond[lane] < 0)
                    out.push_back({&block, begin + lane, surface.labels().at(block, begin + lane)});
        },
        reach);
}

std::uint32_t CellClusters::place(std::uint32_t label) const {
    const auto at = std::lower_bound(m_cells.begin(), m_cells.end(), label,
                                     [](const Cell& cell, std::uint32_t l) { return cell.cell < l; });
    return at == m_cells.end() || at->cell != label ? nowhere : static_cast<std::uint32_t>(at - m_cells.begin());
}

float* CellClusters::nextLane(bool fresh) {
    if (fresh || m_lane == lanes) {
        m_packed.resize(m_packed.size() + m_channels);
        float* channels = m_packed[m_packed.size() - m_channels].lanes;
        std::fill_n(channels, 3 * lanes, farAway);
        std::fill_n(channels + surfel::Support * lanes, lanes, 1.0f);
        m_lane = 0;
    }
    return m_packed[m_packed.size() - m_channels].lanes + m_lane++;
}

void CellClusters::copyLane(const surfel::SurfelBlock& block, int slot, float* to) const {
    const float* from = block.channel(slot / lanes, surfel::X) + slot % lanes;
    for (int channel = surfel::X; channel <= surfel::Support; ++channel)
        to[channel * lanes] = from[channel * lanes];
    for (int channel = m_shape; m_shape > 0 && channel < m_shape + 3; ++channel)
        to[channel * lanes] = from[channel * lanes];
}

void CellClusters::pack(const std::vector<Found>& found) {
    for (const Found& each : found) {
        const bool another = m_cells.empty() || m_cells.back().cell != each.label.cell;
        if (another) {
            const auto begin = clusterCount();
            m_cells.push_back({each.label.cell, each.label.face, begin, begin, false});
        }
        copyLane(*each.block, each.slot, nextLane(another));
        m_cells.back().end = clusterCount();
    }
}

void CellClusters::packFades(const std::vector<Found>& found) {
    using Pair = std::pair<std::uint32_t, std::uint32_t>;
    const auto pairOf = [&](const Found& each) -> Pair {
        const std::uint32_t own = place(each.label.cell), partner = place(each.label.partner);
        return {std::min(own, partner), std::max(own, partner)};
    };
    for (const Found& each : found)
        if (each.label.meeting != Meeting::None && each.label.sharpness != 255) {
            const auto [a, b] = pairOf(each);
            const auto same = [a = a, b = b](const Fade& fade) { return fade.a == a && fade.b == b; };
            if (b != nowhere && std::none_of(m_fades.begin(), m_fades.end(), same))
                m_fades.push_back({a, b});
        }
    for (Fade& fade : m_fades) {
        fade.begin = clusterCount();
        for (const Found& each : found) {
            if (each.label.meeting == Meeting::None || pairOf(each) != Pair(fade.a, fade.b))
                continue;
            float* to = nextLane(clusterCount() == fade.begin);
            copyLane(*each.block, each.slot, to);
            to[surfel::NormalX * lanes] = static_cast<float>(each.label.sharpness) / 255;
            to[surfel::NormalY * lanes] = to[surfel::NormalZ * lanes] = 0;
        }
        fade.end = clusterCount();
    }
}

} // namespace cells

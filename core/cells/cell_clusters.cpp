#include "core/cells/cell_clusters.h"

#include <algorithm>

namespace cells {

namespace {

constexpr int lanes = surfel::clusterSize;
constexpr float farAway = 1e15f; ///< of slots without a surfel, as in blocks: no weight, and finite squares
constexpr std::uint32_t nowhere = std::numeric_limits<std::uint32_t>::max();

} // namespace

CellClusters::CellClusters(const CellSurfels& from, const base::Box3f& box) : m_channels(from.channels()) {
    std::vector<std::uint32_t> chosen;
    from.inSupport(box, chosen);
    pack(from, chosen);
    for (const std::uint32_t i : chosen)
        if (const Label& label = from.label(i); label.meeting != Meeting::None)
            m_beside.push_back(
                {from.position(i), from.shape(i), from.support(i), place(label.cell), place(label.partner), label});
    packFades(from, chosen);
    for (std::size_t at = 0; at < m_packed.size(); at += m_channels)
        m_pointers.push_back(m_packed[at].lanes);
    for (Cell& a : m_cells)
        for (const Cell& b : m_cells)
            a.joined |= a.cell != b.cell && a.face == b.face;
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

void CellClusters::pack(const CellSurfels& from, Chosen chosen) {
    for (const std::uint32_t i : chosen) {
        const Label& label = from.label(i);
        const bool another = m_cells.empty() || m_cells.back().cell != label.cell;
        if (another) {
            const auto begin = clusterCount();
            m_cells.push_back({label.cell, label.face, begin, begin, false});
        }
        from.copy(i, nextLane(another));
        m_cells.back().end = clusterCount();
    }
}

void CellClusters::packFades(const CellSurfels& from, Chosen chosen) {
    using Pair = std::pair<std::uint32_t, std::uint32_t>;
    const auto pairOf = [&](const Label& label) -> Pair {
        const std::uint32_t own = place(label.cell), partner = place(label.partner);
        return {std::min(own, partner), std::max(own, partner)};
    };
    for (const std::uint32_t i : chosen)
        if (const Label& label = from.label(i); label.meeting != Meeting::None && label.sharpness != 255) {
            const auto [a, b] = pairOf(label);
            const auto same = [a = a, b = b](const Fade& fade) { return fade.a == a && fade.b == b; };
            if (b != nowhere && std::none_of(m_fades.begin(), m_fades.end(), same))
                m_fades.push_back({a, b});
        }
    for (Fade& fade : m_fades) {
        fade.begin = clusterCount();
        for (const std::uint32_t i : chosen) {
            const Label& label = from.label(i);
            if (label.meeting == Meeting::None || pairOf(label) != Pair(fade.a, fade.b))
                continue;
            float* to = nextLane(clusterCount() == fade.begin);
            from.copy(i, to);
            to[surfel::NormalX * lanes] = static_cast<float>(label.sharpness) / 255;
            to[surfel::NormalY * lanes] = to[surfel::NormalZ * lanes] = 0;
        }
        fade.end = clusterCount();
    }
}

} // namespace cells

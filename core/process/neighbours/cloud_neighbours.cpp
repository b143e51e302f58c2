#include "core/process/neighbours/cloud_neighbours.h"

#include "core/process/estimation/cloud_normals.h"
#include "core/process/estimation/cloud_spacing.h"
#include "core/process/estimation/duplicates.h"

#include <atomic>
#include <limits>

namespace process {

namespace {

/// Beyond this part of a cloud's positions that go nearly every row saw one.
constexpr std::size_t fewOf = 8;

/// Neighbours that are kept, and that are looked at.
struct Width {
    std::size_t kept, looked;
    bool plane; ///< normals are made of those looked at

    Width(std::size_t positions, std::size_t normalNeighbours)
        : kept(std::min(NeighbourTable::most, positions > 0 ? positions - 1 : 0)), looked(kept),
          plane(normalNeighbours > 0 && positions > 2) {
        if (plane)
            looked = std::max(kept, std::min(normalNeighbours, positions - 1));
    }
};

/// What a cell's rows tell but of duplicates.
void takeRows(const Cloud& cloud, const NearestRows& rows, const Width& width, std::size_t normalNeighbours,
              CloudNeighbours& out) {
    for (std::size_t r = 0; r < rows.count; ++r) {
        const std::size_t i = rows.first + r;
        const auto index = std::span(rows.index).subspan(r * rows.k, rows.k);
        const auto distanceSq = std::span(rows.distanceSq).subspan(r * rows.k, rows.k);
        out.table.set(i, index.first(width.kept));
        out.spacing[i] = spacingOfRing(distanceSq.first(width.kept));
    }
    if (width.plane)
        planeNormals(cloud.positions(), rows, std::min(normalNeighbours, rows.k), out.normals.data() + rows.first);
}

/// What duplicates are told by, and what is left when they go.
void takeGaps(const NearestRows& rows, const Width& width, CloudNeighbours& out) {
    float closest = std::numeric_limits<float>::infinity(), farthest = 0;
    for (std::size_t r = 0; r < rows.count; ++r) {
        const auto distanceSq = std::span(rows.distanceSq).subspan(r * rows.k, rows.k);
        out.doubles[rows.first + r] = static_cast<std::uint8_t>(duplicatesBeside(distanceSq.first(width.kept)));
        if (width.kept >= leastPile - 1)
            closest = std::min(closest, distanceSq[leastPile - 2]);
        farthest = std::max(farthest, distanceSq.back());
    }
    out.closestPile[rows.cell] = closest;
    out.farthest[rows.cell] = farthest;
}

base::Box3f boxOf(const Cloud& cloud) {
    return cloud.cells().nodes.empty() ? base::Box3f() : cloud.cells().nodes.front().box;
}

template <class Item>
void keep(base::LargeArray<Item>& items, std::span<const std::uint8_t> stays, std::size_t count) {
    for (std::size_t i = 0, at = 0; at < count; ++i)
        if (stays[i])
            items[at++] = items[i];
    items.shrink(count);
}

/// Which cells have a row that may hold one of these positions.
std::vector<std::uint8_t> cellsThatSee(const Cloud& cloud, std::span<const float> farthest,
                                       std::span<const std::uint32_t> seen) {
    const auto& nodes = cloud.cells().nodes;
    std::vector<float> reachSq(nodes.size());
    for (std::size_t n = nodes.size(); n-- > 0;)
        reachSq[n] = nodes[n].cell != PointCells::inner ? farthest[nodes[n].cell]
                                                        : std::max(reachSq[n + 1], reachSq[nodes[n + 1].next]);
    std::vector<std::uint8_t> out(cloud.cells().count(), 0);
    base::parallelFor(seen.size(), 64, [&](std::size_t k) {
        const base::Vec3f& p = cloud.positions()[seen[k]];
        for (std::uint32_t n = 0; n < nodes.size();) {
            const PointCells::Node& node = nodes[n];
            if (!(node.box.distanceSq(p) <= reachSq[n])) {
                n = node.next;
                continue;
            }
            if (node.cell != PointCells::inner)
                std::atomic_ref(out[node.cell]).store(1, std::memory_order_relaxed);
            ++n;
        }
    });
    return out;
}

} // namespace

CloudNeighbours neighboursOf(const Cloud& cloud, std::size_t normalNeighbours, const base::Progress& progress) {
    CloudNeighbours out;
    const std::size_t n = cloud.size();
    const Width width(n, normalNeighbours);
    out.table = NeighbourTable(n, width.kept);
    out.spacing = base::LargeArray<float>(n);
    out.doubles = base::LargeArray<std::uint8_t>(n);
    out.closestPile.assign(cloud.cells().count(), std::numeric_limits<float>::infinity());
    out.farthest.assign(cloud.cells().count(), 0);
    if (normalNeighbours > 0)
        out.normals = base::LargeArray<base::Vec3f>(n);
    if (width.kept == 0 || !width.plane)
        std::fill(out.normals.begin(), out.normals.end(), base::Vec3f{0, 0, 1});
    if (width.kept == 0) {
        std::fill(out.doubles.begin(), out.doubles.end(), std::uint8_t(0));
        std::fill(out.spacing.begin(), out.spacing.end(), 0.0f);
        return out;
    }
    const char* const what = width.plane ? "Estimating normals" : "Looking at neighbours";
    cloud.forEachCell(width.looked, progress, what, [&](const NearestRows& rows) {
        takeRows(cloud, rows, width, normalNeighbours, out);
        takeGaps(rows, width, out);
    });
    return out;
}

KeptNeighbours::KeptNeighbours(const Cloud& cloud, CloudNeighbours near, std::span<const std::uint8_t> stays)
    : m_box(boxOf(cloud)), m_before(cloud.size()) {
    base::LargeArray<std::uint32_t> number(m_before);
    std::vector<std::uint32_t> went;
    std::uint32_t left = 0;
    for (std::uint32_t i = 0; i < m_before; ++i) {
        number[i] = stays[i] ? left++ : NeighbourTable::gone;
        if (!stays[i])
            went.push_back(i);
    }
    if (went.size() >= m_before / fewOf)
        return;
    const std::vector<std::uint8_t> doubtful = cellsThatSee(cloud, near.farthest, went);
    const std::vector<std::uint32_t>& begin = cloud.cells().begin;
    for (std::size_t cell = 0; cell < doubtful.size(); ++cell)
        for (std::uint32_t i = begin[cell]; doubtful[cell] && i < begin[cell + 1]; ++i)
            if (stays[i])
                m_doubtful.push_back(number[i]);
    m_near.table = std::move(near.table);
    m_near.spacing = std::move(near.spacing);
    m_near.normals = std::move(near.normals);
    m_near.table.renumber(number, left);
    keep(m_near.spacing, stays, left);
    if (!m_near.normals.empty())
        keep(m_near.normals, stays, left);
}

CloudNeighbours KeptNeighbours::in(const Cloud& left, std::size_t normalNeighbours, const base::Progress& progress) && {
    const Width width(left.size(), normalNeighbours), before(m_before, normalNeighbours);
    const bool sameOrder = m_box == boxOf(left);
    if (m_near.table.size() != left.size() || width.looked != before.looked || !sameOrder) {
        m_near = {};
        return neighboursOf(left, normalNeighbours, progress);
    }
    const std::vector<std::uint32_t>& begin = left.cells().begin;
    std::vector<std::uint32_t> cells;
    for (std::size_t cell = 0, at = 0; cell < left.cells().count(); ++cell) {
        const std::size_t first = at;
        while (at < m_doubtful.size() && m_doubtful[at] < begin[cell + 1])
            ++at;
        if (at > first)
            cells.push_back(static_cast<std::uint32_t>(cell));
    }
    left.forCells(cells, width.looked, progress, "Looking at neighbours",
                  [&](const NearestRows& rows) { takeRows(left, rows, width, normalNeighbours, m_near); });
    return std::move(m_near);
}

} // namespace process

#include "core/process/neighbours/neighbour_graph.h"

#include "core/process/estimation/cloud_spacing.h"
#include "core/process/estimation/part_progress.h"

#include <algorithm>

namespace process {

namespace {

using base::Vec3f;

constexpr std::size_t fewest = 6;       ///< of the own side, that spacing is made of
constexpr float oppositeCosine = -0.5f; ///< normals that differ by more than 120 degrees are of two sides
/// From so many positions of a cell on, that see the other side, all are asked about at once.
constexpr std::size_t worthTheCell = 4;

/// The sum of normals at each position.
base::LargeArray<Vec3f> sidesOf(const Cloud& cloud, const surfel::SurfelList& points) {
    base::LargeArray<Vec3f> out(cloud.size());
    const auto places = cloud.places();
    if (cloud.size() == points.size()) {
        base::parallelFor(points.size(), 8192, [&](std::size_t i) { out[places[i]] = points.items[i].normal; });
        return out;
    }
    std::fill(out.begin(), out.end(), Vec3f{});
    for (std::size_t i = 0; i < points.size(); ++i)
        out[places[i]] += points.items[i].normal;
    return out;
}

bool opposite(const Vec3f& side, const Vec3f& other) {
    const float cosine = dot(side, other);
    return cosine < 0 && cosine < oppositeCosine * length(side) * length(other);
}

/// Replaces rows that see the other side.
class OwnSides {
  public:
    OwnSides(const Cloud& cloud, base::LargeArray<Vec3f> sides, NeighbourTable& table)
        : m_cloud(cloud), m_sides(std::move(sides)), m_table(table) {}

    void run(std::span<float> spacing, const base::Progress& progress) {
        constexpr std::size_t slab = 1024, grain = 16;
        const std::size_t cells = m_cloud.cells().count();
        for (std::size_t from = 0; from < cells; from += slab) {
            progress.step(static_cast<double>(from) / static_cast<double>(cells), "Measuring spacing");
            std::vector<std::vector<Mended>> mended(base::chunkCount(slab, grain));
            base::parallelChunks(std::min(slab, cells - from), grain,
                                 [&](std::size_t begin, std::size_t end, std::size_t chunk) {
                                     NearestRows rows;
                                     for (std::size_t cell = from + begin; cell < from + end; ++cell)
                                         mend(cell, rows, mended[chunk]);
                                 });
            for (const std::vector<Mended>& part : mended)
                for (const Mended& each : part) {
                    m_table.set(each.position, std::span(each.row).first(m_table.count()));
                    spacing[each.position] = spacingAt(each);
                }
        }
    }

  private:
    /// Set when nobody reads.
    struct Mended {
        std::uint32_t position;
        NeighbourTable::Row row;
    };

    float spacingAt(const Mended& each) const {
        const auto positions = m_cloud.positions();
        std::array<float, ringSize> distancesSq;
        const std::size_t count = std::min(ringSize, m_table.count());
        for (std::size_t k = 0; k < count; ++k)
            distancesSq[k] = base::distanceSq(positions[each.position], positions[each.row[k]]);
        return spacingOfRing(std::span(distancesSq).first(count));
    }

    bool seesOther(std::size_t i) const {
        const NeighbourTable::Row row = m_table.row(i);
        return std::any_of(row.begin(), row.begin() + static_cast<std::ptrdiff_t>(m_table.count()),
                           [&](std::uint32_t j) { return opposite(m_sides[i], m_sides[j]); });
    }

    void mend(std::size_t cell, NearestRows& rows, std::vector<Mended>& out) const {
        const PointCells& cells = m_cloud.cells();
        std::vector<std::uint32_t> doubtful;
        for (std::uint32_t i = cells.begin[cell]; i < cells.begin[cell + 1]; ++i)
            if (seesOther(i))
                doubtful.push_back(i);
        const std::size_t k = std::min(2 * m_table.count(), m_cloud.size() - 1);
        if (doubtful.size() >= worthTheCell)
            nearestOfCell(cells, m_cloud.positions(), cell, k, rows);
        Neighbours alone;
        for (const std::uint32_t i : doubtful) {
            if (doubtful.size() < worthTheCell)
                m_cloud.nearest(i, k, alone);
            const std::span<const std::uint32_t> near = doubtful.size() < worthTheCell
                                                            ? std::span<const std::uint32_t>(alone.index)
                                                            : std::span(rows.index).subspan((i - rows.first) * k, k);
            keepOwn(i, near, out);
        }
    }

    void keepOwn(std::uint32_t i, std::span<const std::uint32_t> near, std::vector<Mended>& out) const {
        Mended own{i, {}};
        std::size_t kept = 0;
        for (const std::uint32_t j : near)
            if (kept < m_table.count() && !opposite(m_sides[i], m_sides[j]))
                own.row[kept++] = j;
        if (kept < fewest)
            return;
        std::fill(own.row.begin() + static_cast<std::ptrdiff_t>(kept), own.row.end(), own.row[kept - 1]);
        out.push_back(own);
    }

    const Cloud& m_cloud;
    base::LargeArray<Vec3f> m_sides;
    NeighbourTable& m_table;
};

} // namespace

NeighbourGraph neighbourGraph(const Cloud& cloud, const surfel::SurfelList& points, NeighbourTable nearest,
                              std::span<float> spacing, const base::Progress& progress) {
    if (points.layout->normals && points.layout->oriented)
        OwnSides(cloud, sidesOf(cloud, points), nearest).run(spacing, progress);
    return {std::move(nearest), cloud.positions()};
}

} // namespace process

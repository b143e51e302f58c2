// The neighbours that supports are compared with: of every distinct position the nearest on its own side.
#pragma once

#include "core/process/neighbours/neighbour_table.h"

namespace process {

inline constexpr std::size_t gradedNeighbours = NeighbourTable::most;

/// Each position's neighbours, nearest first, and their distances. Who is whose neighbour is not mutual: sparse places
/// see dense ones that do not see them.
class NeighbourGraph {
  public:
    using Row = NeighbourTable::Row;

    /// Holds on to the positions.
    NeighbourGraph(NeighbourTable table, std::span<const base::Vec3f> positions)
        : m_table(std::move(table)), m_positions(positions) {}

    std::size_t size() const { return m_table.size(); }
    /// Neighbours of each.
    std::size_t count() const { return m_table.count(); }
    Row row(std::size_t i) const { return m_table.row(i); }
    void set(std::size_t i, const Row& row) { m_table.set(i, std::span(row).first(count())); }
    std::span<const base::Vec3f> positions() const { return m_positions; }
    float distance(std::size_t i, std::size_t j) const { return base::distance(m_positions[i], m_positions[j]); }
    /// Whether j is among the `first` nearest of i.
    bool sees(std::size_t i, std::uint32_t j, std::size_t first = gradedNeighbours) const {
        return m_table.sees(i, j, first);
    }

  private:
    NeighbourTable m_table;
    std::span<const base::Vec3f> m_positions;
};

/// Where a wall is thin, the nearest may stand behind it, and their spacing would be the wall's thickness: where
/// normals are oriented, those of the own side count. Too few of them: all count. Rows are filled up with the last one.
/// `points` are the list that the cloud was made of, `nearest` its 12 nearest neighbours, `spacing` the spacing that
/// they tell of, which is made anew where rows change; `cloud` outlives the result. REQUIRES: two positions.
NeighbourGraph neighbourGraph(const Cloud& cloud, const surfel::SurfelList& points, NeighbourTable nearest,
                              std::span<float> spacing, const base::Progress& progress);

} // namespace process

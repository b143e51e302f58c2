// What neighbours' normals say of each other's signs (process/README 2.2): the edges that spanning trees, and
// judgements of an orientation, are made of. Const functions may run on any thread.
#pragma once

#include "core/process/neighbours/neighbour_table.h"

namespace process {

/// Classes of unlikeness: as fine as float normals of a scan mean anything, and sorted in one pass.
inline constexpr int unlikeBits = 14;
inline constexpr std::size_t unlikeClasses = std::size_t(1) << unlikeBits;

/// Of a point's edges to its neighbours, in lanes.
struct Likeness {
    static constexpr int most = 16;
    std::int32_t flip[most];   ///< 1 where one of the two has to be turned
    std::int32_t unlike[most]; ///< 0 certain to unlikeClasses - 1
    float stepSq[most];        ///< of one, how far the neighbour stands above or below the sheet, squared
};

static_assert(NeighbourTable::most <= Likeness::most);

/// One point and its neighbours, or what else is beside it, in lanes: working memory of one thread.
struct Beside {
    base::Vec3f a, na;
    float x[Likeness::most], y[Likeness::most], z[Likeness::most];
    float nx[Likeness::most], ny[Likeness::most], nz[Likeness::most];
};

/// The edges of a neighbour graph, with the normals at their ends. Refers to all three.
class NormalLinks {
  public:
    /// REQUIRES: unit normals, or some that are zero.
    NormalLinks(std::span<const base::Vec3f> positions, const NeighbourTable& table,
                std::span<const base::Vec3f> normals)
        : m_positions(positions), m_table(table), m_normals(normals) {}

    std::size_t size() const { return m_table.size(); }
    /// Neighbours of each.
    std::size_t count() const { return m_table.count(); }

    /// Whether the edge from i to its neighbour j was found before, from j on.
    bool foundBefore(std::uint32_t i, std::uint32_t j) const { return j < i && m_table.sees(j, i); }

    NeighbourTable::Row row(std::size_t i) const { return m_table.row(i); }
    /// Whether i is also among the neighbours of its neighbour j.
    bool isMutual(std::uint32_t i, std::uint32_t j) const { return j != i && m_table.sees(j, i); }

    /// body(i, neighbours, likeness) for a range of points; count() of both are valid. An edge that is found from both
    /// its ends has the same bits from both.
    template <class Body>
    void forRows(std::size_t begin, std::size_t end, const Body& body) const {
        Beside beside{};
        Likeness likeness;
        for (std::size_t i = begin; i < end; ++i) {
            const NeighbourTable::Row row = m_table.row(i);
            compare(i, row, beside, likeness);
            body(static_cast<std::uint32_t>(i), row, static_cast<const Likeness&>(likeness));
        }
    }

  private:
    void compare(std::size_t i, const NeighbourTable::Row& row, Beside& beside, Likeness& out) const;

    std::span<const base::Vec3f> m_positions;
    const NeighbourTable& m_table;
    std::span<const base::Vec3f> m_normals;
};

} // namespace process

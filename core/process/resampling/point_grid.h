// Points in cubic cells of a hash table, for searches within about one cell size while points come and go.
//
// `build` lays the points of a cell side by side; `insert` chains later ones to their cell. Order within a cell is the
// order of building and inserting, so that visits are deterministic. Const functions may run on any thread.
#pragma once

#include "core/base/vec.h"

#include <cstdint>
#include <span>
#include <vector>

namespace process {

class PointGrid {
  public:
    struct Entry {
        base::Vec3f position;
        std::uint32_t index = 0;
    };

    /// REQUIRES: cell > 0, and all points within 10^6 cells of `origin` along each axis.
    PointGrid(const base::Vec3f& origin, float cell) : m_origin(origin), m_scale(1 / cell) {}

    void build(std::span<const Entry> entries);
    void insert(const Entry& entry);

    /// fn(entry) for a superset of the entries within `radius` of `x`.
    template <class Fn>
    void forNear(const base::Vec3f& x, float radius, const Fn& fn) const;

    // --- cell by cell, for work that is done for all points of a cell at once; only after `build`, before `insert` ---

    std::size_t cellCount() const { return m_cells.size(); }
    /// Points of the cell at a rank, 0 to cellCount()-1 by coordinates.
    std::span<const Entry> members(std::size_t rank) const {
        const Cell& cell = m_cells[m_ranked[rank].cell];
        return {m_entries.data() + cell.first, cell.count};
    }
    /// Walks cells by ascending rank and knows the 26 around each without searching: along each of the nine rows of
    /// three cells a cursor only moves on.
    class Walk {
      public:
        Walk(const PointGrid& grid, std::size_t firstRank);
        /// fn(entries) for every occupied cell of the 27 at and around a rank, which never decreases between calls.
        template <class Fn>
        void around(std::size_t rank, const Fn& fn);

      private:
        const PointGrid& m_grid;
        std::size_t m_cursor[9];
    };

  private:
    struct Cell {
        std::uint64_t key = 0;
        std::uint32_t first = 0, count = 0;
        std::int32_t chain = -1; ///< into m_added
    };
    struct Added {
        Entry entry;
        std::int32_t next;
    };
    struct Ranked {
        std::uint64_t key;
        std::uint32_t cell;
    };
    struct Place {
        std::int64_t x, y, z;
    };
    static std::uint64_t rowBegin(std::uint64_t key, int row) {
        constexpr std::uint64_t x = std::uint64_t(1) << 42, y = std::uint64_t(1) << 21;
        return key - x - y - 1 + static_cast<std::uint64_t>(row / 3) * x + static_cast<std::uint64_t>(row % 3) * y;
    }
    Place placeOf(const base::Vec3f& p) const;
    std::vector<std::uint32_t> orderOf(std::span<const Place> places) const; ///< by cell, stable
    static std::uint64_t keyOf(const Place& c);
    const Cell* find(std::uint64_t key) const;
    std::uint32_t findOrAdd(std::uint64_t key);
    void grow(std::size_t slots);
    template <class Fn>
    void visit(const Cell& cell, const Fn& fn) const;

    base::Vec3f m_origin;
    float m_scale;
    std::vector<Cell> m_cells;         ///< by key; later ones in order of their first point
    std::vector<std::int32_t> m_table; ///< open addressing, -1 for empty; a power of two
    std::vector<Ranked> m_ranked;      ///< the cells by key, that is by x, then y, then z
    std::vector<Entry> m_entries;
    std::vector<Added> m_added;
};

inline PointGrid::Place PointGrid::placeOf(const base::Vec3f& p) const {
    const base::Vec3f q = (p - m_origin) * m_scale;
    return {static_cast<std::int64_t>(std::floor(q.x)), static_cast<std::int64_t>(std::floor(q.y)),
            static_cast<std::int64_t>(std::floor(q.z))};
}

inline std::uint64_t PointGrid::keyOf(const Place& c) {
    constexpr std::int64_t half = 1 << 20, mask = (1 << 21) - 1;
    return static_cast<std::uint64_t>(((c.x + half) & mask) << 42 | ((c.y + half) & mask) << 21 |
                                      ((c.z + half) & mask));
}

template <class Fn>
void PointGrid::visit(const Cell& cell, const Fn& fn) const {
    for (std::uint32_t i = 0; i < cell.count; ++i)
        fn(m_entries[cell.first + i]);
    for (std::int32_t k = cell.chain; k >= 0; k = m_added[static_cast<std::size_t>(k)].next)
        fn(m_added[static_cast<std::size_t>(k)].entry);
}

template <class Fn>
void PointGrid::forNear(const base::Vec3f& x, float radius, const Fn& fn) const {
    const base::Vec3f reach{radius, radius, radius};
    const Place lo = placeOf(x - reach), hi = placeOf(x + reach);
    for (std::int64_t cx = lo.x; cx <= hi.x; ++cx)
        for (std::int64_t cy = lo.y; cy <= hi.y; ++cy)
            for (std::int64_t cz = lo.z; cz <= hi.z; ++cz)
                if (const Cell* cell = find(keyOf({cx, cy, cz})))
                    visit(*cell, fn);
}

template <class Fn>
void PointGrid::Walk::around(std::size_t rank, const Fn& fn) {
    const auto& ranked = m_grid.m_ranked;
    for (int row = 0; row < 9; ++row) {
        const std::uint64_t begin = rowBegin(ranked[rank].key, row);
        std::size_t& at = m_cursor[row];
        while (at < ranked.size() && ranked[at].key < begin)
            ++at;
        for (std::size_t k = at; k < ranked.size() && ranked[k].key <= begin + 2; ++k)
            fn(m_grid.members(k));
    }
}

} // namespace process

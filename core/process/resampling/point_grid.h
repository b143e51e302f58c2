// Points in cubic cells of a hash table, for searches within about one cell size while points come and go.
//
// `build` lays the points of a cell side by side; `insert` chains later ones to their cell. Order within a cell is the
// order of building, then the latest of the inserted first, so that visits are deterministic. Where many share a cell,
// since it is as wide as the coarsest sampling asks, they stand in runs, each with its own box: points that come in the
// order of a tree lie side by side, and a search passes over runs that are not near. Const functions may run on any
// thread.
#pragma once

#include "core/base/box.h"
#include "core/base/cells.h"

#include <algorithm>
#include <span>
#include <vector>

namespace process {

class PointGrid {
  public:
    struct Entry {
        base::Vec3f position;
        std::uint32_t index = 0;
    };

    /// Points further than 10^6 cells from `origin` along an axis may share a cell with others: slower, not wrong.
    /// REQUIRES: cell > 0.
    PointGrid(const base::Vec3f& origin, float cell) : m_origin(origin), m_scale(1 / cell) {}

    void build(std::span<const Entry> entries);
    void insert(const Entry& entry);

    /// fn(entry) for a superset of the entries within `radius` of `x`.
    template <class Fn>
    void forNear(const base::Vec3f& x, float radius, const Fn& fn) const {
        const base::Vec3f reach{radius, radius, radius};
        forIn({x - reach, x + reach}, fn);
    }
    /// fn(entry) for a superset of the entries in a box.
    template <class Fn>
    void forIn(const base::Box3f& box, const Fn& fn) const;
    /// Cells that a box meets, occupied or not: whole numbers, which for boxes of any size a double holds.
    double cellsIn(const base::Box3f& box) const {
        const base::Cell lo = cellOf(box.lo), hi = cellOf(box.hi);
        const auto along = [](std::int64_t from, std::int64_t to) { return double(to) - double(from) + 1; };
        return along(lo.x, hi.x) * along(lo.y, hi.y) * along(lo.z, hi.z);
    }

    // --- cell by cell, for work that is done for all points of a cell at once; only after `build`, before `insert` ---

    std::size_t cellCount() const { return m_cells.size(); }
    /// Points of the cell at a rank, 0 to cellCount()-1 by coordinates.
    std::span<const Entry> members(std::size_t rank) const {
        const Occupied& cell = m_cells[m_ranked[rank].cell];
        return {m_entries.data() + cell.first, cell.count};
    }
    /// fn(points, box) for the cell's runs; the box is that of its points, null where the cell is one run.
    template <class Fn>
    void forRuns(std::size_t rank, const Fn& fn) const {
        visitRuns(m_cells[m_ranked[rank].cell], fn);
    }
    /// Walks cells by ascending rank and knows the 26 around each without searching: along each of the nine rows of
    /// three cells a cursor only moves on.
    class Walk {
      public:
        Walk(const PointGrid& grid, std::size_t firstRank);
        /// fn(rank) for every occupied cell of the 27 at and around a rank, which never decreases between calls.
        template <class Fn>
        void around(std::size_t rank, const Fn& fn);

      private:
        const PointGrid& m_grid;
        std::size_t m_cursor[9];
    };

  private:
    static constexpr std::uint32_t runLength = 8;
    struct Occupied {
        std::uint64_t key = 0;
        std::uint32_t first = 0, count = 0;
        std::uint32_t firstBox = 0; ///< of its runs, where it has more than one
        std::int32_t chain = -1;    ///< into m_added
    };
    /// A run of inserted points.
    struct Added {
        Entry entries[runLength];
        std::uint32_t count = 0;
        std::int32_t next = -1;
        base::Box3f box;
    };
    struct Ranked {
        std::uint64_t key;
        std::uint32_t cell;
    };
    static std::uint64_t rowBegin(std::uint64_t key, int row) {
        constexpr std::uint64_t x = std::uint64_t(1) << 42, y = std::uint64_t(1) << 21;
        return key - x - y - 1 + static_cast<std::uint64_t>(row / 3) * x + static_cast<std::uint64_t>(row % 3) * y;
    }
    base::Cell cellOf(const base::Vec3f& p) const { return base::cellOf(p, m_origin, m_scale); }
    auto keyOf() const {
        return [this](std::uint32_t cell) { return m_cells[cell].key; };
    }
    std::vector<std::uint32_t> orderOf(std::span<const base::Cell> cells) const; ///< by cell, stable
    std::uint32_t findOrAdd(std::uint64_t key);
    void boxRuns();
    template <class Fn>
    void visitRuns(const Occupied& cell, const Fn& fn) const;
    template <class Fn>
    void visit(const Occupied& cell, const base::Box3f& box, const Fn& fn) const;

    base::Vec3f m_origin;
    float m_scale;
    std::vector<Occupied> m_cells; ///< by key; later ones in order of their first point
    base::KeyIndex m_index;        ///< of the cells
    std::vector<Ranked> m_ranked;  ///< the cells by key, that is by x, then y, then z
    std::vector<Entry> m_entries;
    std::vector<base::Box3f> m_boxes; ///< of runs, for cells of several
    std::vector<Added> m_added;
};

template <class Fn>
void PointGrid::visitRuns(const Occupied& cell, const Fn& fn) const {
    const Entry* const entries = m_entries.data() + cell.first;
    if (cell.count <= runLength)
        return fn(std::span(entries, cell.count), nullptr);
    for (std::uint32_t run = 0, at = 0; at < cell.count; ++run, at += runLength)
        fn(std::span(entries + at, std::min(runLength, cell.count - at)), &m_boxes[cell.firstBox + run]);
}

template <class Fn>
void PointGrid::visit(const Occupied& cell, const base::Box3f& box, const Fn& fn) const {
    visitRuns(cell, [&](std::span<const Entry> entries, const base::Box3f* of) {
        if (!of || of->overlaps(box))
            for (const Entry& each : entries)
                fn(each);
    });
    for (std::int32_t k = cell.chain; k >= 0; k = m_added[static_cast<std::size_t>(k)].next) {
        const Added& run = m_added[static_cast<std::size_t>(k)];
        if (run.box.overlaps(box))
            for (std::uint32_t i = run.count; i-- > 0;)
                fn(run.entries[i]);
    }
}

template <class Fn>
void PointGrid::forIn(const base::Box3f& box, const Fn& fn) const {
    const base::Cell lo = cellOf(box.lo), hi = cellOf(box.hi);
    for (std::int64_t cx = lo.x; cx <= hi.x; ++cx)
        for (std::int64_t cy = lo.y; cy <= hi.y; ++cy)
            for (std::int64_t cz = lo.z; cz <= hi.z; ++cz)
                if (const std::uint32_t cell = m_index.find(base::Cell{cx, cy, cz}.key(), keyOf());
                    cell != base::KeyIndex::none)
                    visit(m_cells[cell], box, fn);
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
            fn(k);
    }
}

} // namespace process

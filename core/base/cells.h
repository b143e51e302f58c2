// Cubic cells of space by whole-number coordinates, and a map from the occupied ones to what lies in them.
//
// Keys pack 21 bits an axis; ordered by key, cells are ordered by x, then y, then z. Cells 2^21 apart share a key: a
// search around a place checks distances anyway.
#pragma once

#include "core/base/key_index.h"
#include "core/base/vec.h"

namespace base {

struct Cell {
    std::int64_t x = 0, y = 0, z = 0;

    constexpr std::uint64_t key() const {
        constexpr std::int64_t half = 1 << 20, mask = (1 << 21) - 1;
        return static_cast<std::uint64_t>(((x + half) & mask) << 42 | ((y + half) & mask) << 21 | ((z + half) & mask));
    }
    /// Is the key that of no other cell that says so? Of those, order by key is order by coordinates.
    constexpr bool hasOwnKey() const {
        constexpr std::int64_t half = 1 << 20;
        const auto inside = [](std::int64_t c) { return c >= -half && c < half; };
        return inside(x) && inside(y) && inside(z);
    }
};

/// The whole number at or below x; 0 beyond what anybody counts, so that there are numbers around every one.
template <class T>
std::int64_t cellNumber(T x) {
    const T floor = std::floor(x);
    return std::abs(floor) < T(0x1p60) ? static_cast<std::int64_t>(floor) : 0;
}

/// The cell of p in a grid of `scale` cells per length with a corner at `origin`.
template <class T>
Cell cellOf(const Vec3<T>& p, const Vec3<T>& origin, std::type_identity_t<T> scale) {
    const Vec3<T> q = (p - origin) * scale;
    return {cellNumber(q.x), cellNumber(q.y), cellNumber(q.z)};
}

/// fn(cell) for a cell and the 26 around it, by x, then y, then z.
template <class Fn>
void forCellsAround(const Cell& cell, const Fn& fn) {
    for (std::int64_t x = cell.x - 1; x <= cell.x + 1; ++x)
        for (std::int64_t y = cell.y - 1; y <= cell.y + 1; ++y)
            for (std::int64_t z = cell.z - 1; z <= cell.z + 1; ++z)
                fn(Cell{x, y, z});
}

/// What lies in the occupied cells.
template <class T>
class CellMap {
  public:
    /// Made where the cell was empty.
    T& at(const Cell& cell) {
        const std::uint64_t key = cell.key();
        if (const std::uint32_t number = m_index.find(key, keyOf()); number != KeyIndex::none)
            return m_cells[number].content;
        m_cells.push_back({key, {}});
        m_index.add(static_cast<std::uint32_t>(m_cells.size() - 1), keyOf());
        return m_cells.back().content;
    }
    /// Null for an empty cell.
    const T* find(const Cell& cell) const {
        const std::uint32_t number = m_index.find(cell.key(), keyOf());
        return number == KeyIndex::none ? nullptr : &m_cells[number].content;
    }

  private:
    struct Occupied {
        std::uint64_t key;
        T content;
    };
    auto keyOf() const {
        return [this](std::uint32_t number) { return m_cells[number].key; };
    }
    std::vector<Occupied> m_cells;
    KeyIndex m_index;
};

} // namespace base

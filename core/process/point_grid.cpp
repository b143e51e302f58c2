#include "core/process/point_grid.h"

#include "core/base/random.h"

#include <algorithm>
#include <bit>

namespace process {

const PointGrid::Cell* PointGrid::find(std::uint64_t key) const {
    if (m_table.empty())
        return nullptr;
    const std::size_t mask = m_table.size() - 1;
    for (std::size_t slot = base::mix(key) & mask; m_table[slot] >= 0; slot = (slot + 1) & mask)
        if (m_cells[static_cast<std::size_t>(m_table[slot])].key == key)
            return &m_cells[static_cast<std::size_t>(m_table[slot])];
    return nullptr;
}

void PointGrid::grow(std::size_t slots) {
    m_table.assign(std::bit_ceil(slots), -1);
    const std::size_t mask = m_table.size() - 1;
    for (std::size_t c = 0; c < m_cells.size(); ++c) {
        std::size_t slot = base::mix(m_cells[c].key) & mask;
        while (m_table[slot] >= 0)
            slot = (slot + 1) & mask;
        m_table[slot] = static_cast<std::int32_t>(c);
    }
}

std::uint32_t PointGrid::findOrAdd(std::uint64_t key) {
    if (const Cell* cell = find(key))
        return static_cast<std::uint32_t>(cell - m_cells.data());
    if (2 * (m_cells.size() + 1) > m_table.size())
        grow(4 * (m_cells.size() + 16));
    m_cells.push_back({key, 0, 0, -1});
    const std::size_t mask = m_table.size() - 1;
    std::size_t slot = base::mix(key) & mask;
    while (m_table[slot] >= 0)
        slot = (slot + 1) & mask;
    m_table[slot] = static_cast<std::int32_t>(m_cells.size() - 1);
    return static_cast<std::uint32_t>(m_cells.size() - 1);
}

void PointGrid::build(std::span<const Entry> entries) {
    m_cells.clear();
    m_added.clear();
    grow(std::max<std::size_t>(64, entries.size()));
    std::vector<std::uint32_t> cellOf(entries.size());
    for (std::size_t i = 0; i < entries.size(); ++i) {
        const std::uint64_t key = keyOf(placeOf(entries[i].position));
        const bool same = i > 0 && m_cells[cellOf[i - 1]].key == key; // neighbours in the list are neighbours in space
        cellOf[i] = same ? cellOf[i - 1] : findOrAdd(key);
        ++m_cells[cellOf[i]].count;
    }
    std::uint32_t sum = 0;
    for (Cell& cell : m_cells)
        cell.first = sum, sum += cell.count, cell.count = 0;
    m_entries.resize(entries.size());
    for (std::size_t i = 0; i < entries.size(); ++i) {
        Cell& cell = m_cells[cellOf[i]];
        m_entries[cell.first + cell.count++] = entries[i];
    }
    m_ranked.clear();
    for (std::uint32_t c = 0; c < m_cells.size(); ++c)
        m_ranked.push_back({m_cells[c].key, c});
    std::sort(m_ranked.begin(), m_ranked.end(), [](const Ranked& a, const Ranked& b) { return a.key < b.key; });
}

void PointGrid::insert(const Entry& entry) {
    Cell& cell = m_cells[findOrAdd(keyOf(placeOf(entry.position)))];
    m_added.push_back({entry, cell.chain});
    cell.chain = static_cast<std::int32_t>(m_added.size() - 1);
}

PointGrid::Walk::Walk(const PointGrid& grid, std::size_t firstRank) : m_grid(grid) {
    const auto& ranked = grid.m_ranked;
    for (int row = 0; row < 9; ++row) {
        const std::uint64_t begin = rowBegin(ranked[firstRank].key, row);
        m_cursor[row] =
            static_cast<std::size_t>(std::lower_bound(ranked.begin(), ranked.end(), begin,
                                                      [](const Ranked& r, std::uint64_t key) { return r.key < key; }) -
                                     ranked.begin());
    }
}

} // namespace process

#include "core/process/resampling/point_grid.h"

#include "core/base/parallel.h"
#include "core/base/random.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace process {

/// Cells above each other share a line of the table.
static std::size_t slotOf(std::uint64_t key) {
    return static_cast<std::size_t>(base::mix(key >> 3) << 3 | (key & 7));
}

const PointGrid::Cell* PointGrid::find(std::uint64_t key) const {
    if (m_table.empty())
        return nullptr;
    const std::size_t mask = m_table.size() - 1;
    for (std::size_t slot = slotOf(key) & mask; m_table[slot] >= 0; slot = (slot + 1) & mask)
        if (m_cells[static_cast<std::size_t>(m_table[slot])].key == key)
            return &m_cells[static_cast<std::size_t>(m_table[slot])];
    return nullptr;
}

void PointGrid::grow(std::size_t slots) {
    m_table.assign(std::bit_ceil(slots), -1);
    const std::size_t mask = m_table.size() - 1;
    for (std::size_t c = 0; c < m_cells.size(); ++c) {
        std::size_t slot = slotOf(m_cells[c].key) & mask;
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
    std::size_t slot = slotOf(key) & mask;
    while (m_table[slot] >= 0)
        slot = (slot + 1) & mask;
    m_table[slot] = static_cast<std::int32_t>(m_cells.size() - 1);
    return static_cast<std::uint32_t>(m_cells.size() - 1);
}

namespace {

struct Keyed {
    std::uint64_t key;
    std::uint32_t index;
};

/// Sorts by the lowest `bits` of the keys and keeps the order of equal ones.
void radixSort(std::vector<Keyed>& items, int bits) {
    constexpr int digit = 11;
    constexpr std::size_t buckets = std::size_t(1) << digit;
    std::vector<Keyed> other(items.size());
    for (int shift = 0; shift < bits; shift += digit) {
        std::size_t first[buckets] = {};
        for (const Keyed& each : items)
            ++first[each.key >> shift & (buckets - 1)];
        std::size_t sum = 0;
        for (std::size_t& each : first)
            sum += std::exchange(each, sum);
        for (const Keyed& each : items)
            other[first[each.key >> shift & (buckets - 1)]++] = each;
        items.swap(other);
    }
}

} // namespace

/// Keys count cells in the box of the occupied ones, so that few digits are to be sorted; their order is that of the
/// cells' own keys.
std::vector<std::uint32_t> PointGrid::orderOf(std::span<const Place> places) const {
    Place lo = places[0], hi = places[0];
    for (const Place& each : places) {
        lo = {std::min(lo.x, each.x), std::min(lo.y, each.y), std::min(lo.z, each.z)};
        hi = {std::max(hi.x, each.x), std::max(hi.y, each.y), std::max(hi.z, each.z)};
    }
    const int zBits = std::bit_width(static_cast<std::uint64_t>(hi.z - lo.z)),
              yBits = std::bit_width(static_cast<std::uint64_t>(hi.y - lo.y)),
              xBits = std::bit_width(static_cast<std::uint64_t>(hi.x - lo.x));
    std::vector<Keyed> keyed(places.size());
    base::parallelFor(places.size(), 2048, [&](std::size_t i) {
        keyed[i] = {static_cast<std::uint64_t>(places[i].x - lo.x) << (yBits + zBits) |
                        static_cast<std::uint64_t>(places[i].y - lo.y) << zBits |
                        static_cast<std::uint64_t>(places[i].z - lo.z),
                    static_cast<std::uint32_t>(i)};
    });
    radixSort(keyed, xBits + yBits + zBits);
    std::vector<std::uint32_t> out(places.size());
    for (std::size_t k = 0; k < out.size(); ++k)
        out[k] = keyed[k].index;
    return out;
}

void PointGrid::build(std::span<const Entry> entries) {
    m_cells.clear();
    m_added.clear();
    m_ranked.clear();
    m_entries.resize(entries.size());
    std::vector<Place> places(entries.size());
    base::parallelFor(places.size(), 2048, [&](std::size_t i) { places[i] = placeOf(entries[i].position); });
    const std::vector<std::uint32_t> order = entries.empty() ? std::vector<std::uint32_t>() : orderOf(places);
    std::vector<std::uint64_t> keys(order.size());
    base::parallelFor(order.size(), 2048, [&](std::size_t k) {
        keys[k] = keyOf(places[order[k]]);
        m_entries[k] = entries[order[k]];
    });
    for (std::uint32_t k = 0; k < order.size(); ++k) {
        const std::uint64_t key = keys[k];
        if (m_cells.empty() || m_cells.back().key != key) {
            m_ranked.push_back({key, static_cast<std::uint32_t>(m_cells.size())});
            m_cells.push_back({key, k, 0, -1});
        }
        ++m_cells.back().count;
    }
    grow(4 * (m_cells.size() + 16));
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

#include "core/process/resampling/point_grid.h"

#include "core/base/parallel.h"
#include "core/base/radix_sort.h"

#include <algorithm>
#include <bit>

namespace process {

std::uint32_t PointGrid::findOrAdd(std::uint64_t key) {
    if (const std::uint32_t cell = m_index.find(key, keyOf()); cell != base::KeyIndex::none)
        return cell;
    m_cells.push_back({key, 0, 0, 0, -1});
    const auto added = static_cast<std::uint32_t>(m_cells.size() - 1);
    m_index.add(added, keyOf());
    return added;
}

namespace {

struct Keyed {
    std::uint64_t key;
    std::uint32_t index;
};

} // namespace

/// Those of the cells themselves, or, where these do not wrap, counted in the box of the occupied ones, so that few
/// digits are to be sorted: their order is the same.
std::vector<std::uint32_t> PointGrid::orderOf(std::span<const base::Cell> cells) const {
    base::Cell lo = cells[0], hi = cells[0];
    for (const base::Cell& each : cells) {
        lo = {std::min(lo.x, each.x), std::min(lo.y, each.y), std::min(lo.z, each.z)};
        hi = {std::max(hi.x, each.x), std::max(hi.y, each.y), std::max(hi.z, each.z)};
    }
    const bool wraps = !lo.hasOwnKey() || !hi.hasOwnKey();
    const auto bits = [&](std::int64_t from, std::int64_t to) {
        return wraps ? 21 : std::bit_width(static_cast<std::uint64_t>(to - from));
    };
    const int zBits = bits(lo.z, hi.z), yBits = bits(lo.y, hi.y), xBits = bits(lo.x, hi.x);
    const auto keyOf = [&](const base::Cell& cell) {
        return wraps
                   ? cell.key()
                   : static_cast<std::uint64_t>(cell.x - lo.x) << (yBits + zBits) |
                         static_cast<std::uint64_t>(cell.y - lo.y) << zBits | static_cast<std::uint64_t>(cell.z - lo.z);
    };
    std::vector<Keyed> keyed(cells.size());
    base::parallelFor(cells.size(), 2048, [&](std::size_t i) {
        keyed[i] = {keyOf(cells[i]), static_cast<std::uint32_t>(i)};
    });
    base::radixSort(keyed, xBits + yBits + zBits, [](const Keyed& each) { return each.key; });
    std::vector<std::uint32_t> out(cells.size());
    for (std::size_t k = 0; k < out.size(); ++k)
        out[k] = keyed[k].index;
    return out;
}

void PointGrid::build(std::span<const Entry> entries) {
    m_cells.clear();
    m_added.clear();
    m_ranked.clear();
    m_entries.resize(entries.size());
    std::vector<base::Cell> cells(entries.size());
    base::parallelFor(cells.size(), 2048, [&](std::size_t i) { cells[i] = cellOf(entries[i].position); });
    const std::vector<std::uint32_t> order = entries.empty() ? std::vector<std::uint32_t>() : orderOf(cells);
    std::vector<std::uint64_t> keys(order.size());
    base::parallelFor(order.size(), 2048, [&](std::size_t k) {
        keys[k] = cells[order[k]].key();
        m_entries[k] = entries[order[k]];
    });
    for (std::uint32_t k = 0; k < order.size(); ++k) {
        const std::uint64_t key = keys[k];
        if (m_cells.empty() || m_cells.back().key != key) {
            m_ranked.push_back({key, static_cast<std::uint32_t>(m_cells.size())});
            m_cells.push_back({key, k, 0, 0, -1});
        }
        ++m_cells.back().count;
    }
    boxRuns();
    m_index.assign(static_cast<std::uint32_t>(m_cells.size()), keyOf());
}

void PointGrid::boxRuns() {
    std::uint32_t boxes = 0;
    for (Occupied& cell : m_cells)
        if (cell.count > runLength)
            cell.firstBox = boxes, boxes += (cell.count + runLength - 1) / runLength;
    m_boxes.assign(boxes, {});
    base::parallelFor(m_cells.size(), 512, [&](std::size_t c) {
        const Occupied& cell = m_cells[c];
        for (std::uint32_t i = 0; cell.count > runLength && i < cell.count; ++i)
            m_boxes[cell.firstBox + i / runLength].extend(m_entries[cell.first + i].position);
    });
}

void PointGrid::insert(const Entry& entry) {
    Occupied& cell = m_cells[findOrAdd(cellOf(entry.position).key())];
    if (cell.chain < 0 || m_added[static_cast<std::size_t>(cell.chain)].count == runLength) {
        m_added.emplace_back().next = cell.chain;
        cell.chain = static_cast<std::int32_t>(m_added.size() - 1);
    }
    Added& run = m_added[static_cast<std::size_t>(cell.chain)];
    run.entries[run.count++] = entry;
    run.box.extend(entry.position);
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

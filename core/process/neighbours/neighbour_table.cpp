#include "core/process/neighbours/neighbour_table.h"

#include <cassert>

namespace process {

NeighbourTable::NeighbourTable(std::size_t rows, std::size_t count)
    : m_count(count), m_rows(rows), m_apart(std::make_unique<Group[]>(base::chunkCount(rows, groupSize))) {
    assert(count <= most);
    base::parallelFor(rows, groupSize, [&](std::size_t i) { m_rows[i].fill(0); });
}

void NeighbourTable::set(std::size_t i, std::span<const std::uint32_t> neighbours) {
    assert(neighbours.size() == m_count);
    Differences& row = m_rows[i];
    const bool stoodApart = row[0] == apart;
    Differences near{};
    bool fits = !stoodApart; // who stands apart keeps the place
    for (std::size_t k = 0; k < neighbours.size(); ++k) {
        const std::int64_t difference = static_cast<std::int64_t>(neighbours[k]) - static_cast<std::int64_t>(i);
        near[k] = static_cast<std::int16_t>(difference);
        fits &= near[k] == difference && near[k] != apart;
    }
    if (fits) {
        row = near;
        return;
    }
    Row far{};
    std::copy(neighbours.begin(), neighbours.end(), far.begin());
    Group& group = m_apart[i / groupSize];
    const std::lock_guard lock(group.mutex);
    if (stoodApart) {
        group.rows[numberOf(row)] = far;
        return;
    }
    const auto number = static_cast<std::uint32_t>(group.rows.size());
    group.rows.push_back(far);
    row = {};
    row[0] = apart;
    row[1] = static_cast<std::int16_t>(number & 0xffff);
    row[2] = static_cast<std::int16_t>(number >> 16);
}

void NeighbourTable::renumber(std::span<const std::uint32_t> number, std::size_t left) {
    const auto before = std::exchange(m_apart, std::make_unique<Group[]>(base::chunkCount(left, groupSize)));
    for (std::uint32_t i = 0; i < number.size(); ++i) {
        const std::uint32_t to = number[i];
        if (to == gone)
            continue;
        Row renumbered = m_rows[i][0] == apart ? before[i / groupSize].rows[numberOf(m_rows[i])] : row(i);
        for (std::size_t k = 0; k < m_count; ++k)
            renumbered[k] = number[renumbered[k]] == gone ? to : number[renumbered[k]];
        m_rows[to] = {}; // it no longer stands apart, whatever was written there before
        set(to, std::span(renumbered).first(m_count));
    }
    m_rows.shrink(left);
}

NeighbourTable nearestTable(const Cloud& cloud, std::size_t count, const base::Progress& progress) {
    NeighbourTable out(cloud.size(), std::min(count, std::max<std::size_t>(cloud.size(), 1) - 1));
    if (out.count() > 0)
        cloud.forEachCell(out.count(), progress, "Linking neighbours", [&](const NearestRows& rows) {
            for (std::size_t r = 0; r < rows.count; ++r)
                out.set(rows.first + r, std::span(rows.index).subspan(r * rows.k, rows.k));
        });
    return out;
}

} // namespace process

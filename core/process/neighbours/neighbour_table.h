// The nearest neighbours of every position, kept: up to 12 in a row of 24 bytes.
//
// Along a curve neighbours have close numbers, so that a row holds differences of 16 bits. Where one does not fit, all
// of the row stands apart in 32 bits. Distances are not kept: they follow from the positions, to the bit.
// Different rows may be written on different threads; what is read does not depend on their order.
#pragma once

#include "core/base/large_array.h"
#include "core/process/neighbours/knn.h"

#include <array>
#include <memory>
#include <mutex>

namespace process {

class NeighbourTable {
  public:
    /// Two rings of a hexagonal layout have 18: the inner one and half the outer carry a slope in every direction.
    static constexpr std::size_t most = 12;
    using Row = std::array<std::uint32_t, most>;

    NeighbourTable() = default;
    NeighbourTable(std::size_t rows, std::size_t count);

    std::size_t size() const { return m_rows.size(); }
    /// Neighbours in a row.
    std::size_t count() const { return m_count; }

    /// REQUIRES: count() neighbours.
    void set(std::size_t i, std::span<const std::uint32_t> neighbours);
    /// When positions go: `number` has the new number of each, ascending, and `gone` for those; `left` are the others.
    /// Rows that name what went hold themselves in its place until they are set.
    void renumber(std::span<const std::uint32_t> number, std::size_t left);
    static constexpr std::uint32_t gone = ~std::uint32_t(0);
    /// The first count() are valid.
    Row row(std::size_t i) const {
        Row out;
        const Differences& row = m_rows[i];
        if (row[0] == apart) [[unlikely]]
            return m_apart[i / groupSize].rows[numberOf(row)];
        for (std::size_t k = 0; k < most; ++k)
            out[k] = static_cast<std::uint32_t>(static_cast<std::int64_t>(i) + row[k]);
        return out;
    }
    /// Whether j is among the `first` nearest of i. REQUIRES: first <= most.
    bool sees(std::size_t i, std::uint32_t j, std::size_t first = most) const {
        const Differences& row = m_rows[i];
        if (row[0] == apart) [[unlikely]] {
            const Row all = this->row(i);
            const auto end = all.begin() + static_cast<std::ptrdiff_t>(std::min(first, m_count));
            return std::find(all.begin(), end, j) != end;
        }
        const std::int64_t wanted = static_cast<std::int64_t>(j) - static_cast<std::int64_t>(i);
        const auto difference = static_cast<std::int16_t>(wanted);
        if (difference != wanted)
            return false;
        if (difference == 0) // what is not used holds 0 as well
            first = std::min(first, m_count);
        std::int16_t found = 0; // all are looked at, at once
        for (std::size_t k = 0; k < first; ++k)
            found |= static_cast<std::int16_t>(row[k] == difference);
        return found != 0;
    }

  private:
    using Differences = std::array<std::int16_t, most>;
    static constexpr std::int16_t apart = -0x8000; ///< in front of the number of a row that stands apart
    static constexpr std::size_t groupSize = 8192;
    struct Group {
        std::mutex mutex;
        std::vector<Row> rows;
    };
    static std::uint32_t numberOf(const Differences& row) {
        return static_cast<std::uint16_t>(row[1]) | static_cast<std::uint32_t>(static_cast<std::uint16_t>(row[2]))
                                                        << 16;
    }

    std::size_t m_count = 0;
    base::LargeArray<Differences> m_rows;
    std::unique_ptr<Group[]> m_apart;
};

/// The `count` nearest of every position; fewer where there are fewer. REQUIRES: at most NeighbourTable::most.
NeighbourTable nearestTable(const Cloud& cloud, std::size_t count, const base::Progress& progress = {});

} // namespace process

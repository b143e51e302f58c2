#include "core/process/neighbours/point_cells.h"

#include "core/base/parallel.h"

#include <algorithm>
#include <bit>

namespace process {

using base::Box3f;
using base::Vec3f;

CurveGrid::CurveGrid(const Box3f& box) : m_origin(box.lo) {
    const Vec3f size = box.size();
    const double edge = static_cast<double>(std::max({size.x, size.y, size.z}));
    m_scale = edge > 0 ? most / edge : 0;
}

namespace {

/// Cuts ranges in preorder.
class Cutter {
  public:
    Cutter(PointCells& out, std::span<const Vec3f> positions, const CurveGrid& grid)
        : m_out(out), m_positions(positions), m_grid(grid) {}

    void cut(std::uint32_t begin, std::uint32_t end) {
        const std::size_t node = m_out.nodes.size();
        m_out.nodes.push_back({{}, 0, PointCells::inner});
        if (end - begin <= PointCells::largest) {
            m_out.nodes[node].cell = static_cast<std::uint32_t>(m_out.begin.size());
            m_out.begin.push_back(begin);
        } else {
            const std::uint32_t middle = middleOf(begin, end);
            cut(begin, middle);
            cut(middle, end);
        }
        m_out.nodes[node].next = static_cast<std::uint32_t>(m_out.nodes.size());
    }

  private:
    /// Where the highest bit of the codes changes; half way in a cell of the grid.
    std::uint32_t middleOf(std::uint32_t begin, std::uint32_t end) const {
        const std::uint64_t first = m_grid.code(m_positions[begin]), last = m_grid.code(m_positions[end - 1]);
        if (first == last)
            return begin + (end - begin) / 2;
        const int bit = std::bit_width(first ^ last) - 1;
        const std::uint64_t least = last >> bit << bit;
        const auto range = m_positions.subspan(begin, end - begin);
        const auto at =
            std::partition_point(range.begin(), range.end(), [&](const Vec3f& p) { return m_grid.code(p) < least; });
        return begin + static_cast<std::uint32_t>(at - range.begin());
    }

    PointCells& m_out;
    std::span<const Vec3f> m_positions;
    const CurveGrid& m_grid;
};

} // namespace

PointCells::PointCells(std::span<const Vec3f> positions, const CurveGrid& grid) {
    if (positions.empty())
        return;
    Cutter(*this, positions, grid).cut(0, static_cast<std::uint32_t>(positions.size()));
    begin.push_back(static_cast<std::uint32_t>(positions.size()));
    firstCluster.push_back(0);
    for (std::size_t cell = 0; cell < count(); ++cell)
        firstCluster.push_back(firstCluster.back() + (size(cell) + clusterSize - 1) / clusterSize);
    clusterBoxes.resize(firstCluster.back());
    std::vector<Box3f> cells(count());
    base::parallelFor(count(), 256, [&](std::size_t cell) {
        for (std::uint32_t i = begin[cell], cluster = firstCluster[cell]; i < begin[cell + 1]; ++cluster) {
            Box3f& box = clusterBoxes[cluster];
            for (const std::uint32_t end = std::min(i + clusterSize, begin[cell + 1]); i < end; ++i)
                box.extend(positions[i]);
            cells[cell].extend(box);
        }
    });
    for (std::size_t n = nodes.size(); n-- > 0;) {
        Node& node = nodes[n];
        if (node.cell != inner) {
            node.box = cells[node.cell];
        } else {
            node.box = nodes[n + 1].box;
            node.box.extend(nodes[nodes[n + 1].next].box);
        }
    }
}

} // namespace process

// Positions along a Morton curve in cells of up to 128, with a tree of boxes above: what neighbours are searched in.
//
// Cells are cut where the highest bit of the curve's codes changes, so that none straddles a jump of the curve, however
// uneven the density; a cell is cut into clusters of up to 16 consecutive positions, each with its box. The tree's
// nodes stand in preorder: the first child behind its parent, the second where the first one's subtree ends.
#pragma once

#include "core/base/box.h"
#include "core/base/morton.h"

#include <cstdint>
#include <span>
#include <vector>

namespace process {

/// The cubic grid that codes are of: 2^21 - 1 cells along the longest side of a box.
class CurveGrid {
  public:
    CurveGrid() = default;
    explicit CurveGrid(const base::Box3f& box);
    /// REQUIRES: a position in the box.
    std::uint64_t code(const base::Vec3f& p) const {
        const base::Vec3d q = base::cast<double>(p - m_origin) * m_scale;
        return base::mortonCode(whole(q.x), whole(q.y), whole(q.z));
    }

  private:
    static constexpr double most = (1 << base::mortonBits) - 1; ///< the last cell along an axis
    static std::uint32_t whole(double v) { return static_cast<std::uint32_t>(std::clamp(v, 0.0, most)); }
    base::Vec3f m_origin;
    double m_scale = 0;
};

struct PointCells {
    static constexpr std::uint32_t largest = 128, clusterSize = 16;
    static constexpr std::uint32_t inner = ~std::uint32_t(0);

    struct Node {
        base::Box3f box;
        std::uint32_t next; ///< behind its subtree
        std::uint32_t cell; ///< `inner` where it has children
    };

    std::vector<std::uint32_t> begin;        ///< first position of each cell, and the number of positions
    std::vector<std::uint32_t> firstCluster; ///< of each cell, and the number of clusters
    std::vector<base::Box3f> clusterBoxes;
    std::vector<Node> nodes;

    PointCells() = default;
    /// REQUIRES: ascending by the grid's codes.
    PointCells(std::span<const base::Vec3f> positions, const CurveGrid& grid);

    std::size_t count() const { return begin.empty() ? 0 : begin.size() - 1; }
    std::uint32_t size(std::size_t cell) const { return begin[cell + 1] - begin[cell]; }
};

} // namespace process

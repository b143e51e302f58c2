// How sharp the border between two cells of one face is, from place to place (cells/README 1.4): by the share of links
// over it that a crease cuts.
#pragma once

#include "core/base/cells.h"

#include <cstdint>
#include <utility>
#include <vector>

namespace mesh {

/// Between samples of two cells, the smaller number first.
struct BorderLink {
    base::Vec3d middle;
    std::pair<std::uint32_t, std::uint32_t> cells;
    bool cut = false;
};

class FadingBorders {
  public:
    FadingBorders(const std::vector<BorderLink>& links, double support);

    /// 0 smooth to 255 sharp; smooth where no link is near.
    std::uint8_t sharpness(std::uint32_t a, std::uint32_t b, const base::Vec3d& place) const;

  private:
    double m_reach;
    base::CellMap<std::vector<BorderLink>> m_links;
};

} // namespace mesh

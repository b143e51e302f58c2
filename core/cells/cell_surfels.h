// The surfels that may have weight somewhere in a box, by cell and then in the order of the tree, as floats beside each
// other: what neighbouring CellClusters are chosen from, so that the tree is asked once for many of them.
#pragma once

#include "core/cells/cell_surface.h"

#include <vector>

namespace cells {

class CellSurfels {
  public:
    CellSurfels(const CellSurface& surface, const base::Box3f& box);

    /// Numbers, ascending, of those that may have weight somewhere in a box. REQUIRES: it lies in this one's.
    void inSupport(const base::Box3f& box, std::vector<std::uint32_t>& out) const;

    const Label& label(std::uint32_t i) const { return m_labels[i]; }
    base::Vec3f position(std::uint32_t i) const { return {at(surfel::X, i), at(surfel::Y, i), at(surfel::Z, i)}; }
    /// As in blocks; zero for balls.
    base::Vec3f shape(std::uint32_t i) const {
        return m_shape > 0 ? base::Vec3f{at(m_shape, i), at(m_shape + 1, i), at(m_shape + 2, i)} : base::Vec3f();
    }
    /// Scaled.
    float support(std::uint32_t i) const { return m_scale * at(surfel::Support, i); }

    /// Channels of a cluster that is packed of them, as in blocks.
    std::size_t channels() const { return m_channels; }
    /// To a lane of such a cluster: its x.
    void copy(std::uint32_t i, float* to) const;

  private:
    float at(int channel, std::uint32_t i) const { return m_values[static_cast<std::size_t>(channel) * m_stride + i]; }

    int m_shape;            ///< channel of shapes; 0: none
    std::size_t m_channels; ///< of a cluster
    float m_scale, m_reach; ///< of supports: for weights; for queries
    std::size_t m_stride = 0;
    std::vector<float> m_values; ///< channel by channel, each to a whole cluster; the rest has no support
    std::vector<Label> m_labels;
};

} // namespace cells

// The surfels that may have weight somewhere in a box, packed as clusters of one cell each, so that the vectorised sums
// run over a cell alone (cells/README 4.1). They are chosen from those of a wider box (cell_surfels.h); what is packed,
// and in which order, depends on the smaller box only.
#pragma once

#include "core/cells/cell_surfels.h"
#include "core/surface/evaluation/clusters.h"

#include <vector>

namespace cells {

class CellClusters {
  public:
    /// REQUIRES: `box` lies in that of `from`.
    CellClusters(const CellSurfels& from, const base::Box3f& box);

    struct Cell {
        std::uint32_t cell = 0, face = 0;
        std::uint32_t begin = 0, end = 0; ///< its clusters
        bool joined = false;              ///< others are of its face: where they do not meet they are smooth to it
    };
    /// A surfel beside a crease.
    struct Beside {
        base::Vec3f position, shape;
        float support;              ///< scaled
        std::uint32_t own, partner; ///< places among the cells; beyond them where the partner has no surfels here
        Label label;
    };

    /// Surfels beside the crease of two cells, packed with its sharpness in place of the normal's x.
    struct Fade {
        std::uint32_t a = 0, b = 0; ///< places among the cells, a < b
        std::uint32_t begin = 0, end = 0;
    };

    /// By ascending label.
    std::span<const Cell> cells() const { return m_cells; }
    std::span<const Beside> beside() const { return m_beside; }
    /// Of the creases that are not quite sharp.
    std::span<const Fade> fades() const { return m_fades; }
    /// Of a cell, or a crease that fades.
    template <class Of>
    surface::ClusterSpan clusters(const Of& of) const {
        return surface::ClusterSpan(m_pointers).subspan(of.begin, of.end - of.begin);
    }

  private:
    struct alignas(64) Channel {
        float lanes[surfel::clusterSize];
    };
    using Chosen = std::span<const std::uint32_t>; ///< of a CellSurfels
    void pack(const CellSurfels& from, Chosen chosen);
    void packFades(const CellSurfels& from, Chosen chosen);
    std::uint32_t place(std::uint32_t label) const;
    /// Room for one more surfel in the last cluster, or in a fresh one: its x; further channels follow a cluster's
    /// width after each other.
    float* nextLane(bool fresh);
    std::uint32_t clusterCount() const { return static_cast<std::uint32_t>(m_packed.size() / m_channels); }

    std::size_t m_channels; ///< of a cluster
    std::vector<Channel> m_packed;
    std::vector<const float*> m_pointers;
    std::vector<Cell> m_cells;
    std::vector<Beside> m_beside;
    std::vector<Fade> m_fades;
    int m_lane = surfel::clusterSize; ///< the next one of the last cluster
};

} // namespace cells
